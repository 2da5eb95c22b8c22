// SPDX-License-Identifier: Apache-2.0
// Rest geometry of the bowel that a scene asks for.
#pragma once

#include <vector>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/geometry/mesh.h"
#include "sim_core/rod/rod.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// Rest geometry of a bowel and how it lies in the body.
struct BowelAnatomy {
    TriangleMesh surface;                  ///< rest tube along +x, closed
    double length = 0;                     ///< m
    RadiusProfile radius;                  ///< lumen radius by rest arc length
    std::vector<Vector3> centre_line;      ///< in situ, patient frame, first = rectum
    std::vector<Vector3> root_line;        ///< mesenteric root on the wall, first = rectal end
    std::vector<RodTether> cranial_holds;  ///< not empty: its cranial end is free but for these
};

/// The scene has a bowel, and a cavity or a presacral wall for it. Throws InputError.
BowelAnatomy bowel_anatomy(const Scene& scene);

}  // namespace fulcrum
