// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/decimation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum::ui {

MinMaxPyramid::MinMaxPyramid(std::vector<double> x, std::vector<float> y,
                             const std::vector<std::size_t>& begins)
    : x_(std::move(x)), y_(std::move(y)) {
    std::size_t kept = 0;
    bool gap = false;
    auto next = begins.begin();
    for (std::size_t i = 0; i < std::min(x_.size(), y_.size()); ++i) {
        if (next != begins.end() && *next == i) {
            gap = true;
            ++next;
        }
        if (!std::isfinite(y_[i]) || !std::isfinite(x_[i])) {
            gap = true;
            continue;
        }
        if (gap && kept > 0) gaps_.emplace_back(x_[kept - 1], x_[i]);
        gap = false;
        x_[kept] = x_[i];
        y_[kept] = y_[i];
        ++kept;
    }
    x_.resize(kept);
    y_.resize(kept);
    if (kept == 0) return;

    std::vector<Bucket> base((kept + base_width - 1) / base_width);
    for (std::size_t b = 0; b < base.size(); ++b) {
        const std::size_t begin = b * base_width, end = std::min(kept, begin + base_width);
        std::size_t low = begin, high = begin;
        for (std::size_t i = begin + 1; i < end; ++i) {
            if (y_[i] < y_[low]) low = i;
            if (y_[i] > y_[high]) high = i;
        }
        base[b] = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)};
    }
    levels_.push_back(std::move(base));
    while (levels_.back().size() > 1) {
        const std::vector<Bucket>& finer = levels_.back();
        std::vector<Bucket> coarser((finer.size() + 1) / 2);
        for (std::size_t b = 0; b < coarser.size(); ++b) {
            const Bucket& first = finer[2 * b];
            const Bucket& second = finer[std::min(2 * b + 1, finer.size() - 1)];
            coarser[b].low = y_[second.low] < y_[first.low] ? second.low : first.low;
            coarser[b].high = y_[second.high] > y_[first.high] ? second.high : first.high;
        }
        levels_.push_back(std::move(coarser));
    }
    lowest_ = static_cast<double>(y_[levels_.back().front().low]);
    highest_ = static_cast<double>(y_[levels_.back().front().high]);
}

MinMaxPyramid MinMaxPyramid::moved(const std::function<std::optional<double>(double)>& place) const {
    std::vector<double> x;
    std::vector<float> y;
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const std::optional<double> there = place(x_[i]);
        if (!there) continue;
        x.push_back(*there);
        y.push_back(y_[i]);
    }
    MinMaxPyramid other(std::move(x), std::move(y));
    for (const auto& [before, after] : gaps_) {
        const std::optional<double> from = place(before), to = place(after);
        if (from && to) other.gaps_.emplace_back(*from, *to);
    }
    return other;
}

double MinMaxPyramid::value_at(double x) const noexcept {
    const auto after = std::upper_bound(x_.begin(), x_.end(), x);
    if (after == x_.begin()) return 0;
    return static_cast<double>(y_[static_cast<std::size_t>(after - x_.begin()) - 1]);
}

std::optional<double> MinMaxPyramid::at(double x) const noexcept {
    if (x_.empty() || x < first_x() || x > last_x()) return std::nullopt;
    const auto gap = std::upper_bound(
        gaps_.begin(), gaps_.end(), x,
        [](double place, const std::pair<double, double>& one) { return place < one.second; });
    if (gap != gaps_.end() && gap->first < x) return std::nullopt;
    return value_at(x);
}

