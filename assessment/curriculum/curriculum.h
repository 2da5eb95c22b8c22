// SPDX-License-Identifier: Apache-2.0
// A curriculum as data: stages, tasks, what unlocks them, and when a trainee is proficient in each. JSON
// files in assets/curricula, schema assets/schemas/curriculum.schema.json.
#pragma once

#include <string>
#include <vector>

#include "assessment/learning/pass_rule.h"
#include "assessment/task/attempt_words.h"

namespace fulcrum {

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
};

struct Curriculum {
    std::string id;
    int version = 1;
    std::string title;
    std::vector<CurriculumStage> stages;  ///< in the order in which they are learned
    std::vector<CurriculumTask> tasks;    ///< in the order in which they are shown

    /// "rectal@1", as attempts record it.
    std::string name() const { return id + "@" + std::to_string(version); }
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

/// Throws InputError with file, place and hint: not valid by the schema, a stage, task or prerequisite that
/// is not there or named twice, a prerequisite of a later stage, a cycle, a rule that is none. `tasks`: the
/// installed ones.
Curriculum parse_curriculum(const std::string& text, const std::string& file,
                            const std::vector<std::string>& tasks);
Curriculum load_curriculum(const std::string& path, const std::vector<std::string>& tasks);

}  // namespace fulcrum
