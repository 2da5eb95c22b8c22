// SPDX-License-Identifier: Apache-2.0
// The messages of the Inverse service of Haply, versions 3.1 to 3.5 (docs/BIBLIOGRAPHY.md): JSON, metres,
// newtons, its own right-handed frame (x to the right, y away from the person, z up).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum::haply {

struct Inverse3 {
    std::string id;
    std::string handedness;           ///< "left", "right"; empty where it is not reported
    std::optional<Vector3> position;  ///< m, finite
    std::optional<Vector3> force;     ///< N, what the service reports to render
    bool calibrated = true, powered = true;
    bool in_use = false;  ///< by any session of the service, also by the one that reads this
};

struct Grip {
    std::string id;
    std::optional<Quaternion> orientation;  ///< of length 1
    bool button[3] = {false, false, false};
};

/// The inventory after connecting, and each answer to a command.
struct Message {
    std::vector<Inverse3> devices;
    std::vector<Grip> grips;
};

enum class Understood {
    yes,
    not_json,
    other_service,  ///< JSON, but not of these versions
    refused,        ///< the service refuses a command
    not_numbers     ///< a position or an orientation cannot be used; the rest of the message is read
};
Understood read_message(const std::string& text, Message& message);

/// What the event channel reports.
struct Event {
    std::string name;    ///< "device-disconnected", "device-safety-triggered", …
    std::string device;  ///< empty where it does not say which
};
std::optional<Event> read_event(const std::string& text);

/// How a force is written: version 3.5 takes "vector", version 3.1 "values".
enum class ForceForm { vector, values };
/// N, in the service's frame. Without forces: an empty message.
std::string force_command(const std::vector<std::pair<std::string, Vector3>>& forces, ForceForm form);

}  // namespace fulcrum::haply
