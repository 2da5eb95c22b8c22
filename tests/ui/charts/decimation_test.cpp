// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/decimation.h"
#include "ui/charts/time_chart.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

/// A staircase: flat, then a rise, again and again. Between two corners it never falls, so the lowest and the
/// highest point of a part are its first and its last.
struct Staircase : Series {
    static constexpr std::size_t count = 30'000, flat = 50, period = 100;
    static constexpr float rise = 0.0625F;  // exact in every sum
    Staircase() {
        float height = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (i % period >= flat) height += rise;
            if (i % period == flat - 1) corners.push_back(i);
            x.push_back(static_cast<double>(i) * 1e-3);
            y.push_back(height);
        }
    }
    std::size_t missed_by(const std::vector<ChartPoint>& points) const {
        return static_cast<std::size_t>(std::count_if(corners.begin(), corners.end(), [&](std::size_t i) {
            return !holds(points, x[i], static_cast<double>(y[i]));
        }));
    }
    std::vector<std::size_t> corners;  ///< where a rise begins
};

/// The lowest and the highest point of each part alone, as many points as are drawn.
std::vector<ChartPoint> lowest_and_highest(const Series& series, std::size_t limit) {
    const std::size_t parts = limit / 2;
    std::vector<ChartPoint> points;
    for (std::size_t part = 0; part < parts; ++part) {
        const auto at = [&](std::size_t p) {
            return series.y.begin() + static_cast<std::ptrdiff_t>(p * series.y.size() / parts);
        };
        const auto low = std::min_element(at(part), at(part + 1)),
                   high = std::max_element(at(part), at(part + 1));
        for (const auto one : {std::min(low, high), std::max(low, high)})
            points.push_back(
                {series.x[static_cast<std::size_t>(one - series.y.begin())], static_cast<double>(*one)});
    }
    return points;
}

TEST(Decimation, KeepsCornersThatAreNeitherTheLowestNorTheHighestPoint) {
    Staircase stairs;
    EXPECT_GT(stairs.missed_by(lowest_and_highest(stairs, chart_point_limit)), stairs.corners.size() * 3 / 4)
        << "lowest and highest points draw them";
    stairs.y[12'399] = 4000.0F;
    stairs.y[23'499] = -20.0F;
    const std::vector<ChartPoint> points =
        MinMaxPyramid(stairs.x, stairs.y).view(0, stairs.x.back(), chart_point_limit);
    EXPECT_LE(points.size(), chart_point_limit);
    EXPECT_TRUE(holds(points, stairs.x[12'399], 4000.0));
    EXPECT_TRUE(holds(points, stairs.x[23'499], -20.0));
    EXPECT_EQ(stairs.missed_by(points), 0U);
}

/// Largest-triangle-three-buckets as published, with the buckets of reduce_points().
std::vector<ChartPoint> largest_triangles(const std::vector<ChartPoint>& points, std::size_t buckets) {
    const auto begin = [&](std::size_t bucket) { return 1 + bucket * (points.size() - 2) / buckets; };
    std::vector<ChartPoint> chosen{points.front()};
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        ChartPoint mean = points.back();
        if (bucket + 1 < buckets) {
            const std::size_t from = begin(bucket + 1), to = begin(bucket + 2);
            mean = {};
            for (std::size_t i = from; i < to; ++i) {
                mean.x += points[i].x / static_cast<double>(to - from);
                mean.y += points[i].y / static_cast<double>(to - from);
            }
        }
        const ChartPoint before = chosen.back();
        const auto area = [&](const ChartPoint& point) {
            return std::abs((point.x - before.x) * (mean.y - before.y) -
                            (mean.x - before.x) * (point.y - before.y)) /
                   2;
        };
        const auto first = points.begin() + static_cast<std::ptrdiff_t>(begin(bucket)),
                   last = points.begin() + static_cast<std::ptrdiff_t>(begin(bucket + 1));
        chosen.push_back(*std::max_element(
            first, last, [&](const ChartPoint& a, const ChartPoint& b) { return area(a) < area(b); }));
    }
    return chosen;
}

TEST(Decimation, HasThePointsOfTheLargestTriangles) {
    const Series series = noise(20'000, 5);
    std::vector<ChartPoint> points;
    for (std::size_t i = 0; i < series.x.size(); ++i)
        points.push_back({series.x[i], static_cast<double>(series.y[i])});
    const std::vector<ChartPoint> drawn = reduce_points(points, chart_point_limit);
    ASSERT_LE(drawn.size(), chart_point_limit);
    const std::vector<ChartPoint> extremes = lowest_and_highest(series, 2 * (chart_point_limit / 3));
    std::size_t others = 0;
    for (const ChartPoint& one : largest_triangles(points, (chart_point_limit - 2) / 3)) {
        EXPECT_TRUE(holds(drawn, one.x, one.y)) << one.x;
        others += holds(extremes, one.x, one.y) ? 0 : 1;
    }
    EXPECT_GT(others, 0U) << "the lowest and highest points would do";
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
