// SPDX-License-Identifier: Apache-2.0
// The table of event types: all that the program treats differently from one type to another. A new type is a
// row here, at the end, and what makes it happen; its words are in its row, except where its line depends on
// more than one of its fields (ui/review/event_words.cpp).
#pragma once

#include <iterator>

#include "sim_core/numerics/name_table.h"
#include "sim_core/telemetry/event.h"

namespace fulcrum {

/// Whose mistake it is. A choice that only a limit judges (energy near a nerve, a second grasp) is nobody's.
enum class EventWeight : std::uint8_t {
    ordinary,
    fault,    ///< of a device or the simulation
    error,    ///< of whoever performs, as the program records it by itself
    critical  ///< an error: injury of what must stay whole
};

/// What the clock, the devices or the end of the program decided, a simulation from the inputs does not have,
/// or at another place: the check by simulation leaves it out.
enum class EventSource : std::uint8_t { simulation, outside };

/// What it changes on the display of a replay.
enum class ReplayMark : std::uint8_t {
    none,
    goal,            ///< another goal is under way
    progress,        ///< of that goal
    movement,        ///< the clock runs
    target_shown,    ///< its sphere is the active one
    target_reached,  ///< its sphere is done
    blood,           ///< the amount so far
    traction,        ///< across the cut
    traction_over    ///< no value until the next
};

/// Its line in the list of a debrief.
enum class LineContent : std::uint8_t {
    none,             ///< not worth one
    name,             ///< what it is called
    value,            ///< its words with the value
    count,            ///< with the detail, counted from 1
    count_and_value,  ///< with both
    // Of more than one field; the words that differ are where they are put together.
    force,       ///< with the value, and with the limit where it is known
    samples,     ///< how many
    piece,       ///< its words with the area, if it can be seen
    activation,  ///< how near to the nerve
    clip,        ///< whether on a bleeding point
    nerve        ///< by heat or by a blade
};

struct EventType {
    EventKind kind;
    const char* name;   ///< in files and exports (docs/FORMATS.md); permanent
    const char* title;  ///< on screens, English: what it is called
    EventWeight weight;
    EventSource source;
    ReplayMark mark;
    LineContent line;
    const char* words = nullptr;  ///< of the line, English
};

inline constexpr EventType event_kinds[] = {
    {EventKind::attempt_begin, "attempt_begin", QT_TRANSLATE_NOOP("fulcrum::events", "attempt begins"),
     EventWeight::ordinary, EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::first_movement, "first_movement", QT_TRANSLATE_NOOP("fulcrum::events", "first movement"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::movement, LineContent::name},
    {EventKind::phase_begin, "phase_begin", QT_TRANSLATE_NOOP("fulcrum::events", "step begins"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::goal, LineContent::count,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Step %1 begins")},
    {EventKind::phase_end, "phase_end", QT_TRANSLATE_NOOP("fulcrum::events", "step ends"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::none},
    {EventKind::target_shown, "target_shown", QT_TRANSLATE_NOOP("fulcrum::events", "target shown"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::target_shown, LineContent::none},
    {EventKind::target_reached, "target_reached", QT_TRANSLATE_NOOP("fulcrum::events", "target held"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::target_reached, LineContent::count,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Target %1 held")},
    {EventKind::grasp, "grasp", QT_TRANSLATE_NOOP("fulcrum::events", "grasp"), EventWeight::ordinary,
     EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::release, "release", QT_TRANSLATE_NOOP("fulcrum::events", "release"), EventWeight::ordinary,
     EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::slip, "slip", QT_TRANSLATE_NOOP("fulcrum::events", "tissue slipped out of the jaws"),
     EventWeight::error, EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::drop, "drop", QT_TRANSLATE_NOOP("fulcrum::events", "object dropped"), EventWeight::error,
     EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::regrasp, "regrasp", QT_TRANSLATE_NOOP("fulcrum::events", "same place grasped again"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::over_force_begin, "over_force_begin", QT_TRANSLATE_NOOP("fulcrum::events", "too much force"),
     EventWeight::error, EventSource::simulation, ReplayMark::none, LineContent::force,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Too much force: %1 N")},
    {EventKind::over_force_end, "over_force_end",
     QT_TRANSLATE_NOOP("fulcrum::events", "force back within the limit"), EventWeight::ordinary,
     EventSource::simulation, ReplayMark::none, LineContent::none},
    {EventKind::perforation, "perforation", QT_TRANSLATE_NOOP("fulcrum::events", "perforation"),
     EventWeight::critical, EventSource::simulation, ReplayMark::none, LineContent::value,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Perforation at %1 N")},
    {EventKind::tool_collision, "tool_collision",
     QT_TRANSLATE_NOOP("fulcrum::events", "collision of instruments"), EventWeight::error,
     EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::wall_contact, "wall_contact", QT_TRANSLATE_NOOP("fulcrum::events", "contact with the wall"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::none},
    {EventKind::pause, "pause", QT_TRANSLATE_NOOP("fulcrum::events", "pause"), EventWeight::ordinary,
     EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::resume, "resume", QT_TRANSLATE_NOOP("fulcrum::events", "resumed"), EventWeight::ordinary,
     EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::device_lost, "device_lost", QT_TRANSLATE_NOOP("fulcrum::events", "device lost"),
     EventWeight::fault, EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::device_back, "device_back", QT_TRANSLATE_NOOP("fulcrum::events", "device back"),
     EventWeight::ordinary, EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::device_fault, "device_fault",
     QT_TRANSLATE_NOOP("fulcrum::events", "device gave an impossible reading"), EventWeight::fault,
     EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::world_late, "world_late", QT_TRANSLATE_NOOP("fulcrum::events", "simulation late"),
     EventWeight::ordinary, EventSource::outside, ReplayMark::none, LineContent::none},
    {EventKind::simulator_fault, "simulator_fault", QT_TRANSLATE_NOOP("fulcrum::events", "simulator fault"),
     EventWeight::fault, EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::stability_limited, "stability_limited",
     QT_TRANSLATE_NOOP("fulcrum::events", "stiffness limited"), EventWeight::ordinary, EventSource::outside,
     ReplayMark::none, LineContent::none},
    {EventKind::goal_progress, "goal_progress", QT_TRANSLATE_NOOP("fulcrum::events", "progress"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::progress, LineContent::none},
    {EventKind::completed, "completed", QT_TRANSLATE_NOOP("fulcrum::events", "completed"),
     EventWeight::ordinary, EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::abandoned, "abandoned", QT_TRANSLATE_NOOP("fulcrum::events", "abandoned"),
     EventWeight::ordinary, EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::timed_out, "timed_out", QT_TRANSLATE_NOOP("fulcrum::events", "time limit reached"),
     EventWeight::ordinary, EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::interrupted, "interrupted", QT_TRANSLATE_NOOP("fulcrum::events", "interrupted"),
     EventWeight::ordinary, EventSource::outside, ReplayMark::none, LineContent::name},
    {EventKind::samples_lost, "samples_lost", QT_TRANSLATE_NOOP("fulcrum::events", "samples lost"),
     EventWeight::ordinary, EventSource::outside, ReplayMark::none, LineContent::samples},
    {EventKind::tear, "tear", QT_TRANSLATE_NOOP("fulcrum::events", "tear"), EventWeight::error,
     EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::jaw_pressure, "jaw_pressure",
     QT_TRANSLATE_NOOP("fulcrum::events", "jaw pressure above the limit"), EventWeight::error,
     EventSource::simulation, ReplayMark::none, LineContent::value,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Jaw pressure %1 kPa")},
    {EventKind::cut_begin, "cut_begin", QT_TRANSLATE_NOOP("fulcrum::events", "cut begins"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::cut_end, "cut_end", QT_TRANSLATE_NOOP("fulcrum::events", "cut ends"), EventWeight::ordinary,
     EventSource::simulation, ReplayMark::traction_over, LineContent::name},
    {EventKind::cut_advance, "cut_advance", QT_TRANSLATE_NOOP("fulcrum::events", "cut advances"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::none},
    {EventKind::cut_traction, "cut_traction", QT_TRANSLATE_NOOP("fulcrum::events", "traction across the cut"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::traction, LineContent::none},
    {EventKind::cut_rolled_back, "cut_rolled_back",
     QT_TRANSLATE_NOOP("fulcrum::events", "step of the cut undone"), EventWeight::ordinary,
     EventSource::simulation, ReplayMark::none, LineContent::none},
    {EventKind::piece_fallen, "piece_fallen", QT_TRANSLATE_NOOP("fulcrum::events", "piece came free"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::piece,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "A piece of %1 mm² came free")},
    {EventKind::activation_begin, "activation_begin", QT_TRANSLATE_NOOP("fulcrum::events", "energy on"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::activation},
    {EventKind::activation_end, "activation_end", QT_TRANSLATE_NOOP("fulcrum::events", "energy off"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::band_divided, "band_divided", QT_TRANSLATE_NOOP("fulcrum::events", "band divided"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::count_and_value,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Band %1 divided at %2 N")},
    {EventKind::bleed_begin, "bleed_begin", QT_TRANSLATE_NOOP("fulcrum::events", "bleeding begins"),
     EventWeight::error, EventSource::simulation, ReplayMark::none, LineContent::value,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Bleeding, %1 mL/min")},
    {EventKind::bleed_end, "bleed_end", QT_TRANSLATE_NOOP("fulcrum::events", "bleeding stopped"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::value,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Bleeding stopped after %1 mL")},
    {EventKind::blood_loss, "blood_loss", QT_TRANSLATE_NOOP("fulcrum::events", "blood loss"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::blood, LineContent::none},
    {EventKind::clip_applied, "clip_applied", QT_TRANSLATE_NOOP("fulcrum::events", "clip"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::clip},
    {EventKind::heat_dose, "heat_dose", QT_TRANSLATE_NOOP("fulcrum::events", "heat dose"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::none},
    {EventKind::vessel_injury, "vessel_injury", QT_TRANSLATE_NOOP("fulcrum::events", "vessel injury"),
     EventWeight::critical, EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::nerve_injury, "nerve_injury", QT_TRANSLATE_NOOP("fulcrum::events", "nerve injury"),
     EventWeight::critical, EventSource::simulation, ReplayMark::none, LineContent::nerve},
    {EventKind::tool_exchanged, "tool_exchanged",
     QT_TRANSLATE_NOOP("fulcrum::events", "instrument exchanged"), EventWeight::ordinary,
     EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::fibres_parted, "fibres_parted",
     QT_TRANSLATE_NOOP("fulcrum::events", "fibres tore under too much tension"), EventWeight::error,
     EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::heat_area, "heat_area", QT_TRANSLATE_NOOP("fulcrum::events", "area of dead tissue"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::none},
    {EventKind::lens_contact, "lens_contact", QT_TRANSLATE_NOOP("fulcrum::events", "lens touched"),
     EventWeight::error, EventSource::simulation, ReplayMark::none, LineContent::name},
    {EventKind::target_lost, "target_lost", QT_TRANSLATE_NOOP("fulcrum::events", "target lost"),
     EventWeight::ordinary, EventSource::simulation, ReplayMark::none, LineContent::value,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Tip framed after %1 s without it")},
};
static_assert(in_order(event_kinds));

/// A line that is made of words has them in its row, and no other has any there.
constexpr bool words_are_complete() {
    for (const EventType& row : event_kinds) {
        const bool needed = row.line == LineContent::value || row.line == LineContent::count ||
                            row.line == LineContent::count_and_value || row.line == LineContent::force ||
                            row.line == LineContent::piece;
        if (needed != (row.words != nullptr)) return false;
    }
    return true;
}
static_assert(words_are_complete());

/// Null for a number of a newer program.
constexpr const EventType* find_type(EventKind kind) {
    const auto number = static_cast<std::size_t>(kind);
    return number < std::size(event_kinds) ? &event_kinds[number] : nullptr;
}

constexpr EventWeight weight_of(EventKind kind) {
    const EventType* type = find_type(kind);
    return type == nullptr ? EventWeight::ordinary : type->weight;
}

constexpr bool is_error(EventKind kind) {
    return weight_of(kind) == EventWeight::error || weight_of(kind) == EventWeight::critical;
}

constexpr bool is_from_simulation(EventKind kind) {
    const EventType* type = find_type(kind);
    return type == nullptr || type->source == EventSource::simulation;
}

}  // namespace fulcrum
