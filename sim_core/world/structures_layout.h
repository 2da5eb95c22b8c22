// SPDX-License-Identifier: Apache-2.0
// Where veins and nerves run over a wall: drawn from the attempt's seed. Same seed, same places.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim_core/scene/structures_spec.h"
#include "sim_core/world/field_bed.h"

namespace fulcrum {

/// A wall as a height over the coronal plane, within a rectangle of it. Only asked while things are built.
struct FieldWall {
    double right = -0.04, left = 0.04;                 ///< m, x from and to (the patient's right and left)
    double caudal = -0.04, cranial = 0.04;             ///< m, y from and to
    std::function<double(double x, double y)> height;  ///< m, patient z

    Vector3 point(double x, double y) const { return Vector3(x, y, height(x, y)); }
    /// Unit, towards +z.
    Vector3 normal(double x, double y) const;
};

/// A vein beneath the wall.
struct VeinPlace {
    std::vector<Vector3> line;  ///< m, on the wall above it
    double radius = 0;          ///< m
};

struct StructuresLayout {
    FieldBed bed;
    std::vector<VeinPlace> veins;              ///< middle, right, left, then the rungs from caudal to cranial
    std::vector<std::vector<Vector3>> nerves;  ///< m, the patient's right and left, from cranial to caudal
};

StructuresLayout place_structures(const StructuresSpec& spec, const FieldWall& wall, std::uint64_t seed);

}  // namespace fulcrum
