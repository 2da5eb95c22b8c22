// SPDX-License-Identifier: GPL-3.0-or-later
// From millions of samples to at most a few thousand points on a screen without losing a peak: a min/max
// pyramid gives the candidates of a view, then buckets of them keep their lowest point, their highest point
// and the one that largest-triangle-three-buckets (Steinarsson 2013) chooses. Pure; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace fulcrum::ui {

inline constexpr std::size_t chart_point_limit = 4000;

struct ChartPoint {
    double x = 0, y = 0;
};

/// Points that belong together: a line may join them.
struct ChartLine {
    std::vector<ChartPoint> points;
    /// x in the gap before it, where there is no value; of the first line in view none.
    std::optional<double> gap;
};

class MinMaxPyramid {
  public:
    MinMaxPyramid() = default;
    /// x never falls; both have the same length; non-finite y are left out, with a gap in their place.
    /// `begins`: rising, the samples with a gap before them though nothing is left out. O(n) time, n/8
    /// indices of memory next to the data.
    MinMaxPyramid(std::vector<double> x, std::vector<float> y, const std::vector<std::size_t>& begins = {});

    /// The same values at other places; `place` never falls. Those that have none are left out.
    MinMaxPyramid moved(const std::function<std::optional<double>(double)>& place) const;

    const std::vector<double>& x() const noexcept { return x_; }
    const std::vector<float>& y() const noexcept { return y_; }
    std::size_t size() const noexcept { return y_.size(); }
    double first_x() const noexcept { return x_.empty() ? 0 : x_.front(); }
    double last_x() const noexcept { return x_.empty() ? 0 : x_.back(); }
    /// Over everything; 0 without samples.
    double lowest() const noexcept { return lowest_; }
    double highest() const noexcept { return highest_; }
    /// The value of the last sample at or before x; 0 before the first.
    double value_at(double x) const noexcept;
    /// The same; none before the first and after the last sample, and in a gap.
    std::optional<double> at(double x) const noexcept;

    /// At most `limit` points (limit >= 5) of the samples in [from, to], with one sample beyond each end so
    /// that lines reach the border. Every sample when they are few enough. The lowest and the highest sample
    /// of the view are always among them. x rises.
    std::vector<ChartPoint> view(double from, double to, std::size_t limit = chart_point_limit) const;
    /// The same points, divided at each gap.
    std::vector<ChartLine> lines(double from, double to, std::size_t limit = chart_point_limit) const;

  private:
    struct Bucket {
        std::uint32_t low = 0, high = 0;  ///< indices of samples
    };
    static constexpr std::size_t base_width = 16;
    std::vector<double> x_;
    std::vector<float> y_;
    std::vector<std::pair<double, double>> gaps_;  ///< x of the samples before and after each
    std::vector<std::vector<Bucket>> levels_;      ///< level k: buckets of base_width * 2^k samples
    double lowest_ = 0, highest_ = 0;
};

/// At most `limit` of `points` (limit >= 5), ends kept, lowest and highest kept.
std::vector<ChartPoint> reduce_points(const std::vector<ChartPoint>& points, std::size_t limit);

}  // namespace fulcrum::ui
