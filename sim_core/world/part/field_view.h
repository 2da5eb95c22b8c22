// SPDX-License-Identifier: Apache-2.0
// Nerves, heat, bleeding, blood, smoke and hand tools of an operative field as the viewport, the monitor and
// the operators see them after a step (WorldSnapshot::field). A scene has one field at most: that of its
// bands or that of its structures. Vectors have their final size from the start.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/numerics/types.h"
#include "sim_core/scene/instrument_type.h"

namespace fulcrum {

/// What the power of an activation reaches; `fat`: of a sheet, what lies beyond the tissue that is to be
/// divided.
enum class EnergyTarget : std::uint8_t { nothing, band, vessel, bed, nerve, sheet, fat };

struct NerveView {
    std::vector<Vector3> line;  ///< m
    std::vector<float> dose;    ///< min (CEM43), a point each
    bool divided = false;       ///< by a blade

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(line, dose, divided);
    }
};

/// Most openings that veins of a wall have at a time.
inline constexpr std::size_t field_outlet_capacity = 16;

/// A place where a vessel can bleed. Of bands: 2 v the trunk in the band, 2 v + 1 the branch at its root. Of
/// a wall: as they were opened; places not used yet are not opened.
struct OutletView {
    Vector3 position = Vector3::Zero();  ///< m
    std::int32_t band = -1;              ///< -1: it is of a vein
    std::int32_t vein = -1;
    double flow = 0;        ///< m3/s
    double lost = 0;        ///< m3 since the start
    float blood_depth = 0;  ///< m that it lies under
    bool opened = false;    ///< it has bled
    bool clipped = false;
    bool injured = false;  ///< torn, or divided before it was sealed or clipped
};

/// What a hand's exchangeable instrument is doing.
struct HandToolView {
    InstrumentKind kind = InstrumentKind::grasper;
    std::int32_t index = 0;   ///< in InstrumentSpec::exchange
    float exchange_left = 0;  ///< s until it can be used
    bool active = false;      ///< energy or suction was on in this step
    EnergyTarget target = EnergyTarget::nothing;
    float nerve_distance = 1;  ///< m, blade's surface to the nearest nerve's
    std::int32_t band = -1;    ///< held, or touched by the power
    float blade = 37;          ///< degrees C
    std::int32_t clips_left = 0;
    std::int32_t clips_fired = 0;
    std::int32_t last_clip_outlet = -1;  ///< of the last clip; -1: on a band or on nothing
    float last_clip_distance = 0;        ///< m, jaws to what it was put on
};

struct FieldView {
    std::vector<OutletView> outlets;
    HandToolView tools[hand_count];
    std::vector<NerveView> nerves;
    double nerve_radius = 0;  ///< m
    double lateral_dose =
        0;  ///< min, largest over what energy is not for: nerves, bed, far tissue of a sheet
    double lateral_area = 0;                          ///< m2 of bed and far tissue at or above lethal_dose
    double worst_nerve_dose = 0, worst_bed_dose = 0;  ///< min
    // The bed: a grid of cells, row by row along y; blood lies on it.
    std::int32_t columns = 0, rows = 0;
    double cell = 0;                             ///< m
    Vector3 corner = Vector3::Zero();            ///< m, of the first cell
    std::vector<float> ground, blood, bed_dose;  ///< m (patient z), m, min
    double lost = 0, removed = 0;                ///< m3 of blood since the start
    double smoke = 0;                            ///< share of light that does not come through
    double heat_given = 0;                       ///< J since the start

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(outlets, tools, nerves, nerve_radius, lateral_dose, lateral_area, worst_nerve_dose,
              worst_bed_dose, columns, rows, cell, corner, ground, blood, bed_dose, lost, removed, smoke,
              heat_given);
    }
};

}  // namespace fulcrum
