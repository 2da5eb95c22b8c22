// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt next to another one of the same task, or next to a cohort, aligned by the steps that both met.
// Read and prepared off the UI thread.
#pragma once

#include <QStringList>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "assessment/trace/phase_alignment.h"
#include "ui/review/attempt_model.h"

namespace fulcrum::ui {

/// What an attempt can be compared with.
struct ComparisonChoice {
    enum class Kind { attempt, expert, cohort };
    Kind kind = Kind::attempt;
    std::string id;  ///< of the attempt or the cohort
    QString title;
};

/// Own best, own last before it, the benchmark's experts, cohorts, then every other attempt of the person at
/// this task, newest first. An attempt for which the session has begun a form that is blind so far is left
/// out: to show it would lift the blinding. Throws AccessDenied, StoreError.
std::vector<ComparisonChoice> comparison_choices(const database::Store& store,
                                                 const database::Session& session,
                                                 const database::AttemptSummary& own,
                                                 const TaskDefinition* task);

/// Fewest people of whom a band is shown.
inline constexpr std::size_t least_in_band = 5;

struct ComparedSide {
    AttemptModel model;  ///< with its trace; without samples where `why_no_trace` says so
    std::optional<Scene> scene;
    PhaseMoments moments;
    QString why_no_trace;  ///< empty: it is there
    bool has_trace() const { return why_no_trace.isEmpty(); }
};
/// Worker thread; empty when stopped. Throws AccessDenied, StoreError.
std::optional<ComparedSide> load_side(const database::Store& store, const database::Session& session,
                                      const std::string& attempt_id, const std::optional<Scene>& scene,
                                      const Progress& progress);
ComparedSide expert_side(const ExpertAttempt& expert, const std::optional<Scene>& scene);

/// Two attempts: values of the other over the time of the own one.
struct ComparedPair {
    PhaseMap map;  ///< first: the own attempt
    std::array<std::shared_ptr<const MinMaxPyramid>, hand_count> force, speed;
};
ComparedPair align(const ComparedSide& own, const ComparedSide& other);

/// The latest attempt of each other person of a cohort at the same task and variant with the same class of
/// device, completed and counting.
struct CohortSide {
    QString name;
    std::size_t people = 0;                                       ///< with such an attempt
    std::size_t without_trace = 0;                                ///< of them, whose trace is not here
    std::array<std::vector<BandPoint>, hand_count> force, speed;  ///< over the own attempt's time
    /// By metric and hand, of the versions of the metrics that measured the own attempt.
    std::map<std::pair<std::string, std::string>, Spread> metrics;
    std::set<std::string> other_versions;  ///< metrics of which values by other versions are left out
};
/// Worker thread; empty when stopped. Throws AccessDenied, StoreError.
std::optional<CohortSide> load_cohort(const database::Store& store, const database::Session& session,
                                      const std::string& cohort_id, const ComparedSide& own,
                                      const Progress& progress);

/// What has to be known before the two are compared: other variant, other devices, no trace, no common step.
QStringList comparison_notes(const ComparedSide& own, const ComparedSide& other, const ComparedPair& pair,
                             const TaskDefinition* task);
QStringList comparison_notes(const ComparedSide& own, const CohortSide& cohort);

}  // namespace fulcrum::ui
