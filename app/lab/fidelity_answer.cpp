// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/fidelity_answer.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "assessment/learning/statistics.h"
#include "assessment/metrics/registry.h"

namespace fulcrum::app {
namespace {

using BySeed = std::map<std::uint64_t, const ObservedAttempt*>;

BySeed pick(const FidelityStudy& study, const std::string& task, Pairing pairing, FidelityLevel level) {
    BySeed found;
    for (const ObservedAttempt& one : study.attempts)
        if (one.task == task && one.pairing == pairing && one.fidelity == level) found[one.seed] = &one;
    return found;
}

/// What a shift of 100 % is: the size of the metric, or the limit of its gate where that is larger, so that a
/// change far below a limit is not called large; of counts at least 1, of points 100.
double whole_of(const std::string& id, const PairedShift& shift, double limit) {
    if (id == "points") return 100;
    const MetricDescriptor* metric = find_metric(id);
    double whole = std::max(shift.size, std::fabs(limit));
    if (metric != nullptr)
        whole = std::max(whole, metric->aggregation == Aggregation::count ? 1.0 : metric->precision);
    return whole > 0 ? whole : 1;
}

/// The gate of a metric; null where there is none.
const StudiedGate* gate_of(const StudiedTask& task, const std::string& key) {
    for (const StudiedGate& gate : task.gates)
        if (gate.key() == key) return &gate;
    return nullptr;
}

/// "f_max left wall": "f_max wall" and "left".
void name_shift(const std::string& key, MetricShift& shift) {
    shift.metric = key;
    for (const char* hand : {"left", "right"}) {
        const std::size_t at = key.find(std::string(" ") + hand);
        if (at == std::string::npos) continue;
        shift.hand = hand;
        shift.metric = key.substr(0, at) + key.substr(at + 1 + shift.hand.size());
        return;
    }
}

Comparison compare(const StudiedTask& task, const BySeed& attempts, const BySeed& references) {
    Comparison result;
    std::set<std::string> keys;
    for (const auto& [seed, reference] : references) {
        const auto found = attempts.find(seed);
        if (found == attempts.end()) continue;
        ++result.pairs;
        if (found->second->passed != reference->passed) {
            result.flips.push_back(seed);
            if (found->second->passed == std::optional<bool>(true)) ++result.to_passed;
        }
        for (const ObservedAttempt* one : {found->second, reference})
            for (const auto& [key, value] : one->values) keys.insert(key);
    }
    for (const std::string& key : keys) {
        std::vector<double> values, paired;
        MetricShift row;
        for (const auto& [seed, reference] : references) {
            const auto found = attempts.find(seed);
            if (found == attempts.end()) continue;
            const auto here = found->second->values.find(key), there = reference->values.find(key);
            const bool has = here != found->second->values.end(), had = there != reference->values.end();
            if (has != had) ++row.one_sided;
            if (!has || !had) continue;
            values.push_back(here->second);
            paired.push_back(there->second);
        }
        const auto shift = paired_shift(values, paired);
        if (!shift) continue;
        const StudiedGate* gate = gate_of(task, key);
        name_shift(key, row);
        row.gated = gate != nullptr;
        row.shift = *shift;
        row.whole = whole_of(key.substr(0, key.find(' ')), *shift, gate != nullptr ? gate->limit : 0);
        result.shifts.push_back(std::move(row));
    }
    std::stable_sort(result.shifts.begin(), result.shifts.end(),
                     [](const MetricShift& a, const MetricShift& b) { return a.gated > b.gated; });
    return result;
}

/// Of the simulation, for one simulated second.
double median_ms(const BySeed& attempts) {
    std::vector<double> costs;
    for (const auto& [seed, one] : attempts)
        if (one->simulated_s > 0) costs.push_back(1e3 * one->processor_s / one->simulated_s);
    return costs.empty() ? 0 : median_of(costs);
}

FidelityLevel cheapest_of(const TaskAnswer& answer) {
    const LevelAnswer* least = nullptr;
    for (const LevelAnswer& level : answer.levels)
        if (level.holding() == Holding::holds &&
            (least == nullptr || level.processor_ms < least->processor_ms))
            least = &level;
    if (least == nullptr) return FidelityLevel::fine;
    constexpr double same_cost = 1.05;
    std::optional<FidelityLevel> first;
    for (const LevelAnswer& level : answer.levels) {
        const bool equal =
            (level.identical() && least->identical()) ||
            (level.holding() == Holding::holds && level.processor_ms <= same_cost * least->processor_ms);
        if (!equal) continue;
        if (answer.task.fidelity == row_of(fidelity_levels, level.level).name) return level.level;
        if (!first) first = level.level;
    }
    return first.value_or(least->level);
}

}  // namespace

const MetricShift* Comparison::worst() const {
    const MetricShift* worst = nullptr;
    for (const MetricShift& row : shifts)
        if (row.gated && (worst == nullptr || std::fabs(row.percent()) > std::fabs(worst->percent())))
            worst = &row;
    return worst;
}

Holding Comparison::holding() const {
    if (!flips.empty()) return Holding::moves;
    Holding holding = Holding::holds;
    for (const MetricShift& row : shifts) {
        if (!row.gated) continue;
        if (std::fabs(row.percent()) > allowed_percent) return Holding::moves;
        if (row.low() < -allowed_percent || row.high() > allowed_percent) holding = Holding::undecided;
    }
    return holding;
}

bool Comparison::identical() const {
    return flips.empty() && std::all_of(shifts.begin(), shifts.end(), [](const MetricShift& row) {
               return row.one_sided == 0 && row.shift.low == 0 && row.shift.high == 0;
           });
}

bool LevelAnswer::identical() const {
    return performed.identical() && replayed.identical();
}

bool TaskAnswer::identical() const {
    return std::all_of(levels.begin(), levels.end(),
                       [](const LevelAnswer& level) { return level.identical(); });
}

Holding LevelAnswer::holding() const {
    return std::max(performed.holding(), replayed.holding());
}

std::vector<TaskAnswer> fidelity_answers(const FidelityStudy& study) {
    std::vector<TaskAnswer> answers;
    for (const StudiedTask& task : study.tasks) {
        TaskAnswer answer;
        answer.task = task;
        const auto at = [&](Pairing pairing, FidelityLevel level) {
            return pick(study, task.id, pairing, level);
        };
        const BySeed finest = at(Pairing::performed, FidelityLevel::fine),
                     finest_replayed = at(Pairing::replayed, FidelityLevel::fine);
        answer.seeds = static_cast<int>(finest.size());
        if (answer.seeds < 2) continue;
        for (const NameRow<FidelityLevel>& row : fidelity_levels) {
            LevelAnswer level;
            level.level = row.kind;
            const BySeed performed = at(Pairing::performed, row.kind);
            level.processor_ms = median_ms(performed);
            level.performed = compare(task, performed, finest);
            level.replayed = compare(task, at(Pairing::replayed, row.kind), finest_replayed);
            answer.levels.push_back(std::move(level));
        }
        answer.chance = compare(task, at(Pairing::repeated, FidelityLevel::standard),
                                at(Pairing::performed, FidelityLevel::standard));
        answer.cheapest = cheapest_of(answer);
        answers.push_back(std::move(answer));
    }
    return answers;
}

FidelityCosts costs_of(const std::vector<TaskAnswer>& answers, const FidelityStudy& study) {
    FidelityCosts costs;
    for (const TaskAnswer& answer : answers) {
        TaskFidelityCost& task = costs.tasks[answer.task.id];
        task.cheapest = row_of(fidelity_levels, answer.cheapest).name;
        task.commit = study.commit;
        task.physics = study.physics;
        task.limits = answer.task.limits;
        task.metrics = answer.task.metrics;
        for (const LevelAnswer& level : answer.levels) {
            FidelityCost cost;
            cost.fidelity = row_of(fidelity_levels, level.level).name;
            cost.processor_ms = level.processor_ms;
            const MetricShift* worst = level.performed.worst();
            if (worst != nullptr && worst->shift.shift != 0) {
                cost.metric = worst->metric.substr(0, worst->metric.find(' '));
                cost.hand = worst->hand;
                cost.shift_percent = worst->percent();
            }
            cost.verdicts = static_cast<int>(level.performed.flips.size());
            cost.attempts = level.performed.pairs;
            task.levels.push_back(std::move(cost));
        }
    }
    return costs;
}

}  // namespace fulcrum::app
