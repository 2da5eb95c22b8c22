// SPDX-License-Identifier: GPL-3.0-or-later
// What an attempt in one scene is made with.
#pragma once

#include <algorithm>
#include <iterator>

#include "sim_core/scene/scene.h"
#include "ui/services/device_service.h"

namespace fulcrum::ui {

/// The device in use, with class and title of mouse and keyboard where it moves nothing that the scene has: a
/// device for two hands in a task of the scope. Of a device that is not open yet this is not known.
inline DeviceInUse device_in_scene(DeviceInUse device, const Scene& scene) {
    const bool is_known =
        std::any_of(std::begin(device.drives), std::end(device.drives), [](bool drives) { return drives; });
    bool moves = device.drives[hand_count] && scene.camera.has_value();
    for (int h = 0; h < hand_count; ++h)
        moves = moves || (device.drives[h] && scene.instrument(static_cast<Hand>(h)) != nullptr);
    if (is_known && !moves) {
        const DeviceInUse mouse{};
        device.device_class = mouse.device_class;
        device.title = mouse.title;
    }
    return device;
}

}  // namespace fulcrum::ui