std::vector<ChartPoint> MinMaxPyramid::view(double from, double to, std::size_t limit) const {
    if (x_.empty()) return {};
    auto begin = static_cast<std::size_t>(std::lower_bound(x_.begin(), x_.end(), from) - x_.begin());
    auto end = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), to) - x_.begin());
    if (begin > 0) --begin;
    if (end < x_.size()) ++end;
    std::vector<ChartPoint> candidates;
    const auto add = [&](std::size_t i) { candidates.push_back({x_[i], static_cast<double>(y_[i])}); };
    const std::size_t count = end - begin;
    if (count <= limit) {
        candidates.reserve(count);
        for (std::size_t i = begin; i < end; ++i) add(i);
        return candidates;
    }
    // The coarsest level whose buckets still give four candidates a point: cheap, and LTTB has something to
    // choose from.
    std::size_t level = 0;
    while (level + 1 < levels_.size() && (count / (base_width << (level + 1))) * 2 > 4 * limit) ++level;
    const std::size_t width = base_width << level;
    if (count / width < limit && level == 0 && count <= 8 * limit) {
        candidates.reserve(count);
        for (std::size_t i = begin; i < end; ++i) add(i);
        return reduce_points(candidates, limit);
    }
    const std::size_t first_full = (begin + width - 1) / width, last_full = end / width;
    for (std::size_t i = begin; i < std::min(end, first_full * width); ++i) add(i);
    for (std::size_t b = first_full; b < last_full; ++b) {
        const Bucket& bucket = levels_[level][b];
        add(std::min(bucket.low, bucket.high));
        if (bucket.low != bucket.high) add(std::max(bucket.low, bucket.high));
    }
    for (std::size_t i = std::max(begin, last_full * width); i < end; ++i) add(i);
    return reduce_points(candidates, limit);
}

std::vector<ChartLine> MinMaxPyramid::lines(double from, double to, std::size_t limit) const {
    std::vector<ChartLine> lines;
    auto gap = gaps_.begin();
    for (const ChartPoint& point : view(from, to, limit)) {
        std::optional<double> between;
        if (!lines.empty()) {
            const double before = lines.back().points.back().x;
            while (gap != gaps_.end() && gap->first < before) ++gap;
            if (gap != gaps_.end() && gap->second <= point.x) between = 0.5 * (gap->first + gap->second);
        }
        if (lines.empty() || between) lines.push_back({{}, between});
        lines.back().points.push_back(point);
    }
    return lines;
}

std::vector<ChartPoint> reduce_points(const std::vector<ChartPoint>& points, std::size_t limit) {
    if (points.size() <= limit) return points;
    const std::size_t inner = points.size() - 2;
    const std::size_t buckets = std::min(inner, (limit - 2) / 3);
    std::vector<ChartPoint> kept;
    kept.reserve(limit);
    kept.push_back(points.front());
    ChartPoint before = points.front();
    const auto bucket_begin = [&](std::size_t b) { return 1 + b * inner / buckets; };
    for (std::size_t b = 0; b < buckets; ++b) {
        const std::size_t begin = bucket_begin(b), end = bucket_begin(b + 1);
        ChartPoint after = points.back();
        if (b + 1 < buckets) {
            const std::size_t next_end = bucket_begin(b + 2);
            ChartPoint sum;
            for (std::size_t i = end; i < next_end; ++i) {
                sum.x += points[i].x;
                sum.y += points[i].y;
            }
            const auto n = static_cast<double>(next_end - end);
            after = {sum.x / n, sum.y / n};
        }
        std::size_t low = begin, high = begin, best = begin;
        double largest = -1;
        for (std::size_t i = begin; i < end; ++i) {
            if (points[i].y < points[low].y) low = i;
            if (points[i].y > points[high].y) high = i;
            const double area = std::abs((before.x - after.x) * (points[i].y - before.y) -
                                         (before.x - points[i].x) * (after.y - before.y));
            if (area > largest) {
                largest = area;
                best = i;
            }
        }
        std::array<std::size_t, 3> chosen{low, high, best};
        std::sort(chosen.begin(), chosen.end());
        for (std::size_t c = 0; c < chosen.size(); ++c) {
            if (c == 0 || chosen[c] != chosen[c - 1]) kept.push_back(points[chosen[c]]);
        }
        before = points[best];
    }
    kept.push_back(points.back());
    return kept;
}

}  // namespace fulcrum::ui
