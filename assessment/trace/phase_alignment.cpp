// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/phase_alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fulcrum {
namespace {

constexpr double longest_hold_s = 0.1;  // of a sample: what is further away is no value of this moment

/// When the attempt began in this goal: its first movement, or when it had met all goals before. None where
/// it did not.
std::optional<double> begin_of(const PhaseMoments& attempt, int goal) {
    double moment = attempt.begin;
    for (int before = attempt.first_goal; before < goal; ++before) {
        const auto met = attempt.met.find(before);
        if (met == attempt.met.end()) return std::nullopt;
        moment = std::max(moment, met->second);
    }
    return moment;
}

}  // namespace

PhaseMoments phase_moments(const std::vector<Event>& events, double tick_period, double end) {
    PhaseMoments moments;
    moments.end = end;
    bool moved = false;
    for (const Event& event : events) {
        const double time = event.tick * tick_period;
        if (event.kind == EventKind::first_movement && !moved) {
            moved = true;
            moments.begin = time;
        }
        if (event.kind == EventKind::phase_end) moments.met[event.detail] = time;
        if (event.kind == EventKind::completed) moments.completed = true;
    }
    return moments;
}

PhaseMap::PhaseMap(const PhaseMoments& first, const PhaseMoments& second)
    : first_end_(first.end), second_end_(second.end) {
    // A moment that does not come later than the one before in both attempts says nothing about the pace.
    const auto add = [this](double a, double b) {
        if (!first_.empty() && (a <= first_.back() || b <= second_.back())) return false;
        first_.push_back(a);
        second_.push_back(b);
        return true;
    };
    const int latest = std::max(first.first_goal, second.first_goal);
    const std::optional<double> begin = begin_of(first, latest), other = begin_of(second, latest);
    if (begin && other) {
        first_goal_ = latest;
        add(*begin, *other);
    } else {
        add(first.begin, second.begin);
    }
    std::vector<std::pair<double, int>> in_order;
    for (const auto& [goal, time] : first.met)
        if (second.met.count(goal) != 0) in_order.emplace_back(time, goal);
    std::sort(in_order.begin(), in_order.end());
    for (const auto& [time, goal] : in_order)
        if (add(time, second.met.at(goal))) goals_.push_back(goal);
    if (first.completed && second.completed) add(first.end, second.end);
}

double PhaseMap::mapped(const std::vector<double>& from, const std::vector<double>& to, double t,
                        double end) {
    double there = t;
    if (!from.empty()) {
        const auto after = std::upper_bound(from.begin(), from.end(), t);
        if (after == from.begin()) {
            there = to.front() - (from.front() - t);
        } else if (after == from.end()) {
            there = to.back() + (t - from.back());
        } else {
            const auto i = static_cast<std::size_t>(after - from.begin());
            const double share = (t - from[i - 1]) / (from[i] - from[i - 1]);
            there = to[i - 1] + share * (to[i] - to[i - 1]);
        }
    }
    return std::clamp(there, 0.0, std::max(end, 0.0));
}

double PhaseMap::to_second(double t) const {
    return mapped(first_, second_, t, second_end_);
}

double PhaseMap::to_first(double t) const {
    return mapped(second_, first_, t, first_end_);
}

std::vector<float> aligned_means(const PhaseMap& map, double end, std::size_t cells,
                                 const std::vector<double>& time, const std::vector<float>& value) {
    std::vector<float> means(cells, std::numeric_limits<float>::quiet_NaN());
    if (time.empty() || !(end > 0)) return means;
    const auto index_of = [&](double t) {
        return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
    };
    const double width = end / static_cast<double>(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const double begin = map.to_second(static_cast<double>(cell) * width),
                     after = map.to_second(static_cast<double>(cell + 1) * width);
        const std::size_t from = index_of(begin), to = index_of(after);
        if (after <= begin) continue;  // beyond the record
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = from; i < to; ++i) {
            if (!std::isfinite(value[i])) continue;
            sum += static_cast<double>(value[i]);
            ++count;
        }
        if (from == to && from > 0 && begin - time[from - 1] <= longest_hold_s) means[cell] = value[from - 1];
        if (count > 0) means[cell] = static_cast<float>(sum / static_cast<double>(count));
    }
    return means;
}

Spread spread_of(std::vector<double> values) {
    values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }),
                 values.end());
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (values.empty()) return {none, none, none, 0};
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        const double place = share * static_cast<double>(values.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, values.size() - 1);
        return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
    };
    return {at(0.25), at(0.5), at(0.75), values.size()};
}

std::vector<BandPoint> band_of(const std::vector<std::vector<float>>& attempts, double end,
                               std::size_t least) {
    std::vector<BandPoint> band;
    if (attempts.empty()) return band;
    const std::size_t cells = attempts.front().size();
    const double width = end / static_cast<double>(std::max<std::size_t>(cells, 1));
    for (std::size_t cell = 0; cell < cells; ++cell) {
        std::vector<double> values;
        for (const std::vector<float>& one : attempts) values.push_back(static_cast<double>(one[cell]));
        const Spread spread = spread_of(std::move(values));
        if (spread.count >= least) band.push_back({(static_cast<double>(cell) + 0.5) * width, spread});
    }
    return band;
}

}  // namespace fulcrum
