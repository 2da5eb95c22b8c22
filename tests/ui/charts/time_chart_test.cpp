// SPDX-License-Identifier: GPL-3.0-or-later
// The chart of a long record: as many points as its width can show, every peak among them.
#include <gtest/gtest.h>

#include <QChart>
#include <QXYSeries>
#include <cmath>

#include "ui/charts/time_chart.h"

namespace fulcrum::ui {
namespace {

/// 500 s at 1 kHz, a ripple with one outlier.
std::shared_ptr<const MinMaxPyramid> record_with_a_peak() {
    std::vector<double> x;
    std::vector<float> y;
    for (int i = 0; i < 500000; ++i) {
        x.push_back(i * 1e-3);
        y.push_back(i == 333333 ? 9.0F : static_cast<float>(1 + std::sin(0.05 * i)));
    }
    return std::make_shared<MinMaxPyramid>(std::move(x), std::move(y));
}

struct Shown {
    int points = 0;
    double highest = 0, first = 0, last = 0;
};

Shown shown(const TimeChart& chart) {
    const auto* line = static_cast<QtCharts::QXYSeries*>(chart.chart()->series().front());
    Shown result;
    result.points = line->count();
    for (const QPointF& point : line->points()) result.highest = std::max(result.highest, point.y());
    if (result.points > 0) {
        result.first = line->at(0).x();
        result.last = line->at(result.points - 1).x();
    }
    return result;
}

TEST(TimeChart, ShowsAsManyPointsAsItsWidthHoldsAndEveryPeak) {
    TimeChart chart("force (N)");
    chart.resize(500, 300);
    chart.grab();  // laid out
    chart.add_series("left", &Palette::left_hand, Qt::SolidLine, record_with_a_peak());
    chart.show_all();
    const Shown narrow = shown(chart);
    EXPECT_GT(narrow.points, 500);
    EXPECT_LE(narrow.points, 1502);
    EXPECT_EQ(narrow.highest, 9);
    const double bucket = 500.0 / 400;  // s, wider than any bucket: the last bucket extends to the border
    EXPECT_LT(narrow.first, bucket);
    EXPECT_GT(narrow.last, 499.999 - bucket);
    for (const double span : {250.0, 100.0, 20.0, 2.0, 0.1}) {
        chart.show_range(333.333 - 0.4 * span, 333.333 + 0.6 * span);
        const Shown view = shown(chart);
        EXPECT_EQ(view.highest, 9) << span;
        EXPECT_LE(view.points, 1502) << span;
        EXPECT_LE(view.first, 333.333 - 0.4 * span);
        EXPECT_GE(view.last, 333.333 + 0.6 * span);
    }
    chart.show_range(0, 100);
    EXPECT_LT(shown(chart).highest, 2.1) << "the points of the view before are gone";
    chart.resize(1600, 300);
    chart.grab();
    chart.show_all();
    EXPECT_GT(shown(chart).points, 2 * narrow.points);
    EXPECT_LE(shown(chart).points, static_cast<int>(chart_point_limit));
}

TEST(TimeChart, ShowsEverySampleBeforeItsFirstLayoutAndWithoutSamples) {
    TimeChart chart("force (N)");
    chart.add_series("left", &Palette::left_hand, Qt::SolidLine, std::make_shared<MinMaxPyramid>());
    chart.show_all();
    EXPECT_EQ(shown(chart).points, 0);
    chart.clear();
    chart.add_series("left", &Palette::left_hand, Qt::SolidLine, record_with_a_peak());
    chart.show_all();
    chart.show_range(333.0, 333.5);
    EXPECT_GE(shown(chart).points, 500);
    EXPECT_EQ(shown(chart).highest, 9);
}

}  // namespace
}  // namespace fulcrum::ui
