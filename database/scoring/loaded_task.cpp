// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/loaded_task.h"

#include "assessment/assets/assets.h"
#include "database/records/tissues.h"
#include "sim_core/scene/fidelity.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {
namespace {

LoadedTask load(TaskDefinition task, std::string scene_text, const std::string& file,
                const std::string& fidelity) {
    LoadedTask loaded{std::move(task), parse_scene(scene_text, file), {}};
    loaded.scene_text = std::move(scene_text);
    if (!fidelity.empty()) loaded.scene.fidelity = named_fidelity(fidelity);
    return loaded;
}

}  // namespace

LoadedTask load_task_and_scene(const std::string& task_id, const std::string& fidelity,
                               const CuttingValues& cutting, const std::string& source) {
    TaskDefinition task = load_task(task_file(task_id));
    const std::string path = asset_path("scenes/" + task.scene);
    const std::string text = with_cutting_values(read_text_file(path, JsonLimits().bytes),
                                                 source.empty() ? path : source, cutting);
    return load(std::move(task), text, path, fidelity);
}

LoadedTask load_site_task(const database::Store& store, const database::Session& session,
                          const std::string& task_id, const std::string& fidelity) {
    const database::TissueSetting site = database::Tissues(store).in_force(session, task_id);
    return load_task_and_scene(
        task_id, fidelity, site.values,
        "this site's values of " + task_id + ", version " + std::to_string(site.version));
}

LoadedTask load_recorded(const database::Attempts& attempts, const database::Session& session,
                         const database::AttemptSummary& summary) {
    const std::string fidelity = summary.meta.fidelity == "standard" ? std::string() : summary.meta.fidelity;
    const std::string text = attempts.scene_text(session, summary.meta.id);
    if (text.empty()) return load_task_and_scene(summary.meta.task_id, fidelity);
    return load(load_task(task_file(summary.meta.task_id)), text, "scene of attempt " + summary.meta.id,
                fidelity);
}

}  // namespace fulcrum
