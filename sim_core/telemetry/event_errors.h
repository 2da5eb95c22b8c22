// SPDX-License-Identifier: Apache-2.0
// Which events are errors of whoever performs, as the program records them by itself. What a device or the
// simulation did wrong is none, nor is a choice that only a limit judges (energy near a nerve, a second
// grasp).
#pragma once

#include "sim_core/telemetry/event.h"

namespace fulcrum {

enum class ErrorWeight : std::uint8_t {
    none,
    error,
    critical  ///< injury of what must stay whole
};

constexpr ErrorWeight error_weight(EventKind kind) {
    switch (kind) {
        case EventKind::slip:
        case EventKind::drop:
        case EventKind::over_force_begin:
        case EventKind::tool_collision:
        case EventKind::tear:
        case EventKind::jaw_pressure:
        case EventKind::bleed_begin:
        case EventKind::fibres_parted:
        case EventKind::lens_contact:
            return ErrorWeight::error;
        case EventKind::perforation:
        case EventKind::vessel_injury:
        case EventKind::nerve_injury:
            return ErrorWeight::critical;
        default:
            return ErrorWeight::none;
    }
}

constexpr bool is_error(EventKind kind) {
    return error_weight(kind) != ErrorWeight::none;
}

}  // namespace fulcrum
