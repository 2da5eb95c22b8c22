// SPDX-License-Identifier: Apache-2.0
// A curriculum as data: stages, tasks, what unlocks them, and when a trainee is proficient in each. JSON
// files in assets/curricula, schema assets/schemas/curriculum.schema.json.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/rating_rule.h"
#include "assessment/curriculum/remedy.h"
#include "assessment/learning/pass_rule.h"
#include "assessment/task/attempt_words.h"

namespace fulcrum {

struct TaskDefinition;

struct CurriculumStage {
    std::string id;     ///< "A"
    std::string title;  ///< on screens
};

struct CurriculumTask {
    std::string task;                         ///< id of the task
    std::string stage;                        ///< id of its stage
    std::vector<std::string> after;           ///< unlocks it: tasks that the trainee is proficient in
    PassRule rule;                            ///< when a trainee is proficient
    std::vector<DeviceClass> device_classes;  ///< whose attempts count
    int variants = 1;                         ///< the passes that the rule counts are on at least so many
    std::optional<RatingRule> ratings = {};   ///< of the attempt that completes the rule; none: not asked for
    std::vector<Remedy> remedies = {};  ///< on a plateau, for the metric that is furthest beyond its bound
};

/// The version that a draft began with.
struct DraftOrigin {
    int version = 0;
    std::string sha256;  ///< of its file
};

struct Curriculum {
    std::string id;
    int version = 1;
    std::string title;
    std::vector<CurriculumStage> stages;  ///< in the order in which they are learned
    std::vector<CurriculumTask> tasks;    ///< in the order in which they are shown
    /// Its earlier versions that are installed, which people may still follow, newest first.
    std::vector<Curriculum> older = {};
    std::string file = {};                     ///< name in assets/curricula; "" where it is not from a file
    std::string text = {};                     ///< of that file
    std::optional<DraftOrigin> based_on = {};  ///< of a draft that was saved; says nothing in force

    /// "rectal@1", as attempts record it.
    std::string name() const { return id + "@" + std::to_string(version); }
    /// Of the version that a site publishes itself after this one. Numbers from first_own_version on are the
    /// site's: a later delivery of the program has none of them.
    int next_own_version() const { return std::max(version + 1, first_own_version); }
    static constexpr int first_own_version = 1001;
    /// Itself or an earlier version by its name(); null where it is not installed.
    const Curriculum* version_named(const std::string& name) const;
    /// Null for a task that does not belong to it.
    const CurriculumTask* find(const std::string& task) const;
    const CurriculumStage* find_stage(const std::string& stage) const;
};

/// The class under which an attempt counts: a synthetic operator moves a handle as a haptic device does. The
/// trace of another program counts for nothing.
constexpr DeviceClass curriculum_class(DeviceClass used) {
    return used == DeviceClass::synthetic ? DeviceClass::haptic : used;
}
/// Whether attempts with this class of device count for the task.
bool counts(const CurriculumTask& task, DeviceClass used);
/// As require_assessable(); also throws InputError where the curriculum counts the task, but not with this
/// class of device. Not for a task that it lacks: assessed attempts at it serve a site's own limits.
void require_counts(const Curriculum& curriculum, const TaskDefinition& task, DeviceClass used);

/// Throws InputError with file, place and hint: not valid by the schema, a stage, task or prerequisite that
/// is not there or named twice, a prerequisite of a later stage, a cycle, a rule that is none, a
/// remedy with an unknown metric or a wrong unit. `tasks`: the installed ones. Forms and items of ratings:
/// check_ratings(); what remedies ask for: check_remedies(); whether its rules can be met: check_rules().
Curriculum parse_curriculum(const std::string& text, const std::string& file,
                            const std::vector<std::string>& tasks);
/// Throws InputError with file and place where nobody can ever meet a rule (why_never_met()). Of a version
/// that is to come into force; one in force that has such a rule stays readable, since people follow it.
void check_rules(const Curriculum& curriculum);
/// Of a draft: valid by the schema, whatever else is wrong with it (check_draft()). Throws InputError.
Curriculum parse_draft(const std::string& text, const std::string& file);
Curriculum load_curriculum(const std::string& path, const std::vector<std::string>& tasks);
/// All versions of the curriculum `id` among the files of `folder`: the newest with the others as `older`.
/// Throws InputError as well where two files hold the same version, or none.
Curriculum load_versions(const std::string& folder, const std::string& id,
                         const std::vector<std::string>& tasks);

}  // namespace fulcrum
