// SPDX-License-Identifier: GPL-3.0-or-later
// The curriculum that trainees follow, with all its installed versions.
#pragma once

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/installed_task.h"
#include "assessment/curriculum/rating_rule.h"
#include "assessment/curriculum/remedy.h"
#include "assessment/forms/observer_form.h"

namespace fulcrum::app {

/// Throws InputError.
inline std::vector<InstalledTask> all_installed_tasks() {
    std::vector<InstalledTask> tasks;
    for (const std::string& id : task_ids()) tasks.push_back(installed_task(load_task(task_file(id))));
    return tasks;
}
/// Throws InputError.
inline Curriculum installed_curriculum() {
    Curriculum newest = load_versions(asset_path("curricula"), "rectal", task_ids());
    check_ratings(newest, load_forms(asset_path("forms")));
    check_remedies(newest, all_installed_tasks());
    return newest;
}

}  // namespace fulcrum::app
