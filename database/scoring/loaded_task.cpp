// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/loaded_task.h"

#include <filesystem>

#include "assessment/assets/assets.h"
#include "database/records/tissues.h"
#include "database/rows/crypto.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/fidelity.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/standard_names.h"

namespace fulcrum {
namespace {

struct TaskFile {
    TaskDefinition task;
    database::AssetFile file;
};

/// Read once, so that the digest is that of what was understood.
TaskFile read_task(const std::string& task_id) {
    const std::string path = task_file(task_id);
    const std::string text = read_text_file(path, JsonLimits().bytes);
    return {parse_task(text, path),
            {"tasks/" + std::filesystem::path(path).filename().string(), database::sha256_hex(text)}};
}

LoadedTask load(TaskFile task, std::string scene_file, std::string scene_text, const std::string& file,
                const std::string& fidelity) {
    LoadedTask loaded{std::move(task.task),
                      parse_scene(scene_text, file),
                      std::move(scene_file),
                      {},
                      {std::move(task.file)}};
    loaded.scene_text = std::move(scene_text);
    if (!fidelity.empty()) loaded.scene.fidelity = named_fidelity(fidelity);
    return loaded;
}

}  // namespace

LoadedTask load_task_and_scene(const TaskRequest& request, const CuttingValues& cutting,
                               const std::string& source) {
    TaskFile task = read_task(request.task_id);
    const TaskVariant variant = require_variant(task.task, request.variant);
    const bool listed = task.task.variants.size() > 1;
    const std::string name = "scenes/" + variant.scene, path = asset_path(name);
    const std::string text = read_text_file(path, JsonLimits().bytes);
    LoadedTask loaded =
        load(std::move(task), variant.scene,
             with_cutting_values(text, source.empty() ? path : source, cutting), path, request.fidelity);
    if (listed && loaded.scene.variant != variant.id)
        throw InputError(path, "/variant",
                         {QT_TRANSLATE_NOOP("errors", "is \"%1\", but task %2 lists it as \"%3\""),
                          loaded.scene.variant, request.task_id, variant.id},
                         QT_TRANSLATE_NOOP("errors", "write the same id in both files"));
    loaded.assets.push_back({name, database::sha256_hex(text)});
    return loaded;
}

LoadedTask load_task_and_scene(const std::string& task_id, const std::string& fidelity) {
    return load_task_and_scene(TaskRequest{task_id, {}, fidelity});
}

LoadedTask load_site_task(const database::Store& store, const database::Session& session,
                          const TaskRequest& request) {
    const database::TissueSetting site = database::Tissues(store).in_force(session, request.task_id);
    return load_task_and_scene(
        request, site.values,
        "this site's values of " + request.task_id + ", version " + std::to_string(site.version));
}

LoadedTask load_recorded(const database::Attempts& attempts, const database::Session& session,
                         const database::AttemptSummary& summary) {
    return load_recorded(attempts.scene_text(session, summary.meta.id), summary);
}

LoadedTask load_recorded(const std::string& text, const database::AttemptSummary& summary) {
    const std::string fidelity =
        summary.meta.fidelity == standard_fidelity ? std::string() : summary.meta.fidelity;
    if (text.empty()) return load_task_and_scene({summary.meta.task_id, summary.meta.variant, fidelity});
    return load(read_task(summary.meta.task_id), summary.meta.scene, text,
                "scene of attempt " + summary.meta.id, fidelity);
}

}  // namespace fulcrum
