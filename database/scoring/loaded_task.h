// SPDX-License-Identifier: GPL-3.0-or-later
// A task with its scene: from the assets, with this site's values of the tissues, or as an attempt used it.
#pragma once

#include <string>
#include <vector>

#include "assessment/task/task.h"
#include "database/records/attempts.h"
#include "database/store/store.h"
#include "sim_core/scene/cutting_values.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// A task with everything it needs.
struct LoadedTask {
    TaskDefinition task;
    Scene scene;
    std::string scene_file;                   ///< name in assets/scenes
    std::string scene_text;                   ///< what `scene` was read from, its fidelity aside
    std::vector<database::AssetFile> assets;  ///< the files of task and scene, as they were read
};
/// What of a task is to be loaded.
struct TaskRequest {
    std::string task_id;
    std::string variant = {};   ///< "": the standard one
    std::string fidelity = {};  ///< "": the scene's own
};
/// Throws InputError. `cutting`: values in place of the scene file's own; errors about them name `source`.
LoadedTask load_task_and_scene(const TaskRequest& request, const CuttingValues& cutting = {},
                               const std::string& source = {});
/// The standard variant.
LoadedTask load_task_and_scene(const std::string& task_id, const std::string& fidelity = {});
/// With the values that this site has set for the task's tissues. Throws InputError, AccessDenied.
LoadedTask load_site_task(const database::Store& store, const database::Session& session,
                          const TaskRequest& request);
/// As a stored attempt used it: the scene from its record; from the assets where the record has none (older
/// programs). Throws InputError (the task is not known here), AccessDenied, StoreError.
LoadedTask load_recorded(const database::Attempts& attempts, const database::Session& session,
                         const database::AttemptSummary& summary);
/// The same with the scene's text at hand ("": from the assets).
LoadedTask load_recorded(const std::string& scene_text, const database::AttemptSummary& summary);

}  // namespace fulcrum
