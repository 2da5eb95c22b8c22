// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a comparison by itself: which of two values is better, and when neither is.
#include "ui/review/comparison_table.h"

#include <gtest/gtest.h>

#include <QTableWidget>

namespace fulcrum::ui::window_test {
namespace {

TEST(ComparedMetrics, OfAMetricWithASignTheSizeSaysWhichIsBetter) {
    const auto side = [](double value) {
        ComparedMetric metric;
        metric.id = "plane_dev_median";
        metric.unit = "mm";
        metric.direction = Direction::lower;
        metric.value = value;
        return std::vector<ComparedMetric>{metric};
    };
    ComparisonTable shown;
    const auto* table = shown.findChild<QTableWidget*>(QStringLiteral("comparison_table"));
    ASSERT_NE(table, nullptr);
    const auto verdict_of_pair = [&](double own, double other) {
        shown.show_pair(side(own), side(other));
        return table->item(0, 5)->text();
    };
    EXPECT_TRUE(verdict_of_pair(-3.0, 0.2).contains("worse"));
    EXPECT_TRUE(verdict_of_pair(0.2, -3.0).contains("better"));
    EXPECT_EQ(verdict_of_pair(-3.0, 3.0), QStringLiteral("–"));
    EXPECT_TRUE(verdict_of_pair(1.0, 3.0).contains("better"));
    Spread cohort;
    cohort.low = -0.5;
    cohort.middle = 0.2;
    cohort.high = 0.5;
    MetricSpreads spreads;
    spreads[{"plane_dev_median", ""}] = cohort;
    shown.show_cohort(side(-3.0), spreads);
    EXPECT_TRUE(table->item(0, 5)->text().contains("worse"));
}

TEST(ComparedMetrics, OfTwoVersionsNeitherIsBetter) {
    const auto side = [](double value, int version) {
        ComparedMetric metric;
        metric.id = "energy_safe";
        metric.version = version;
        metric.unit = "%";
        metric.direction = Direction::higher;
        metric.value = value;
        return std::vector<ComparedMetric>{metric};
    };
    ComparisonTable shown;
    const auto* table = shown.findChild<QTableWidget*>(QStringLiteral("comparison_table"));
    ASSERT_NE(table, nullptr);
    const auto cell = [&](int column) { return table->item(0, column)->text(); };
    shown.show_pair(side(67, 3), side(93, 2));
    EXPECT_TRUE(cell(2).startsWith("67"));
    EXPECT_TRUE(cell(3).startsWith("93"));
    EXPECT_EQ(cell(4), QStringLiteral("–"));
    EXPECT_EQ(cell(5), QStringLiteral("measured by another version of the metric"));
    shown.show_pair(side(67, 3), side(93, 3));
    EXPECT_TRUE(cell(5).contains("worse"));
    shown.show_part(side(67, 3), side(93, 2));
    EXPECT_TRUE(cell(2).startsWith("67"));
    EXPECT_EQ(cell(3), QStringLiteral("–"));
    EXPECT_FALSE(table->item(0, 3)->toolTip().isEmpty());
    shown.show_part(side(67, 3), side(93, 3));
    EXPECT_TRUE(cell(3).startsWith("93"));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
