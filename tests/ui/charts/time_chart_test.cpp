// SPDX-License-Identifier: GPL-3.0-or-later
// The chart of a long record: as many points as its width can show, every peak among them.
#include <gtest/gtest.h>

#include <QChart>
#include <QLegend>
#include <QLegendMarker>
#include <QPainter>
#include <QToolTip>
#include <QValueAxis>
#include <QXYSeries>
#include <QtTest>
#include <cmath>
#include <cstdlib>

#include "tests/ui/heard.h"
#include "tests/ui/painted_words.h"
#include "ui/charts/time_charts.h"

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
    Shown result;
    for (const ChartLine& line : chart.lines_of(0)) {
        for (const ChartPoint& point : line.points) {
            if (result.points++ == 0) result.first = point.x;
            result.last = point.x;
            result.highest = std::max(result.highest, point.y);
        }
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

TEST(TimeChart, BeginsWhereTheRecordBegins) {
    TimeChart chart("force (N)");
    chart.add_series(
        "left", &Palette::left_hand, Qt::SolidLine,
        std::make_shared<MinMaxPyramid>(std::vector<double>{300.001, 310, 320}, std::vector<float>{1, 2, 1}));
    chart.set_extent(300, 320);
    chart.show_all();
    EXPECT_DOUBLE_EQ(chart.first_shown(), 300);
    EXPECT_DOUBLE_EQ(chart.last_shown(), 320);
    chart.show_range(0, 10);
    EXPECT_DOUBLE_EQ(chart.first_shown(), 300) << "there is nothing before";
    chart.clear();
    chart.show_all();
    EXPECT_DOUBLE_EQ(chart.first_shown(), 0);
}

/// Pixels of the plot in this colour, in the columns between two times.
int pixels_of(TimeChart& chart, const QColor& colour, double from, double to) {
    const QImage image = chart.grab().toImage();
    const QRectF plot = chart.chart()->plotArea();
    const double span = chart.last_shown() - chart.first_shown(), ratio = image.devicePixelRatio();
    const auto column = [&](double time) {
        return static_cast<int>((plot.left() + plot.width() * (time - chart.first_shown()) / span) * ratio);
    };
    int found = 0;
    for (int x = column(from); x < column(to); ++x) {
        for (int y = static_cast<int>(plot.top() * ratio); y < static_cast<int>(plot.bottom() * ratio); ++y) {
            const QColor here = image.pixelColor(x, y);
            const int difference = std::abs(here.red() - colour.red()) +
                                   std::abs(here.green() - colour.green()) +
                                   std::abs(here.blue() - colour.blue());
            found += difference < 150 ? 1 : 0;  // a thin line covers its pixels in part
        }
    }
    return found;
}

TEST(TimeChart, DrawsNoLineAcrossAGap) {
    std::vector<double> x;
    std::vector<float> y;
    for (int i = 0; i < 20000; ++i) {
        x.push_back(i < 10000 ? i * 1e-3 : 5 + i * 1e-3);  // nothing from 10 to 15 s
        y.push_back(i > 4000 && i < 6000 ? std::nanf("") : 3.0F);
    }
    TimeChart chart("force (N)");
    chart.resize(600, 300);
    chart.add_series("left", &Palette::left_hand, Qt::SolidLine,
                     std::make_shared<MinMaxPyramid>(x, y, std::vector<std::size_t>{10000}));
    chart.show_all();
    chart.grab();  // laid out
    chart.show_all();
    EXPECT_EQ(chart.lines_of(0).size(), 3U);
    const QColor colour = colours().left_hand;
    for (const double drawn : {1.0, 7.0, 20.0}) EXPECT_GT(pixels_of(chart, colour, drawn, drawn + 1), 5);
    EXPECT_EQ(pixels_of(chart, colour, 4.4, 5.6), 0) << "values that were left out";
    EXPECT_EQ(pixels_of(chart, colour, 10.4, 14.6), 0) << "a gap of the record";
    EXPECT_FALSE(chart.chart()->legend()->markers().isEmpty());
    // In view alone: nothing; one sample alone between two gaps is a dot.
    chart.show_range(11, 14);
    EXPECT_EQ(pixels_of(chart, colour, 11, 14), 0);
    chart.clear();
    chart.add_series(
        "left", &Palette::left_hand, Qt::SolidLine,
        std::make_shared<MinMaxPyramid>(std::vector<double>{0, 1, 2, 3, 4},
                                        std::vector<float>{3, std::nanf(""), 3, std::nanf(""), 3}));
    chart.show_all();
    EXPECT_EQ(chart.lines_of(0).size(), 3U);
    EXPECT_GT(pixels_of(chart, colour, 1.8, 2.2), 0);
    EXPECT_EQ(pixels_of(chart, colour, 0.5, 1.5), 0);
}

TEST(TimeChart, ABandEndsWhereItHasNoValues) {
    TimeChart chart("force (N)");
    chart.resize(600, 300);
    chart.add_band("cohort", &Palette::limit,
                   {{0.5, 1, 2, 3}, {1.5, 1, 2, 3}, {2.5, 1, 2, 3}, {6.5, 5, 6, 7}, {7.5, 5, 6, 7}});
    chart.show_all();
    const auto middle_at = [&chart](double time) {
        std::vector<ChartCell> cells;
        chart.add_values(time, cells);
        return cells.at(1).copied;
    };
    EXPECT_EQ(middle_at(2), "2");
    EXPECT_EQ(middle_at(4), "") << "fewer people have come so far";
    EXPECT_EQ(middle_at(7), "6");
    EXPECT_EQ(chart.chart()->series().size(), 4) << "an area and a middle line on each side";
    chart.show_names(true);
    chart.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&chart));
    int named = 0;
    for (const QtCharts::QLegendMarker* marker : chart.chart()->legend()->markers())
        named += marker->isVisible() ? 1 : 0;
    EXPECT_EQ(named, 1);
    chart.clear();
    EXPECT_TRUE(chart.chart()->series().isEmpty());
}

