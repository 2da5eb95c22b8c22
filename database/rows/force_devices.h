// SPDX-License-Identifier: GPL-3.0-or-later
// Devices that rendered force in an attempt, as a text of the store (docs/FORMATS.md, The store).
#pragma once

#include <string>

#include "sim_core/instrument/device.h"

namespace fulcrum::database {

/// Compact JSON, the shortest digits that read back to the same numbers; empty where no device rendered
/// force.
std::string force_devices_text(const ForceDevices& devices);
/// The reverse. Throws StoreError corrupt, naming `place`, if the text is not one that force_devices_text
/// makes.
ForceDevices force_devices_of(const std::string& text, const std::string& place);

}  // namespace fulcrum::database
