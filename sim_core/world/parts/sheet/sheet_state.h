// SPDX-License-Identifier: Apache-2.0
// What changes of a sheet from step to step, and what a hand does to it in one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/instrument/instrument.h"
#include "sim_core/membrane/cut_membrane.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/blade_law.h"
#include "sim_core/world/part/jaws.h"
#include "sim_core/world/parts/sheet/sheet_fibres.h"

namespace fulcrum {

namespace sheet_rows {
/// The row of a table that a number names.
constexpr std::size_t at(std::int32_t number) noexcept {
    return static_cast<std::size_t>(number);
}
}  // namespace sheet_rows

/// One hand over one step, as the sheet sees it.
struct SheetAction {
    const InstrumentSpec* instrument = nullptr;  ///< null: no such hand
    ToolKinematics tool;                         ///< at the step's last tick
    bool busy = false;                           ///< its jaws hold something else
    bool takes = true;       ///< jaws that close take hold here; false: something else is nearer
    bool energised = false;  ///< its blade is under power: it needs CuttingSpec::energy_factor of the forces
};

/// A place on the sheet that moves with it.
struct SheetPlace {
    std::int32_t fragment = -1;
    Vector3 barycentric = Vector3::Zero();  ///< in the fragment's root
    std::int32_t triangle = -1;             ///< visible one that it lies in
};

/// What a hand does to the sheet, remembered from step to step.
struct SheetHand : BladeHand {
    SheetPlace place;                   ///< under the tip; the blade's while it cuts
    double side = 1;                    ///< of the sheet that the tip is on, by the sheet's outward normal
    double gap = 0;                     ///< m, tip to sheet on its side
    Vector3 tip = Vector3::Zero();      ///< m, at the last step in which it answered inside the body
    double friction = 0, radius = 0;    ///< of the tool, at the last step; m
    bool over = false;                  ///< tissue was under it then
    bool known = false;                 ///< `side` means something
    bool been_in = false;               ///< `tip` means something
    bool in = false;                    ///< it was inside the body at the last step
    std::int32_t septum = 0;            ///< whose side it is
    Vector3 way = Vector3::Zero();      ///< m at rest: where the blade was last
    double cut_friction = 0;            ///< N, dynamic friction of the tissue that the blade is in
    double ease = 1;                    ///< share of a tissue's forces that its blade needs: less under power
    bool adrift = false;                ///< the blade is between lips, in no tissue
    Vector3 drifted = Vector3::Zero();  ///< m: where it was then at the last step's end
    // Jaws.
    Jaws jaws;
    std::array<SheetPlace, Jaws::most_points> held_at;  ///< place of each of their points
    Vector3 pull = Vector3::Zero();                     ///< N, jaws on sheet
};
/// All that changes; with the surface's own state a step continues from it bit for bit.
struct SheetState {
    CutMembraneState membrane;
    std::vector<Vector3> positions;    ///< m, by visible vertex
    std::vector<SheetPlace> bindings;  ///< by visible vertex
    std::vector<std::uint16_t> loose;  ///< steps since a fragment came free, 0: it hangs on
    std::array<SheetHand, hand_count> hands;
    std::vector<SheetPlace> line;  ///< points of the marked line
    std::vector<std::uint8_t> divided;
    std::vector<double> traction;
    std::int32_t next_station = 0;
    std::int32_t any_loose = 0;  ///< fragments
    SheetFibres fibres;
};

}  // namespace fulcrum
