// SPDX-License-Identifier: Apache-2.0
// The band of a blade: a convex region bounded by planes (docs/THEORY.md, section 5: two border lines, round
// or square ends), in the current frame and shape of the tissue.
#pragma once

#include <array>
#include <cstdint>

#include "sim_core/numerics/types.h"

namespace fulcrum {

enum class BladeEnd : std::uint8_t {
    square,  ///< the band ends with the step
    round,   ///< half an octagon of the band's width beyond the step: joins steps of different direction
};

/// A straight advance of the blade through tissue.
struct BladeStep {
    Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< m
    Vector3 normal = Vector3::UnitZ();  ///< of the surface, outward; need not be a unit vector
    double width = 0.001;               ///< m, > 0, of the tissue that is removed
    double depth = 0.002;               ///< m, > 0: reach to either side of the step along the normal
    BladeEnd start = BladeEnd::round, end = BladeEnd::square;
    std::int32_t root = -1;  ///< root triangle near the blade, where the search along the surface begins
};

struct BladePlane {
    Vector3 normal = Vector3::Zero();  ///< outward unit vector
    double offset = 0;                 ///< m; inside: normal . x <= offset
    double distance(const Vector3& x) const { return normal.dot(x) - offset; }
};

struct BladeRegion {
    static constexpr int most_planes = 12;
    std::array<BladePlane, most_planes> planes;
    int count = 0;
    Vector3 centre = Vector3::Zero();
    double radius = 0;  ///< m, of a ball about the centre that contains the region
    Vector3 from = Vector3::Zero(), to = Vector3::Zero(), along = Vector3::UnitX(), left = Vector3::UnitY();
    double half_width = 0, reach = 0;  ///< m

    /// True if part of a triangle is deeper than `inset` (m) inside the region.
    bool meets(const Vector3& a, const Vector3& b, const Vector3& c, double inset) const;
    /// True if no plane has all three points further outside than `margin` (m).
    bool near(const Vector3& a, const Vector3& b, const Vector3& c, double margin) const;
    /// Distance of a point from the step's path, measured across the normal, m; side: > 0 left of the
    /// advance.
    double distance_from_path(const Vector3& x, double& side) const;
};

enum class BladeFault : std::uint8_t { none, not_finite, no_width, no_advance };

/// Planes of a step. no_advance: the step has no length across the normal (less than 1e-6 widths) and nothing
/// is cut. Never throws, does not allocate.
BladeFault make_region(const BladeStep& step, BladeRegion& region);

}  // namespace fulcrum
