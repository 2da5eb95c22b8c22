// SPDX-License-Identifier: Apache-2.0
// What a fidelity costs in processor time and in score, as `fulcrum lab fidelity` measured it
// (assets/fidelity_cost.json).
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum {

/// One fidelity at one task, compared with the finest one: synthetic operators performed the task with both.
struct FidelityCost {
    std::string fidelity;
    double processor_ms = 0;   ///< for one simulated second
    std::string metric, hand;  ///< the assessed metric that differs most; empty: none differs
    double shift_percent = 0;  ///< of its mean
    int verdicts = 0;          ///< attempts with another verdict
    int attempts = 0;
};
/// One task.
struct TaskFidelityCost {
    std::string cheapest;  ///< no assessed metric moves by more than 2 % and no verdict changes
    std::vector<FidelityCost> levels;
    // What was measured.
    std::string commit = {};                  ///< of the program
    int physics = 0;                          ///< its physics_version
    std::string limits = {};                  ///< name of the benchmark set with its version; empty: none
    std::map<std::string, int> metrics = {};  ///< version of each gated metric; empty: not recorded

    /// The simulation is that of this program. Metrics and limits: database/scoring/fidelity_now.h.
    bool of_this_physics() const;
};
/// The whole file. Each task has what it was measured with: tasks are measured at different times.
struct FidelityCosts {
    std::map<std::string, TaskFidelityCost> tasks;
};

nlohmann::json fidelity_costs_to_json(const FidelityCosts& costs);
/// Throws InputError with file, JSON pointer and hint.
FidelityCosts parse_fidelity_costs(const std::string& text, const std::string& file);
/// Of the assets in use, whatever it was measured with; empty without a file. Throws InputError for an
/// invalid file.
std::optional<FidelityCosts> fidelity_costs();
/// For one task; empty also where the task was not measured. Throws InputError as fidelity_costs().
std::optional<TaskFidelityCost> fidelity_cost(const std::string& task);

}  // namespace fulcrum
