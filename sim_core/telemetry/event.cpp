// SPDX-License-Identifier: Apache-2.0
#include "sim_core/telemetry/event.h"

namespace fulcrum {

const char* event_name(EventKind kind) {
    switch (kind) {
        case EventKind::attempt_begin: return "attempt_begin";
        case EventKind::first_movement: return "first_movement";
        case EventKind::phase_begin: return "phase_begin";
        case EventKind::phase_end: return "phase_end";
        case EventKind::target_shown: return "target_shown";
        case EventKind::target_reached: return "target_reached";
        case EventKind::grasp: return "grasp";
        case EventKind::release: return "release";
        case EventKind::slip: return "slip";
        case EventKind::drop: return "drop";
        case EventKind::regrasp: return "regrasp";
        case EventKind::over_force_begin: return "over_force_begin";
        case EventKind::over_force_end: return "over_force_end";
        case EventKind::perforation: return "perforation";
        case EventKind::tool_collision: return "tool_collision";
        case EventKind::wall_contact: return "wall_contact";
        case EventKind::pause: return "pause";
        case EventKind::resume: return "resume";
        case EventKind::device_lost: return "device_lost";
        case EventKind::device_back: return "device_back";
        case EventKind::device_fault: return "device_fault";
        case EventKind::world_late: return "world_late";
        case EventKind::simulator_fault: return "simulator_fault";
        case EventKind::stability_limited: return "stability_limited";
        case EventKind::goal_progress: return "goal_progress";
        case EventKind::completed: return "completed";
        case EventKind::abandoned: return "abandoned";
        case EventKind::timed_out: return "timed_out";
        case EventKind::interrupted: return "interrupted";
        case EventKind::samples_lost: return "samples_lost";
        case EventKind::tear: return "tear";
        case EventKind::jaw_pressure: return "jaw_pressure";
        case EventKind::cut_begin: return "cut_begin";
        case EventKind::cut_end: return "cut_end";
        case EventKind::cut_advance: return "cut_advance";
        case EventKind::cut_traction: return "cut_traction";
        case EventKind::cut_rolled_back: return "cut_rolled_back";
        case EventKind::piece_fallen: return "piece_fallen";
        case EventKind::activation_begin: return "activation_begin";
        case EventKind::activation_end: return "activation_end";
        case EventKind::band_divided: return "band_divided";
        case EventKind::bleed_begin: return "bleed_begin";
        case EventKind::bleed_end: return "bleed_end";
        case EventKind::blood_loss: return "blood_loss";
        case EventKind::clip_applied: return "clip_applied";
        case EventKind::heat_dose: return "heat_dose";
        case EventKind::vessel_injury: return "vessel_injury";
        case EventKind::nerve_injury: return "nerve_injury";
        case EventKind::tool_exchanged: return "tool_exchanged";
        case EventKind::fibres_parted: return "fibres_parted";
    }
    return "unknown";
}

}  // namespace fulcrum
