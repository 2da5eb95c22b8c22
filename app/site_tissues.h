// SPDX-License-Identifier: GPL-3.0-or-later
// A site's values of what blades meet in a task's tissues: shown beside the scene file's own, and set. One
// path for window and command line.
#pragma once

#include <string>

#include "database/store/store.h"
#include "ui/page/application_services.h"

namespace fulcrum::app {

/// Throws InputError (task unknown, the site's values no longer fit its scene), AccessDenied.
ui::SiteTissues site_tissues(const database::Store& store, const database::Session& session,
                             const std::string& task_id);

/// Checks the values against the scene, then sets them: what equals the scene file's own is left out, so that
/// a later scene file's value counts there. Throws InputError naming tissue, value and hint; as
/// database::Tissues::set(). Returns the new version.
int set_site_tissues(const database::Store& store, const database::Session& session,
                     const std::string& task_id, int seen, const database::TissueValues& values,
                     const std::string& reason);

}  // namespace fulcrum::app
