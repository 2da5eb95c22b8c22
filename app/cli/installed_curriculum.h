// SPDX-License-Identifier: GPL-3.0-or-later
// The curriculum that trainees follow, with all its installed versions.
#pragma once

#include "assessment/assets/assets.h"
#include "assessment/curriculum/curriculum.h"

namespace fulcrum::app {

/// Throws InputError.
inline Curriculum installed_curriculum() {
    return load_versions(asset_path("curricula"), "rectal", task_ids());
}

}  // namespace fulcrum::app
