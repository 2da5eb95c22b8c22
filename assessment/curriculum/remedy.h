// SPDX-License-Identifier: Apache-2.0
// What a curriculum recommends to a trainee whose curve levels off below the pass mark: where a metric is
// beyond a bound, practise a part of the task, another task, another variant, or get a form of feedback.
// Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/installed_task.h"
#include "sim_core/numerics/name_table.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

struct Curriculum;

enum class RemedyKind : std::uint8_t {
    practise_from,  ///< practise the task from one of its later goals on
    other_task,     ///< perform another task, in one of its variants where one is named
    other_variant,  ///< perform another variant of the task
    ghost,          ///< practise with the ghost of an expert
    demonstration,  ///< watch an expert do it
    replay          ///< look at the replay of the latest attempt
};

/// In a file: "metric", "above" or "below" a bound, its "unit", and one of "practise_from", "task" (with
/// "variant" or without), "variant", "feedback".
struct Remedy {
    std::string metric;  ///< id
    bool above = true;   ///< it is meant for values above the bound; false: below it
    double bound = 0;
    std::string unit;  ///< of the bound: the metric's own
    RemedyKind kind = RemedyKind::demonstration;
    std::string goal = {};     ///< practise_from: id of the goal
    std::string task = {};     ///< other_task
    std::string variant = {};  ///< other_task: "" for any; other_variant
};
bool operator==(const Remedy& a, const Remedy& b);
inline bool operator!=(const Remedy& a, const Remedy& b) {
    return !(a == b);
}

/// "ghost", "demonstration", "replay" in files; "" for the other kinds.
const char* feedback_name(RemedyKind kind);
std::optional<RemedyKind> feedback_named(const std::string& name);

struct RemedyProblem {
    std::string key;  ///< of the remedy in the file: "metric"
    Sentence problem, hint;
};
/// What is wrong with the remedy whatever the task: an unknown metric, another unit than the metric's, a
/// bound on the good side.
std::optional<RemedyProblem> problem_of(const Remedy& remedy);
/// The same, and what does not fit `task`, whose remedy it is, and `tasks`, the installed ones: a metric that
/// it does not show, a goal, task or variant that is not there, a ghost of a task for the scope.
std::optional<RemedyProblem> problem_of(const Remedy& remedy, const std::string& task,
                                        const std::vector<InstalledTask>& tasks);
/// Throws InputError with file, place and hint for the first problem of the curriculum and its older
/// versions.
void check_remedies(const Curriculum& curriculum, const std::vector<InstalledTask>& tasks);

}  // namespace fulcrum
