// SPDX-License-Identifier: Apache-2.0
#include "assessment/assets/fidelity_cost.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "assessment/assets/assets.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/world/physics_version.h"

namespace fulcrum {

extern const char* const fidelity_cost_schema_text;

bool TaskFidelityCost::of_this_physics() const {
    return physics == physics_version;
}

nlohmann::json fidelity_costs_to_json(const FidelityCosts& costs) {
    nlohmann::json tasks = nlohmann::json::object();
    for (const auto& [id, task] : costs.tasks) {
        nlohmann::json levels = nlohmann::json::array();
        for (const FidelityCost& level : task.levels)
            levels.push_back({{"fidelity", level.fidelity},
                              {"processor_ms", level.processor_ms},
                              {"metric", level.metric},
                              {"hand", level.hand},
                              {"shift_percent", level.shift_percent},
                              {"verdicts", level.verdicts},
                              {"attempts", level.attempts}});
        tasks[id] = {{"cheapest", task.cheapest}, {"levels", levels},      {"commit", task.commit},
                     {"physics", task.physics},   {"limits", task.limits}, {"metrics", task.metrics}};
    }
    return {{"$comment", "SPDX-License-Identifier: Apache-2.0"}, {"tasks", tasks}};
}

FidelityCosts parse_fidelity_costs(const std::string& text, const std::string& file) {
    const JsonDocument document = JsonDocument::parse(text, file);
    document.check_schema(fidelity_cost_schema_text);
    FidelityCosts costs;
    for (const auto& [id, node] : document.root().at("tasks").items()) {
        TaskFidelityCost& task = costs.tasks[id];
        task.cheapest = node.at("cheapest").get<std::string>();
        task.commit = node.at("commit").get<std::string>();
        task.physics = node.at("physics").get<int>();
        task.limits = node.at("limits").get<std::string>();
        task.metrics = node.at("metrics").get<std::map<std::string, int>>();
        for (const auto& row : node.at("levels")) {
            FidelityCost level;
            level.fidelity = row.at("fidelity").get<std::string>();
            level.processor_ms = row.at("processor_ms").get<double>();
            level.metric = row.at("metric").get<std::string>();
            level.hand = row.at("hand").get<std::string>();
            level.shift_percent = row.at("shift_percent").get<double>();
            level.verdicts = row.at("verdicts").get<int>();
            level.attempts = row.at("attempts").get<int>();
            task.levels.push_back(std::move(level));
        }
    }
    return costs;
}

std::optional<FidelityCosts> fidelity_costs() {
    const std::string path = asset_path("fidelity_cost.json");
    if (!std::filesystem::exists(path)) return std::nullopt;
    return parse_fidelity_costs(read_text_file(path, JsonLimits().bytes), path);
}

std::optional<TaskFidelityCost> fidelity_cost(const std::string& task) {
    const std::optional<FidelityCosts> costs = fidelity_costs();
    if (!costs) return std::nullopt;
    const auto found = costs->tasks.find(task);
    if (found == costs->tasks.end()) return std::nullopt;
    return found->second;
}

}  // namespace fulcrum
