// SPDX-License-Identifier: Apache-2.0
// Skinning for display: fp32, blocks of vertices that follow the same rings, normals from the deformed
// tangents. Built only if something is drawn. It never feeds back into the simulation, so its bits may depend
// on the CPU.
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

    /// Positions and, if normals is not null, unit normals: three floats per vertex in the mesh's order.
    /// Error
    /// <= 1e-6 m. frames: one per ring, patient frame. ring_floats: work space of 12 floats per ring, owned
    /// by the caller. Does not allocate.
    void evaluate(const RingFrame* frames, float* ring_floats, float* positions, float* normals) const;

    /// Adds local dents to evaluated positions and recomputes the normals of the dented vertices and of their
    /// neighbours.
    void add_dents(const DentVertex* dents, int count, float* positions, float* normals) const;

    std::size_t bytes() const;

  private:
    const BowelSkin* skin_ = nullptr;
    int vertices_ = 0, rings_ = 0;
    std::vector<std::int32_t> block_ring_;      // first ring of each block
    std::vector<std::int32_t> block_vertices_;  // vertex of each lane of a block, -1 in unused lanes
    std::vector<float> position_rows_;          // 16 rows of lanes a block: W_j, Y_j for j = 0..3
    std::vector<std::int16_t> tangent_rows_;    // the same for the two rest tangents, with a scale per vertex
};

}  // namespace fulcrum