QStringList painted_words(TimeChart& chart) {
    window_test::WordsDevice device(chart.size());
    QPainter painter(&device);
    chart.render(&painter);
    painter.end();
    QStringList words;
    for (const window_test::PaintedWords& one : device.words()) words << one.words.trimmed();
    return words;
}

TEST(TimeChart, LowOneHasFewerLabelsAndCutsNoneOff) {
    TimeChart chart("force (N)");
    chart.show_names(false);
    chart.set_compact(50);
    chart.show_time_axis(false);
    chart.add_series("left", &Palette::left_hand, Qt::SolidLine, record_with_a_peak());
    for (const int lines : {3, 5, 8, 20}) {
        chart.resize(300, lines * chart.fontMetrics().height());
        chart.grab();
        chart.show_all();
        chart.grab();
        const QStringList words = painted_words(chart), few{"0", "15"}, all{"0", "5", "10", "15"};
        for (const QString& label : lines < 5 ? few : all)
            EXPECT_EQ(words.count(label), 1) << lines << ": " << words.join("|").toStdString();
        EXPECT_EQ(words.count("5"), lines < 5 ? 0 : 1) << lines;
        EXPECT_TRUE(words.filter("...").isEmpty()) << lines << ": " << words.join("|").toStdString();
    }
}

TEST(TimeChart, LabelsTheTruePeakOfWhatIsInView) {
    TimeChart chart("force (N)");
    chart.resize(500, 300);
    chart.grab();
    chart.set_unit("N");
    chart.show_peaks(true);
    chart.add_series("left hand", &Palette::left_hand, Qt::SolidLine, record_with_a_peak());
    chart.show_all();
    const auto painted = [&] { return painted_words(chart); };
    const QString label = QStringLiteral("9%1N").arg(QChar(0x202F));
    ASSERT_TRUE(chart.peak_of(0));
    EXPECT_DOUBLE_EQ(chart.peak_of(0)->y, 9);
    EXPECT_DOUBLE_EQ(chart.peak_of(0)->x, 333.333);
    EXPECT_EQ(painted().count(label), 1) << painted().join("|").toStdString();
    EXPECT_TRUE(chart.accessibleDescription().contains(label)) << chart.accessibleDescription().toStdString();
    // The outlier is one sample beyond the view: the peak is that of the view.
    chart.show_range(300, 333.332);
    ASSERT_TRUE(chart.peak_of(0));
    EXPECT_LT(chart.peak_of(0)->y, 2.1);
    EXPECT_EQ(painted().count(label), 0);
    chart.show_peaks(false);
    chart.show_all();
    EXPECT_EQ(painted().count(label), 0);
    EXPECT_TRUE(chart.accessibleDescription().isEmpty()) << chart.accessibleDescription().toStdString();
}

