// SPDX-License-Identifier: GPL-3.0-or-later
// A site's values for cutting a task's tissues: shown next to those of the scene file, and set. Used by
// window and command line.
#pragma once

#include <string>
#include <vector>

#include "assessment/metrics/statement.h"
#include "assessment/task/attempt_words.h"
#include "database/records/tissues.h"
#include "database/store/store.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

/// One value that a site may set in place of the scene file's.
struct SiteTissueValue {
    std::string tissue, key;
    std::string words, unit, range;  ///< for screens
    double scene = 0;                ///< what the scene file says
    double value = 0;                ///< what is in force
    double minimum = 0, maximum = 0;
    bool above = false;  ///< the minimum itself is excluded
};

/// Why attempts with this class of devices are not compared with the set that is there for them.
struct LimitsNote {
    DeviceClass device_class = DeviceClass::haptic;
    Statement why;
};

/// The tissues of a task that blades cut.
struct SiteTissues {
    std::vector<SiteTissueValue> values;  ///< empty: the task cuts nothing by force
    int version = 0;                      ///< of the site's values in force; 0: never set
    bool differ = false;                  ///< from the scene file's
    /// Why no attempt can begin with the site's values: the scene file is another one since they were set.
    /// Empty where they fit it.
    Sentence unusable;
    std::vector<LimitsNote> limits_notes;  ///< of the classes with which the task is assessed
};

/// Throws InputError (task unknown), AccessDenied.
SiteTissues site_tissues(const database::Store& store, const database::Session& session,
                         const std::string& task_id);

/// Checks the values against the scene, then sets them: what equals the scene file's own is left out, so that
/// a later scene file's value counts there. Throws InputError naming tissue, value and hint; as
/// database::Tissues::set(). Returns the new version.
int set_site_tissues(const database::Store& store, const database::Session& session,
                     const std::string& task_id, int seen, const database::TissueValues& values,
                     const std::string& reason);

}  // namespace fulcrum
