// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of device: whether one is connected, whether it can be used, why not, and what to do.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim_core/controllers/game_controller.h"
#include "sim_core/devices/maker_library.h"
#include "sim_core/devices/usb_devices.h"
#include "ui/services/device_service.h"

namespace fulcrum::app {

using ui::device_states;
using ui::DeviceState;
using ui::ListedDevice;

/// What the list is made from.
struct Machine {
    UsbFolders usb;
    std::string daemon;                                   ///< path of fulcrum-hapticd
    bool display = false;                                 ///< a window can be opened
    std::vector<std::string> mice;                        ///< names of the mice that can be read one by one
    std::function<bool(const std::string&)> may_open;     ///< this person may read and write the file
    std::function<LibraryLook(const std::string&)> look;  ///< at the library for a kind of device
    std::function<ControllerLook()> controllers;
    std::string sockets;        ///< folder with the system's lists of sockets, /proc/net
    std::string spacenavd;      ///< path of its socket
    std::string joystick_file;  ///< with the calibration of joysticks
    std::string sends_at;       ///< address at which this program sends over OpenIGTLink; empty: it does not
};
std::vector<ListedDevice> list_devices(const Machine& machine);
/// Those of this machine, as `fulcrum devices` lists them. The screen is asked at once, on the window's
/// thread; the function that is returned reads the system's files and may run on any. `sends_at`: as in
/// Machine.
std::function<std::vector<ListedDevice>()> devices_of_machine(const std::string& sends_at = {});
nlohmann::json devices_json(const std::vector<ListedDevice>& devices);

}  // namespace fulcrum::app
