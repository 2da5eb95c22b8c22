// SPDX-License-Identifier: GPL-3.0-or-later
// The hands' devices of an attempt as a text of the store (docs/FORMATS.md, The store): what each could
// render, how it was set up and how often it was read.
#pragma once

#include <optional>
#include <string>

#include "sim_core/instrument/device.h"

namespace fulcrum::database {

/// Compact JSON, the shortest digits that read back to the same numbers; empty where no device rendered
/// force and no use is given.
std::string force_devices_text(const ForceDevices& devices, const std::optional<RigUse>& use = std::nullopt);
/// The reverse. Throws StoreError corrupt, naming `place`, if the text is not one that force_devices_text
/// makes.
ForceDevices force_devices_of(const std::string& text, const std::string& place);
/// None in texts without it. Throws as above.
std::optional<RigUse> rig_use_of(const std::string& text, const std::string& place);

/// The device of an attempt for exports: a JSON object with its title and, where it is known, its use.
std::string device_json(const std::string& title, const std::optional<RigUse>& use);

}  // namespace fulcrum::database
