// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/relapse_cusum.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace fulcrum {
namespace {

double pass_step() {
    return std::log((1 - relapse_p1) / (1 - relapse_p0));
}
double failure_step() {
    return std::log(relapse_p1 / relapse_p0);
}

}  // namespace

double relapse_alarm(double q, double h, int attempts) {
    using State = std::pair<int, int>;  // failures, passes since the sum was last 0
    std::map<State, double> now{{{0, 0}, 1.0}};
    double alarmed = 0;
    for (int i = 0; i < attempts; ++i) {
        std::map<State, double> next;
        for (const auto& [state, chance] : now) {
            const State failed{state.first + 1, state.second}, passed{state.first, state.second + 1};
            const auto sum = [](const State& s) { return s.first * failure_step() + s.second * pass_step(); };
            if (sum(failed) >= h) {
                alarmed += q * chance;
            } else {
                next[failed] += q * chance;
            }
            next[sum(passed) <= 0 ? State{0, 0} : passed] += (1 - q) * chance;
        }
        now = std::move(next);
    }
    return alarmed;
}

bool RelapseCusum::step(bool passed) {
    sum_ = std::max(0.0, sum_ + (passed ? pass_step() : failure_step()));
    if (sum_ < relapse_limit) return false;
    sum_ = 0;
    return true;
}

}  // namespace fulcrum
