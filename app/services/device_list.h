// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of device: whether one is connected, whether it can be used, why not, and what to do.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ui/services/device_service.h"

namespace fulcrum::app {

using ui::device_states;
using ui::DeviceState;
using ui::ListedDevice;

/// What this machine has. `usb`: the folder of the system's list of USB devices. `daemon`: the path of
/// fulcrum-hapticd. `display`: a window can be opened. `mice`: the names of the mice that can be read one by
/// one.
std::vector<ListedDevice> list_devices(const std::string& usb, const std::string& daemon, bool display,
                                       const std::vector<std::string>& mice);
/// Those of this machine, as `fulcrum devices` lists them. The screen is asked at once, on the window's
/// thread; the function that is returned reads the system's files and may run on any.
std::function<std::vector<ListedDevice>()> devices_of_machine();
nlohmann::json devices_json(const std::vector<ListedDevice>& devices);

}  // namespace fulcrum::app
