// SPDX-License-Identifier: Apache-2.0
// What each kind of event is called: in exports (docs/FORMATS.md) and on screens.
#pragma once

#include "sim_core/numerics/name_table.h"
#include "sim_core/telemetry/event.h"

namespace fulcrum {

inline constexpr NameRow<EventKind> event_kinds[] = {
    {EventKind::attempt_begin, "attempt_begin", QT_TRANSLATE_NOOP("fulcrum::events", "attempt begins")},
    {EventKind::first_movement, "first_movement", QT_TRANSLATE_NOOP("fulcrum::events", "first movement")},
    {EventKind::phase_begin, "phase_begin", QT_TRANSLATE_NOOP("fulcrum::events", "step begins")},
    {EventKind::phase_end, "phase_end", QT_TRANSLATE_NOOP("fulcrum::events", "step ends")},
    {EventKind::target_shown, "target_shown", QT_TRANSLATE_NOOP("fulcrum::events", "target shown")},
    {EventKind::target_reached, "target_reached", QT_TRANSLATE_NOOP("fulcrum::events", "target held")},
    {EventKind::grasp, "grasp", QT_TRANSLATE_NOOP("fulcrum::events", "grasp")},
    {EventKind::release, "release", QT_TRANSLATE_NOOP("fulcrum::events", "release")},
    {EventKind::slip, "slip", QT_TRANSLATE_NOOP("fulcrum::events", "tissue slipped out of the jaws")},
    {EventKind::drop, "drop", QT_TRANSLATE_NOOP("fulcrum::events", "object dropped")},
    {EventKind::regrasp, "regrasp", QT_TRANSLATE_NOOP("fulcrum::events", "same place grasped again")},
    {EventKind::over_force_begin, "over_force_begin", QT_TRANSLATE_NOOP("fulcrum::events", "too much force")},
    {EventKind::over_force_end, "over_force_end",
     QT_TRANSLATE_NOOP("fulcrum::events", "force back within the limit")},
    {EventKind::perforation, "perforation", QT_TRANSLATE_NOOP("fulcrum::events", "perforation")},
    {EventKind::tool_collision, "tool_collision",
     QT_TRANSLATE_NOOP("fulcrum::events", "collision of instruments")},
    {EventKind::wall_contact, "wall_contact", QT_TRANSLATE_NOOP("fulcrum::events", "contact with the wall")},
    {EventKind::pause, "pause", QT_TRANSLATE_NOOP("fulcrum::events", "pause")},
    {EventKind::resume, "resume", QT_TRANSLATE_NOOP("fulcrum::events", "resumed")},
    {EventKind::device_lost, "device_lost", QT_TRANSLATE_NOOP("fulcrum::events", "device lost")},
    {EventKind::device_back, "device_back", QT_TRANSLATE_NOOP("fulcrum::events", "device back")},
    {EventKind::device_fault, "device_fault",
     QT_TRANSLATE_NOOP("fulcrum::events", "device gave an impossible reading")},
    {EventKind::world_late, "world_late", QT_TRANSLATE_NOOP("fulcrum::events", "simulation late")},
    {EventKind::simulator_fault, "simulator_fault", QT_TRANSLATE_NOOP("fulcrum::events", "simulator fault")},
    {EventKind::stability_limited, "stability_limited",
     QT_TRANSLATE_NOOP("fulcrum::events", "stiffness limited")},
    {EventKind::goal_progress, "goal_progress", QT_TRANSLATE_NOOP("fulcrum::events", "progress")},
    {EventKind::completed, "completed", QT_TRANSLATE_NOOP("fulcrum::events", "completed")},
    {EventKind::abandoned, "abandoned", QT_TRANSLATE_NOOP("fulcrum::events", "abandoned")},
    {EventKind::timed_out, "timed_out", QT_TRANSLATE_NOOP("fulcrum::events", "time limit reached")},
    {EventKind::interrupted, "interrupted", QT_TRANSLATE_NOOP("fulcrum::events", "interrupted")},
    {EventKind::samples_lost, "samples_lost", QT_TRANSLATE_NOOP("fulcrum::events", "samples lost")},
    {EventKind::tear, "tear", QT_TRANSLATE_NOOP("fulcrum::events", "tear")},
    {EventKind::jaw_pressure, "jaw_pressure",
     QT_TRANSLATE_NOOP("fulcrum::events", "jaw pressure above the limit")},
    {EventKind::cut_begin, "cut_begin", QT_TRANSLATE_NOOP("fulcrum::events", "cut begins")},
    {EventKind::cut_end, "cut_end", QT_TRANSLATE_NOOP("fulcrum::events", "cut ends")},
    {EventKind::cut_advance, "cut_advance", QT_TRANSLATE_NOOP("fulcrum::events", "cut advances")},
    {EventKind::cut_traction, "cut_traction",
     QT_TRANSLATE_NOOP("fulcrum::events", "traction across the cut")},
    {EventKind::cut_rolled_back, "cut_rolled_back",
     QT_TRANSLATE_NOOP("fulcrum::events", "step of the cut undone")},
    {EventKind::piece_fallen, "piece_fallen", QT_TRANSLATE_NOOP("fulcrum::events", "piece came free")},
    {EventKind::activation_begin, "activation_begin", QT_TRANSLATE_NOOP("fulcrum::events", "energy on")},
    {EventKind::activation_end, "activation_end", QT_TRANSLATE_NOOP("fulcrum::events", "energy off")},
    {EventKind::band_divided, "band_divided", QT_TRANSLATE_NOOP("fulcrum::events", "band divided")},
    {EventKind::bleed_begin, "bleed_begin", QT_TRANSLATE_NOOP("fulcrum::events", "bleeding begins")},
    {EventKind::bleed_end, "bleed_end", QT_TRANSLATE_NOOP("fulcrum::events", "bleeding stopped")},
    {EventKind::blood_loss, "blood_loss", QT_TRANSLATE_NOOP("fulcrum::events", "blood loss")},
    {EventKind::clip_applied, "clip_applied", QT_TRANSLATE_NOOP("fulcrum::events", "clip")},
    {EventKind::heat_dose, "heat_dose", QT_TRANSLATE_NOOP("fulcrum::events", "heat dose")},
    {EventKind::vessel_injury, "vessel_injury", QT_TRANSLATE_NOOP("fulcrum::events", "vessel injury")},
    {EventKind::nerve_injury, "nerve_injury", QT_TRANSLATE_NOOP("fulcrum::events", "nerve injury")},
    {EventKind::tool_exchanged, "tool_exchanged",
     QT_TRANSLATE_NOOP("fulcrum::events", "instrument exchanged")},
    {EventKind::fibres_parted, "fibres_parted",
     QT_TRANSLATE_NOOP("fulcrum::events", "fibres tore under too much tension")},
    {EventKind::heat_area, "heat_area", QT_TRANSLATE_NOOP("fulcrum::events", "area of dead tissue")},
};
static_assert(in_order(event_kinds));

}  // namespace fulcrum
