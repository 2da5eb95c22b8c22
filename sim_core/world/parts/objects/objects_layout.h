// SPDX-License-Identifier: Apache-2.0
// Where pegs and rings of a scene's tray are, drawn from the attempt's seed, and the tray's surface.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/rigid/capsule_bodies.h"
#include "sim_core/scene/objects_spec.h"

namespace fulcrum {

struct ObjectsLayout {
    std::vector<Vector3> feet;  ///< m, of the pegs: first those that the rings lie around, then the targets
    std::vector<BodyState> bodies;  ///< at rest around the first pegs, in their order
    BodyShape ring;
    BodyGround ground;  ///< tray and pegs as the rings touch them
};

ObjectsLayout place_objects(const ObjectsSpec& spec, const Vector3& gravity, std::uint64_t seed);

/// Tray and pegs as instruments feel them: the tray continues beyond its rim.
TriangleMesh tray_mesh(const ObjectsSpec& spec, const std::vector<Vector3>& feet);

/// Whether a peg goes through a ring: its axis, below its top, lies within the ring's tubes.
bool goes_through(const BodyShape& ring, const BodyState& body, const Vector3& foot, double peg_height);

}  // namespace fulcrum
