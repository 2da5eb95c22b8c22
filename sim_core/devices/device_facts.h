// SPDX-License-Identifier: Apache-2.0
// What a device is, as fulcrum-hapticd reports it. Constant while the device is open.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim_core/devices/device_page.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/workspace.h"

namespace fulcrum {

struct DeviceFacts {
    std::string kind;                     ///< "virtual"
    std::string title;                    ///< for people
    double rate = 1000;                   ///< Hz
    bool slot[device_slots] = {};         ///< it has this slot
    std::optional<ForceOutput> force[2];  ///< of each hand; scale 1
    /// Where each slot can be moved; none: not known.
    std::optional<WorkspaceBox> workspace[device_slots];
    bool clutch[device_slots] = {};  ///< one of its buttons is the clutch
    std::string firmware;            ///< versions that its library states, in no language; empty: none
};

nlohmann::json to_json(const DeviceFacts& facts);
/// Throws nlohmann::json::exception for a document that to_json() did not make, std::runtime_error for values
/// out of range.
DeviceFacts facts_from_json(const nlohmann::json& document);

}  // namespace fulcrum
