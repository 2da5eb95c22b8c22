// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab tradeoff`: cost of each level of a model and its error against a stated reference
// (docs/THEORY.md, section 8).
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

/// One level at one resolution: its error and the time of one step.
struct TradeoffLevel {
    std::string level;   ///< unique in its study, for example "newton, 64 segments"
    std::string family;  ///< the level without its resolution: points of one family are joined in the chart
    double error = 0;    ///< against the study's reference, in `error_unit`; finite, not negative
    std::string error_unit;  ///< meaning of the error, for example "m, mean over nodes"
    double time_us = 0;      ///< median time of one step, measured
    bool pareto = false;     ///< set by mark_pareto
};

/// All levels of one model, measured in one process with one reference.
struct TradeoffStudy {
    std::string model;      ///< "rod", "material", "skinning", "membrane", "collision", "tool_contact",
                            ///< "haptic_model_age"
    std::string reference;  ///< reference of the errors
    std::vector<TradeoffLevel> levels;
};

/// Marks the levels that no other level beats in both error and time. Only levels with the same error unit
/// are compared.
void mark_pareto(TradeoffStudy& study);

/// Median time in us of `step`, run `warm_up` times first and then `samples` times; `between` runs untimed
/// before each.
template <class Step, class Between>
double median_time_us(int warm_up, int samples, Step&& step, Between&& between) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(samples));
    for (int i = 0; i < warm_up + samples; ++i) {
        between();
        const auto begin = Clock::now();
        step();
        const auto end = Clock::now();
        if (i >= warm_up) times.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    }
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

/// All studies of sim_core, one model per line in tradeoff.cpp, Pareto front marked. Takes one to two
/// minutes.
std::vector<TradeoffStudy> tradeoff_studies();

/// {"studies": [...]} of docs/FORMATS.md.
nlohmann::json to_json(const std::vector<TradeoffStudy>& studies);
ResultPage tradeoff_page(const std::vector<TradeoffStudy>& studies);

}  // namespace fulcrum::lab
