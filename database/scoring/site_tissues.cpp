// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/site_tissues.h"

#include <optional>

#include "database/records/tissues.h"
#include "database/scoring/loaded_task.h"
#include "database/scoring/scoring.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/cutting_values.h"

namespace fulcrum {
namespace {

/// The site's values in place of the scene's, whether they fit it or not; those of tissues that the scene
/// does not have are left out.
CuttingValues put_over(CuttingValues scene, const database::TissueValues& site) {
    for (auto& [tissue, values] : scene) {
        const auto own = site.find(tissue);
        if (own == site.end()) continue;
        for (auto& [key, value] : values) {
            const auto found = own->second.find(key);
            if (found != own->second.end()) value = found->second;
        }
    }
    return scene;
}

}  // namespace

SiteTissues site_tissues(const database::Store& store, const database::Session& session,
                         const std::string& task_id) {
    const CuttingValues scene = cutting_values(load_task_and_scene(task_id).scene);
    const database::TissueSetting set = database::Tissues(store).in_force(session, task_id);
    SiteTissues site;
    site.version = set.version;
    std::optional<LoadedTask> here;
    try {
        here = load_site_task(store, session, {task_id, {}, {}});
    } catch (const InputError& error) {
        site.unusable = error.sentence();
    }
    const CuttingValues in_force = here ? cutting_values(here->scene) : put_over(scene, set.values);
    site.differ = !here || !cutting_difference(in_force, scene).empty();
    for (const auto& [tissue, values] : scene) {
        for (const CuttingKey& key : cutting_keys) {
            const CuttingRange range = cutting_range(key.key);
            site.values.push_back({tissue, key.key, key.words, key.unit, range.words, values.at(key.key),
                                   in_force.at(tissue).at(key.key), range.minimum, range.maximum,
                                   range.above});
        }
    }
    if (!here) return site;
    for (const DeviceClass one : here->task.device_classes) {
        const Limits limits = limits_for(here->task, here->scene, one);
        const Statement& why = limits.not_comparable;
        if (why.id() == StatementId::limits_outdated || (limits.set && !why.empty()))
            site.limits_notes.push_back({one, why});
    }
    return site;
}

int set_site_tissues(const database::Store& store, const database::Session& session,
                     const std::string& task_id, int seen, const database::TissueValues& values,
                     const std::string& reason) {
    store.require(session, database::Operation::set_tissues);
    const CuttingValues scene = cutting_values(load_task_and_scene(task_id).scene);
    load_task_and_scene({task_id, {}, {}}, values, "tissue values of " + task_id);
    database::TissueValues kept;
    for (const auto& [tissue, named] : values) {
        for (const auto& [key, value] : named) {
            if (scene.at(tissue).at(key) != value) kept[tissue][key] = value;
        }
    }
    return database::Tissues(store).set(session, task_id, seen, kept, reason);
}

}  // namespace fulcrum
