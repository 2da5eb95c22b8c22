// SPDX-License-Identifier: Apache-2.0
// How a scene's membranes lie before anything is done to them. Start of an attempt; any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// A sheet at rest and how it is held.
struct MembraneSheet {
    TriangleMesh mesh;                         ///< in situ, patient frame
    std::vector<std::int32_t> bowel_vertices;  ///< on the bowel's wall
    std::vector<double> bowel_arc_lengths;     ///< m along the rod, one each
    std::vector<std::int32_t> wall_vertices;   ///< on the wall of the cavity: they stay
};

/// One for each of Scene::membranes, which need a bowel and a cavity.
std::vector<MembraneSheet> lay_out_membranes(const Scene& scene);

}  // namespace fulcrum
