// SPDX-License-Identifier: Apache-2.0
// The display path of skinning: fp32, blocks of vertices that follow the same rings, normals from the
// deformed tangents. Built only where something is drawn. It never feeds back into the simulation, so its
// bits may depend on the CPU.
#pragma once

#include <vector>

#include "sim_core/bowel/bowel_skin.h"

namespace fulcrum {

/// Constant after construction; any thread may use it. Refers to the skin's adjacency: the skin must outlive
/// it.
class DisplaySkin {
  public:
    explicit DisplaySkin(const BowelSkin& skin);

    int vertices() const { return vertices_; }

    /// Positions and, where normals is not null, unit normals: three floats a vertex in the mesh's order.
    /// Error <= 1e-6 m. frames: one a ring, patient frame. ring_floats: work space of 12 floats a ring, the
    /// caller's. Allocates nothing.
    void evaluate(const RingFrame* frames, float* ring_floats, float* positions, float* normals) const;

    /// Adds local dents to evaluated positions and renews the normals of the dented vertices and of those
    /// next to them.
    void add_dents(const DentVertex* dents, int count, float* positions, float* normals) const;

    std::size_t bytes() const;

  private:
    const BowelSkin* skin_ = nullptr;
    int vertices_ = 0, rings_ = 0;
    std::vector<std::int32_t> block_ring_;      // first ring of each block
    std::vector<std::int32_t> block_vertices_;  // lanes a block, -1 in unused lanes
    std::vector<float> position_rows_;          // 16 rows of lanes a block: W_j, Y_j for j = 0..3
    std::vector<std::int16_t>
        tangent_rows_;  // the same for the two rest tangents, each vertex to its own scale
};

}  // namespace fulcrum
