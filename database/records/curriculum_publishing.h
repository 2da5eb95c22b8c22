// SPDX-License-Identifier: GPL-3.0-or-later
// A new version of the curriculum comes into force at this station, and at the others with the next exchange
// (database/scoring/asset_placing.h): its file next to the versions before it,
// accepted for assessed attempts with a reason. People stay on the version that they follow.
#pragma once

#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "assessment/forms/observer_form.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct CurriculumPublishing {
    std::string folder;  ///< assets/curricula
    std::vector<InstalledTask> tasks;
    std::vector<ObserverForm> forms;
};

/// `text`: of the version that is to come after `follows`, which its author saw in force. All or nothing: of
/// two at once one is refused. Returns the file's path. Operation::accept_assets; audited as asset.accept.
/// Throws InputError (the text is not valid), AccessDenied, StoreError bad_value (no reason), conflict
/// (another version than `follows` is in force, or the programme has one that is not in the folder yet),
/// read_only (the folder cannot be written).
std::string publish_curriculum(const Store& store, const Session& educator, const CurriculumPublishing& place,
                               const Curriculum& follows, const std::string& text, const std::string& reason);

}  // namespace fulcrum::database
