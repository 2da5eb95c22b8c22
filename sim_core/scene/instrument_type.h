// SPDX-License-Identifier: Apache-2.0
// Every kind of instrument: its name in files, its title on screens, what it can do and how large it is where
// a scene does not say. A new kind is a row here, a drawing (ui/theatre/renderer/tool_parts.cpp) and its name
// in assets/schemas/scene/common.json.
#pragma once

#include "sim_core/numerics/name_table.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

/// In the table's order. Add at the end: world states are hashed with these numbers.
enum class InstrumentKind : std::uint8_t {
    grasper,
    probe,
    harmonic,
    hook,
    clip_applier,
    suction,
    scissors,
    bowel_grasper
};

/// What the pedal gives.
enum class InstrumentEnergy : std::uint8_t {
    none,
    ultrasonic,  ///< heats whatever is between or next to the blades
    monopolar,   ///< a current through water: tissue that has dried takes no more
};
/// When it cuts what its edge touches.
enum class InstrumentBlade : std::uint8_t {
    none,
    button,            ///< while its primary button is held
    button_or_energy,  ///< also under power
    energy,            ///< under power only
};

struct InstrumentType {
    InstrumentKind kind;
    const char* name;
    const char* title;
    bool jaws;            ///< opens and closes with the device's jaw
    bool grasps;          ///< its jaws hold bowel and sheets
    bool grasps_strands;  ///< its jaws hold bands
    InstrumentBlade blade;
    InstrumentEnergy energy;
    bool clips;
    bool suction;
    double jaw_length;  ///< m
    double jaw_width;   ///< m, edges b and c of the tip's box
};

inline constexpr InstrumentType instrument_types[] = {
    // kind, name, title, jaws, grasps, grasps strands, blade, energy, clips, suction, jaw length, jaw width
    {InstrumentKind::grasper, "grasper", QT_TRANSLATE_NOOP("fulcrum::instruments", "grasper"), true, true,
     true, InstrumentBlade::none, InstrumentEnergy::none, false, false, 0.020, 0.005},
    {InstrumentKind::probe, "probe", QT_TRANSLATE_NOOP("fulcrum::instruments", "probe"), false, false, false,
     InstrumentBlade::none, InstrumentEnergy::none, false, false, 0.020, 0.005},
    {InstrumentKind::harmonic, "harmonic", QT_TRANSLATE_NOOP("fulcrum::instruments", "shears"), true, false,
     true, InstrumentBlade::energy, InstrumentEnergy::ultrasonic, false, false, 0.020, 0.005},
    {InstrumentKind::hook, "hook", QT_TRANSLATE_NOOP("fulcrum::instruments", "hook"), false, false, false,
     InstrumentBlade::button_or_energy, InstrumentEnergy::monopolar, false, false, 0.020, 0.005},
    {InstrumentKind::clip_applier, "clip_applier", QT_TRANSLATE_NOOP("fulcrum::instruments", "clip applier"),
     true, false, false, InstrumentBlade::none, InstrumentEnergy::none, true, false, 0.020, 0.005},
    {InstrumentKind::suction, "suction", QT_TRANSLATE_NOOP("fulcrum::instruments", "suction"), false, false,
     false, InstrumentBlade::none, InstrumentEnergy::none, false, true, 0.020, 0.005},
    {InstrumentKind::scissors, "scissors", QT_TRANSLATE_NOOP("fulcrum::instruments", "scissors"), true, false,
     false, InstrumentBlade::button, InstrumentEnergy::none, false, false, 0.020, 0.005},
    {InstrumentKind::bowel_grasper, "bowel_grasper",
     QT_TRANSLATE_NOOP("fulcrum::instruments", "bowel grasper"), true, true, true, InstrumentBlade::none,
     InstrumentEnergy::none, false, false, 0.035, 0.006},
};
static_assert(in_order(instrument_types));

constexpr const InstrumentType& type_of(InstrumentKind kind) {
    return row_of(instrument_types, kind);
}
/// Its jaws press on what is between them when they close; scissors cut it.
constexpr bool jaws_press(InstrumentKind kind) {
    const InstrumentType& type = type_of(kind);
    return type.jaws && (type.grasps || type.grasps_strands || type.clips);
}
constexpr bool gives_energy(InstrumentKind kind) {
    return type_of(kind).energy != InstrumentEnergy::none;
}

}  // namespace fulcrum
