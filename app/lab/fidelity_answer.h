// SPDX-License-Identifier: GPL-3.0-or-later
// From the attempts of a study to its answer: the cheapest fidelity of each task that leaves the score as it
// is. Pure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/lab/fidelity_study.h"
#include "assessment/assets/fidelity_cost.h"
#include "assessment/learning/paired_shift.h"

namespace fulcrum::app {

/// A gated metric may move by this much.
inline constexpr double allowed_percent = 2;

struct MetricShift {
    std::string metric, hand;  ///< with its tissue, if any, in `metric`
    bool gated = false;
    PairedShift shift;  ///< in the metric's unit; value minus reference
    double whole = 1;   ///< what percentages are of
    int one_sided = 0;  ///< pairs in which only one attempt has a value
    double percent() const { return 100 * shift.shift / whole; }
    double low() const { return 100 * shift.low / whole; }
    double high() const { return 100 * shift.high / whole; }
};
enum class Holding : std::uint8_t {
    holds,      ///< no verdict changes, and every interval of a gated metric lies within the allowed range
    undecided,  ///< no estimate is beyond it, but an interval reaches beyond it
    moves       ///< an estimate lies beyond it, or a verdict changes
};
/// Two conditions compared over all seeds.
struct Comparison {
    std::vector<MetricShift> shifts;   ///< gated ones first, then by name
    std::vector<std::uint64_t> flips;  ///< seeds with another verdict
    int to_passed = 0;                 ///< of these, passed here and not at the reference
    int pairs = 0;
    /// The gated metric with the largest estimate; null without one.
    const MetricShift* worst() const;
    Holding holding() const;
    bool identical() const;  ///< no value and no verdict differs
};
struct LevelAnswer {
    FidelityLevel level = FidelityLevel::standard;
    double processor_ms = 0;         ///< median for one simulated second, over the performed attempts
    Comparison performed, replayed;  ///< against the finest
    Holding holding() const;         ///< the worse of both
    bool identical() const;          ///< to the finest
};
struct TaskAnswer {
    StudiedTask task;
    int seeds = 0;
    std::vector<LevelAnswer> levels;  ///< from fast to fine
    Comparison chance;                ///< `repeated` against `performed` at standard
    bool identical() const;           ///< no fidelity changes anything: no part of the scene depends on it
    /// The least expensive level that holds. Levels within 5 % of the least cost cost the same, and so do
    /// those whose attempts are identical: of these the scene's own is named, else the first.
    FidelityLevel cheapest = FidelityLevel::fine;
};

/// Tasks with fewer than 2 seeds are left out.
std::vector<TaskAnswer> fidelity_answers(const FidelityStudy& study);
/// What briefings and help say. `study`: that of the answers; its program measured.
FidelityCosts costs_of(const std::vector<TaskAnswer>& answers, const FidelityStudy& study);

}  // namespace fulcrum::app
