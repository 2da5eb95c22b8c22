// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of device: whether one is connected, whether it can be used, why not, and what to do.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "assessment/task/attempt_words.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum::app {

enum class DeviceState : std::uint8_t { usable, connected, absent };
inline constexpr NameRow<DeviceState> device_states[] = {
    {DeviceState::usable, "usable", QT_TRANSLATE_NOOP("fulcrum::device_states", "can be used")},
    {DeviceState::connected, "connected",
     QT_TRANSLATE_NOOP("fulcrum::device_states", "connected, cannot be used")},
    {DeviceState::absent, "absent", QT_TRANSLATE_NOOP("fulcrum::device_states", "not connected")}};
static_assert(in_order(device_states));

/// One line of `fulcrum devices`.
struct ListedDevice {
    std::string kind, title;
    DeviceClass device_class = DeviceClass::haptic;
    DeviceState state = DeviceState::absent;
    std::vector<std::string> found;  ///< what is connected
    std::string why, what_to_do;     ///< empty where it can be used
};

/// What this machine has. `usb`: the folder of the system's list of USB devices. `daemon`: the path of
/// fulcrum-hapticd. `display`: a window can be opened. `mice`: the names of the mice that can be read one by
/// one.
std::vector<ListedDevice> list_devices(const std::string& usb, const std::string& daemon, bool display,
                                       const std::vector<std::string>& mice);
nlohmann::json devices_json(const std::vector<ListedDevice>& devices);

}  // namespace fulcrum::app
