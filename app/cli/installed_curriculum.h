// SPDX-License-Identifier: GPL-3.0-or-later
// The curriculum that trainees follow, with all its installed versions.
#pragma once

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"
#include "assessment/curriculum/rating_rule.h"
#include "assessment/forms/observer_form.h"

namespace fulcrum::app {

/// Throws InputError.
inline Curriculum installed_curriculum() {
    Curriculum newest = load_versions(asset_path("curricula"), "rectal", task_ids());
    check_ratings(newest, load_forms(asset_path("forms")));
    return newest;
}

}  // namespace fulcrum::app