TEST(TimeChart, KeysAreNamedAndGoFromMarkToMarkAndTheViewFollows) {
    TimeChart chart("force (N)");
    chart.resize(500, 300);
    chart.add_series("left", &Palette::left_hand, Qt::SolidLine, record_with_a_peak());
    chart.set_marks({{300, "Slipped. struck by Ed Educator: seen before"}, {100, "Bled"}, {300, "Dropped"}});
    chart.show_all();
    chart.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&chart));
    for (const char* key : {"←", "Page Down", "+", "0"}) EXPECT_TRUE(chart.toolTip().contains(key)) << key;
    // As the page does that the chart is on.
    QObject::connect(&chart, &TimeChart::time_chosen, &chart, &TimeChart::set_cursor);
    const window_test::Heard heard;
    QTest::keyClick(&chart, Qt::Key_PageDown);
    EXPECT_EQ(chart.cursor(), 100);
    chart.show_range(90, 110);
    QTest::keyClick(&chart, Qt::Key_PageDown);
    EXPECT_EQ(chart.cursor(), 300);
    EXPECT_TRUE(chart.first_shown() < 300 && chart.last_shown() > 300) << chart.first_shown();
    EXPECT_EQ(
        window_test::Heard::lines(),
        (QStringList{"100.00 s: Bled", "300.00 s: Slipped. struck by Ed Educator: seen before; Dropped"}));
    EXPECT_EQ(QToolTip::text(), window_test::Heard::lines()[1]);
    QTest::keyClick(&chart, Qt::Key_PageDown);
    EXPECT_EQ(chart.cursor(), 300) << "the last one";
    QTest::keyClick(&chart, Qt::Key_PageUp);
    EXPECT_EQ(chart.cursor(), 100);
}

TEST(TimeChart, IsNotLaidOutAgainForAMoveAlongItsAxis) {
    TimeChart chart("force (N)");
    chart.resize(500, 300);
    chart.add_series("left", &Palette::left_hand, Qt::SolidLine, record_with_a_peak());
    chart.show_all();
    chart.show_range(100, 120);
    auto* axis = static_cast<QtCharts::QValueAxis*>(chart.chart()->axes(Qt::Horizontal).front());
    QSignalSpy formats(axis, &QtCharts::QValueAxis::labelFormatChanged);
    for (int i = 0; i < 10; ++i) chart.show_range(101 + i, 121 + i);
    EXPECT_EQ(formats.count(), 0);
    chart.show_range(100, 101);
    EXPECT_EQ(formats.count(), 1) << "the ticks need a decimal";
}

TEST(TimeCharts, ZoomTogetherAndTheirTableChangesOnce) {
    TimeCharts charts("all");
    auto* force = new TimeChart("force (N)");
    auto* speed = new TimeChart("speed (mm/s)");
    charts.add(force, "force");
    charts.add(speed, "speed");
    for (TimeChart* chart : {force, speed})
        chart->add_series("left", &Palette::left_hand, Qt::SolidLine, record_with_a_peak());
    int changes = 0;
    charts.when_changed([&] { ++changes; });
    charts.zoom_to(0, 0);
    EXPECT_EQ(changes, 1);
    EXPECT_EQ(speed->last_shown(), force->last_shown());
    charts.zoom_to(333, 334);
    EXPECT_EQ(changes, 2);
    for (const TimeChart* chart : {force, speed}) {
        EXPECT_EQ(chart->first_shown(), 333);
        ASSERT_TRUE(chart->peak_of(0).has_value());
        EXPECT_EQ(chart->peak_of(0)->y, 9) << "the true peak";
    }
    QTest::keyClick(speed, Qt::Key_Minus);
    EXPECT_GT(speed->last_shown() - speed->first_shown(), 1);
    EXPECT_EQ(force->first_shown(), speed->first_shown());
    EXPECT_EQ(force->last_shown(), speed->last_shown());
    EXPECT_EQ(changes, 4) << "the chart itself, and all others";
}

