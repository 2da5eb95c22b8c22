// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/decimation.h"
#include "ui/charts/time_chart.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace fulcrum::ui {
namespace {

struct Series {
    std::vector<double> x;
    std::vector<float> y;
};

Series noise(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal(0.0F, 1.0F);
    Series series;
    for (std::size_t i = 0; i < count; ++i) {
        series.x.push_back(static_cast<double>(i) * 1e-3);
        series.y.push_back(normal(random));
    }
    return series;
}

bool holds(const std::vector<ChartPoint>& points, double x, double y) {
    return std::any_of(points.begin(), points.end(),
                       [&](const ChartPoint& point) { return point.x == x && point.y == y; });
}

TEST(Decimation, KeepsASingleSampleOfPeakInAnHour) {
    Series series = noise(3'600'000, 1);
    series.y[2'345'678] = 40.0F;
    series.y[777'777] = -35.0F;
    const MinMaxPyramid pyramid(series.x, series.y);
    const std::vector<ChartPoint> points = pyramid.view(0, 3600);
    EXPECT_LE(points.size(), chart_point_limit);
    EXPECT_GT(points.size(), chart_point_limit / 4);
    EXPECT_TRUE(holds(points, series.x[2'345'678], 40.0));
    EXPECT_TRUE(holds(points, series.x[777'777], -35.0));
    EXPECT_EQ(pyramid.highest(), 40.0);
    EXPECT_EQ(pyramid.lowest(), -35.0);
}

TEST(Decimation, ShowsEverySampleOfAShortView) {
    const Series series = noise(100'000, 2);
    const MinMaxPyramid pyramid(series.x, series.y);
    const std::vector<ChartPoint> points = pyramid.view(50.0, 51.0);
    // 1001 samples of the view and one beyond each end.
    ASSERT_EQ(points.size(), 1003U);
    EXPECT_EQ(points[1].y, static_cast<double>(series.y[50'000]));
}

TEST(Decimation, IncreasesInTimeKeepsExtremesAndStaysWithinTheLimitForAnyView) {
    rc::check([] {
        const auto count = *rc::gen::inRange<std::size_t>(1, 60'000);
        const Series series = noise(count, *rc::gen::arbitrary<unsigned>());
        const MinMaxPyramid pyramid(series.x, series.y);
        const double last = series.x.back();
        double from = *rc::gen::inRange(0, 1000) * 1e-3 * last, to = *rc::gen::inRange(0, 1000) * 1e-3 * last;
        if (from > to) std::swap(from, to);
        const auto limit = *rc::gen::inRange<std::size_t>(5, 5000);
        const std::vector<ChartPoint> points = pyramid.view(from, to, limit);
        RC_ASSERT(points.size() <= std::max<std::size_t>(limit, 3));
        for (std::size_t i = 1; i < points.size(); ++i) RC_ASSERT(points[i].x > points[i - 1].x);
        float high = -std::numeric_limits<float>::infinity(), low = -high;
        for (std::size_t i = 0; i < count; ++i) {
            if (series.x[i] < from || series.x[i] > to) continue;
            high = std::max(high, series.y[i]);
            low = std::min(low, series.y[i]);
        }
        if (!std::isfinite(high)) return;
        double drawn_high = -1e9, drawn_low = 1e9;
        for (const ChartPoint& point : points) {
            drawn_high = std::max(drawn_high, point.y);
            drawn_low = std::min(drawn_low, point.y);
        }
        RC_ASSERT(drawn_high >= static_cast<double>(high));
        RC_ASSERT(drawn_low <= static_cast<double>(low));
    });
}

TEST(Decimation, OmitsValuesThatAreNotNumbers) {
    Series series = noise(10'000, 3);
    series.y[5000] = std::numeric_limits<float>::quiet_NaN();
    series.y[6000] = std::numeric_limits<float>::infinity();
    const MinMaxPyramid pyramid(series.x, series.y);
    EXPECT_EQ(pyramid.size(), 9998U);
    EXPECT_TRUE(std::isfinite(pyramid.highest()));
}

TEST(Decimation, GivesTheValueAtATime) {
    const MinMaxPyramid pyramid({0.0, 1.0, 2.0}, {5.0F, 6.0F, 7.0F});
    EXPECT_EQ(pyramid.value_at(-1), 0.0);
    EXPECT_EQ(pyramid.value_at(0.5), 5.0);
    EXPECT_EQ(pyramid.value_at(1.0), 6.0);
    EXPECT_EQ(pyramid.value_at(99), 7.0);
    EXPECT_EQ(MinMaxPyramid().value_at(1), 0.0);
    EXPECT_TRUE(MinMaxPyramid().view(0, 1).empty());
}

TEST(Decimation, HasNoValueWhereValuesWereLeftOut) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    const MinMaxPyramid pyramid({0, 1, 2, 3, 4, 5, 6}, {none, 5, none, none, 7, 8, none});
    EXPECT_EQ(pyramid.size(), 3U);
    for (const double x : {0.0, 0.5, 1.01, 2.0, 3.99, 5.01, 6.0}) EXPECT_FALSE(pyramid.at(x)) << x;
    EXPECT_EQ(pyramid.at(1), 5.0);
    EXPECT_EQ(pyramid.at(4), 7.0);
    EXPECT_EQ(pyramid.at(4.5), 7.0) << "between two samples the earlier one holds";
    EXPECT_EQ(pyramid.at(5), 8.0);
    const MinMaxPyramid moved = pyramid.moved([](double x) { return 10 * x; });
    EXPECT_FALSE(moved.at(20));
    EXPECT_EQ(moved.at(40), 7.0);
    const MinMaxPyramid part =
        pyramid.moved([](double x) { return x < 5 ? std::optional<double>(x) : std::nullopt; });
    EXPECT_EQ(part.size(), 2U);
    EXPECT_EQ(part.highest(), 7.0);
    EXPECT_EQ(part.last_x(), 4.0);
    EXPECT_FALSE(part.at(2));
    EXPECT_FALSE(MinMaxPyramid().at(0));
}

TEST(Decimation, DividesItsPointsAtEachGapWhateverTheView) {
    Series series = noise(200'000, 4);
    const std::vector<std::size_t> begins{50'000, 50'003, 120'000};
    for (std::size_t i = 120'000; i < series.x.size(); ++i) series.x[i] += 30;  // s
    series.y[80'000] = 40.0F;                                                   // next to a gap
    for (std::size_t i = 80'001; i < 90'000; ++i) series.y[i] = std::numeric_limits<float>::quiet_NaN();
    const MinMaxPyramid pyramid(series.x, series.y, begins);
    using Ends = std::vector<std::pair<double, double>>;
    const Ends gaps{{49.999, 50.0}, {50.002, 50.003}, {80.0, 90.0}, {119.999, 150.0}};
    for (const auto& [from, to] : Ends{{0, 250}, {40, 60}, {49.99, 50.01}, {85, 170}}) {
        const std::vector<ChartPoint> points = pyramid.view(from, to);
        const std::vector<ChartLine> lines = pyramid.lines(from, to);
        std::size_t count = 0;
        for (const ChartLine& line : lines) {
            ASSERT_FALSE(line.points.empty());
            EXPECT_EQ(line.gap.has_value(), &line != &lines.front());
            if (line.gap) {
                EXPECT_FALSE(pyramid.at(*line.gap)) << *line.gap;
                EXPECT_LT(*line.gap, line.points.front().x);
            }
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                const double before = line.points[i - 1].x, after = line.points[i].x;
                for (const auto& [end, begin] : gaps)
                    EXPECT_FALSE(before <= end + 1e-9 && after >= begin - 1e-9) << before << " to " << after;
            }
            count += line.points.size();
        }
        EXPECT_EQ(count, points.size()) << "the same points";
    }
    EXPECT_NEAR(pyramid.lines(0, 250).front().points.front().x, 0.0, 0.1);
    EXPECT_TRUE(holds(pyramid.view(0, 250), series.x[80'000], 40.0));
    EXPECT_EQ(pyramid.lines(49.99, 50.01).size(), 3U);
    EXPECT_EQ(pyramid.moved([](double x) { return 2 * x; }).lines(0, 500).size(),
              pyramid.lines(0, 250).size());
    EXPECT_TRUE(MinMaxPyramid().lines(0, 1).empty());
}

TEST(TimeAxis, HasTicksThatItsLabelsShowExactly) {
    EXPECT_DOUBLE_EQ(tick_interval(30), 5);
    EXPECT_DOUBLE_EQ(tick_interval(80), 10);
    EXPECT_DOUBLE_EQ(tick_interval(3600), 500);
    EXPECT_DOUBLE_EQ(tick_interval(0.05), 0.01);
    for (double span = 0.05; span < 20000; span *= 1.07) {
        const double interval = tick_interval(span);
        EXPECT_LE(span / interval, 8 + 1e-6) << span;
        EXPECT_GE(span / interval, 3) << span;
        // With the axis's number of decimals each label gives its tick exactly.
        const double unit = interval < 0.1 ? 0.01 : interval < 1 ? 0.1 : 1;
        EXPECT_NEAR(interval / unit, std::round(interval / unit), 1e-9) << span;
    }
}

}  // namespace
}  // namespace fulcrum::ui
