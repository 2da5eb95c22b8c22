// SPDX-License-Identifier: Apache-2.0
#include "sim_core/telemetry/event.h"

#include <algorithm>

#include "sim_core/numerics/name_table.h"

namespace fulcrum {
namespace {

struct EventRow {
    EventKind kind;
    const char* name;  // in exports (docs/FORMATS.md); screens have sentences of their own
};
constexpr EventRow event_kinds[] = {
    {EventKind::attempt_begin, "attempt_begin"},
    {EventKind::first_movement, "first_movement"},
    {EventKind::phase_begin, "phase_begin"},
    {EventKind::phase_end, "phase_end"},
    {EventKind::target_shown, "target_shown"},
    {EventKind::target_reached, "target_reached"},
    {EventKind::grasp, "grasp"},
    {EventKind::release, "release"},
    {EventKind::slip, "slip"},
    {EventKind::drop, "drop"},
    {EventKind::regrasp, "regrasp"},
    {EventKind::over_force_begin, "over_force_begin"},
    {EventKind::over_force_end, "over_force_end"},
    {EventKind::perforation, "perforation"},
    {EventKind::tool_collision, "tool_collision"},
    {EventKind::wall_contact, "wall_contact"},
    {EventKind::pause, "pause"},
    {EventKind::resume, "resume"},
    {EventKind::device_lost, "device_lost"},
    {EventKind::device_back, "device_back"},
    {EventKind::device_fault, "device_fault"},
    {EventKind::world_late, "world_late"},
    {EventKind::simulator_fault, "simulator_fault"},
    {EventKind::stability_limited, "stability_limited"},
    {EventKind::goal_progress, "goal_progress"},
    {EventKind::completed, "completed"},
    {EventKind::abandoned, "abandoned"},
    {EventKind::timed_out, "timed_out"},
    {EventKind::interrupted, "interrupted"},
    {EventKind::samples_lost, "samples_lost"},
    {EventKind::tear, "tear"},
    {EventKind::jaw_pressure, "jaw_pressure"},
    {EventKind::cut_begin, "cut_begin"},
    {EventKind::cut_end, "cut_end"},
    {EventKind::cut_advance, "cut_advance"},
    {EventKind::cut_traction, "cut_traction"},
    {EventKind::cut_rolled_back, "cut_rolled_back"},
    {EventKind::piece_fallen, "piece_fallen"},
    {EventKind::activation_begin, "activation_begin"},
    {EventKind::activation_end, "activation_end"},
    {EventKind::band_divided, "band_divided"},
    {EventKind::bleed_begin, "bleed_begin"},
    {EventKind::bleed_end, "bleed_end"},
    {EventKind::blood_loss, "blood_loss"},
    {EventKind::clip_applied, "clip_applied"},
    {EventKind::heat_dose, "heat_dose"},
    {EventKind::vessel_injury, "vessel_injury"},
    {EventKind::nerve_injury, "nerve_injury"},
    {EventKind::tool_exchanged, "tool_exchanged"},
    {EventKind::fibres_parted, "fibres_parted"},
};
static_assert(in_order(event_kinds));

// As records have stored them from the first: bits of an activation; a nerve's number, and 256 more where a
// blade divided it.
constexpr std::int32_t in_view_bit = 1, on_target_bit = 2, clear_bit = 4;
constexpr std::int32_t divided_by_blade = 256;
constexpr double micrometre = 1e-6;

}  // namespace

const char* event_name(EventKind kind) {
    const auto number = static_cast<std::size_t>(kind);
    return number < std::size(event_kinds) ? event_kinds[number].name : "unknown";
}

std::int32_t detail_of(const Activation& activation) {
    return (activation.in_view ? in_view_bit : 0) | (activation.on_target ? on_target_bit : 0) |
           (activation.clear ? clear_bit : 0);
}

Activation activation_of(const Event& event) {
    return {(event.detail & in_view_bit) != 0, (event.detail & on_target_bit) != 0,
            (event.detail & clear_bit) != 0};
}

std::int32_t detail_of(const NerveInjury& injury) {
    return injury.nerve + (injury.cause == InjuryCause::blade ? divided_by_blade : 0);
}

NerveInjury nerve_injury_of(const Event& event) {
    if (event.detail >= divided_by_blade) return {event.detail - divided_by_blade, InjuryCause::blade};
    return {event.detail, InjuryCause::heat};
}

CutPlace cut_place_of(const Event& event) {
    return {static_cast<double>(event.value), event.detail * micrometre};
}

CutTraction cut_traction_of(const Event& event) {
    return {static_cast<double>(event.value), std::max(0, event.detail) * micrometre};
}

}  // namespace fulcrum