TEST(TimeCharts, ShareOneTableOfWhatTheyDraw) {
    TimeCharts charts("Force and speed");
    auto* force = new TimeChart("force (N)");
    auto* speed = new TimeChart("mm/s");
    force->set_unit("N");
    speed->set_unit("mm/s");
    charts.add(force, "force");
    charts.add(speed, "speed");
    charts.resize(500, 500);
    charts.grab();
    EXPECT_TRUE(charts.table().rows.empty());
    force->add_series("left hand", &Palette::left_hand, Qt::SolidLine, record_with_a_peak());
    speed->add_series(
        "left hand", &Palette::left_hand, Qt::SolidLine,
        std::make_shared<MinMaxPyramid>(std::vector<double>{0, 333.3333, 400}, std::vector<float>{1, 5, 2}));
    force->add_band("cohort", &Palette::limit, {{0, 1, 2, 3}, {400, 5, 6, 7}});
    int changes = 0;
    charts.when_changed([&changes] { ++changes; });
    force->show_all();
    speed->show_all();
    EXPECT_GT(changes, 0);
    const ChartTable table = charts.table();
    ASSERT_EQ(table.columns.size(), 1U + 4 + 1);
    EXPECT_EQ(column_title(table.columns[0]), "Time (s)");
    EXPECT_EQ(column_title(table.columns[1]), "force, left hand (N)");
    EXPECT_EQ(column_title(table.columns[3]), "force, cohort, middle (N)");
    EXPECT_EQ(column_title(table.columns[5]), "speed, left hand (mm/s)");
    bool peak = false;
    double before = -1;
    for (const ChartRow& row : table.rows) {
        ASSERT_EQ(row.cells.size(), table.columns.size());
        const double time = std::stod(row.cells[0].copied);
        EXPECT_GT(time, before);
        before = time;
        peak = peak || row.cells[1].copied == "9";
        if (time == 200) {
            EXPECT_NEAR(std::stod(row.cells[3].copied), 4, 1e-9) << "half way along the band";
        }
        if (time > 400) {
            EXPECT_EQ(row.cells[3].copied, "") << "the band has ended";
            EXPECT_EQ(row.cells[5].copied, "") << "and the speed";
        }
    }
    EXPECT_TRUE(peak) << "the peak is among the rows";
    EXPECT_LT(table.rows.size(), 2 * chart_point_limit);
    // Zoomed in one, moved in both.
    emit force->range_changed(100, 101);
    EXPECT_NEAR(speed->first_shown(), 100, 1e-9);
}

TEST(TimeCharts, TheirTableHasNoValueWhereNoneWasMeasured) {
    TimeCharts charts("Force and speed");
    auto* force = new TimeChart("force (N)");
    auto* speed = new TimeChart("mm/s");
    charts.add(force, "force");
    charts.add(speed, "speed");
    charts.resize(500, 500);
    charts.grab();
    const float none = std::nanf("");
    force->add_series("left hand", &Palette::left_hand, Qt::SolidLine,
                      std::make_shared<MinMaxPyramid>(std::vector<double>{0, 0.5, 1, 1.5, 2, 2.5, 3},
                                                      std::vector<float>{1, 1, 1, 1, 1, 1, 1}));
    speed->add_series("left hand", &Palette::left_hand, Qt::SolidLine,
                      std::make_shared<MinMaxPyramid>(std::vector<double>{0, 1, 2, 3},
                                                      std::vector<float>{5, none, none, 7}));
    force->show_all();
    speed->show_all();
    QStringList speeds;
    for (const ChartRow& row : charts.table().rows) speeds << QString::fromStdString(row.cells.at(2).copied);
    EXPECT_EQ(speeds, (QStringList{"5", "", "", "", "", "", "7"})) << speeds.join("|").toStdString();
}

TEST(TimeCharts, TheirTableHasARowWithoutValuesInAGapOfTheRecord) {
    TimeCharts charts("Force and speed");
    auto* force = new TimeChart("force (N)");
    charts.add(force, "force");
    charts.resize(500, 500);
    charts.grab();
    force->add_series(
        "left hand", &Palette::left_hand, Qt::SolidLine,
        std::make_shared<MinMaxPyramid>(std::vector<double>{0, 1, 5, 6}, std::vector<float>{1, 2, 3, 4},
                                        std::vector<std::size_t>{2}));
    force->show_all();
    QStringList rows;
    for (const ChartRow& row : charts.table().rows)
        rows << QString::fromStdString(row.cells.at(0).copied + ":" + row.cells.at(1).copied);
    EXPECT_EQ(rows, (QStringList{"0:1", "1:2", "3:", "5:3", "6:4"})) << rows.join("|").toStdString();
}

}  // namespace
}  // namespace fulcrum::ui
