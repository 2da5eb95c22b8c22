// SPDX-License-Identifier: Apache-2.0
// The classes of devices. Scores are held against sets of the same class.
#pragma once

#include <cstdint>

#include "sim_core/numerics/name_table.h"

namespace fulcrum {

/// What the hands moved.
enum class DeviceClass : std::uint8_t { haptic, tracked, controller, mouse_keyboard, synthetic, external };
inline constexpr NameRow<DeviceClass> device_classes[] = {
    {DeviceClass::haptic, "haptic", QT_TRANSLATE_NOOP("fulcrum::devices", "haptic device")},
    {DeviceClass::tracked, "tracked", QT_TRANSLATE_NOOP("fulcrum::devices", "tracked instruments")},
    {DeviceClass::controller, "controller", QT_TRANSLATE_NOOP("fulcrum::devices", "game controller")},
    {DeviceClass::mouse_keyboard, "mouse-keyboard",
     QT_TRANSLATE_NOOP("fulcrum::devices", "mouse and keyboard")},
    {DeviceClass::synthetic, "synthetic", QT_TRANSLATE_NOOP("fulcrum::devices", "synthetic operator")},
    {DeviceClass::external, "external", QT_TRANSLATE_NOOP("fulcrum::devices", "external trace")}};
static_assert(in_order(device_classes));

}  // namespace fulcrum
