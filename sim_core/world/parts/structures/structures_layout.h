// SPDX-License-Identifier: Apache-2.0
// Where veins and nerves run over a wall: drawn from the attempt's seed. Same seed, same places.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim_core/anatomy/rectum.h"
#include "sim_core/scene/structures_spec.h"
#include "sim_core/world/field/field_bed.h"

namespace fulcrum {

/// A wall by its own coordinates: along it, and across from its middle; with the rectangle of the coronal
/// plane in which blood is followed on it. Only asked while things are built.
struct FieldWall {
    double caudal = 0, cranial = 0.1;                             ///< m along it, from and to
    double right = -0.03, left = 0.03, low = -0.05, high = 0.05;  ///< m, x and y from and to
    /// m; across towards the patient's left, above the wall.
    std::function<Vector3(double along, double across, double above)> point;
    std::function<double(double x, double y)> height;  ///< m, patient z
};
/// The fascia of a sacral hollow from the levator over `length` of the rectum: to the promontory.
FieldWall presacral_wall(const SacralCurve& curve, double length);

/// A vein beneath the wall.
struct VeinPlace {
    std::vector<Vector3> line;  ///< m, on the wall above it, from caudal to cranial or from right to left
    double radius = 0;          ///< m
};

struct StructuresLayout {
    FieldBed bed;
    std::vector<VeinPlace> veins;              ///< middle, right, left, then the rungs from caudal to cranial
    std::vector<std::vector<Vector3>> nerves;  ///< m, the patient's right and left, from caudal to cranial
};

StructuresLayout place_structures(const StructuresSpec& spec, const FieldWall& wall, std::uint64_t seed);

}  // namespace fulcrum
