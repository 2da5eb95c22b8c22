// SPDX-License-Identifier: Apache-2.0
// The finer scopes of skinning (docs/THEORY.md, sections 1.4 and 8): windows with two neighbours on each
// side, and the whole cage. Built only if the scene's fidelity asks for them. Contact patches always use the
// local scope (rows of BowelSkin), corrected to the finer position. Lengths in m; patient frame.
#pragma once

#include <vector>

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/bowel/skin_scope.h"

namespace fulcrum {

/// One row per surface vertex, over as many rings as the scope needs. Constant after construction.
class WideSkin {
  public:
    /// scope: local2 or global. Binds every vertex at rest; global takes seconds for 20,000 vertices.
    WideSkin(const BowelSkin& skin, SkinScope scope);

    /// Position under the ring frames (indexed by ring).
    template <typename Frames>
    Vector3 vertex(std::int32_t v, const Frames& frames) const {
        const auto n = static_cast<std::size_t>(v);
        Vector3 position = Vector3::Zero();
        for (std::size_t k = begin_[n]; k < begin_[n + 1]; ++k) {
            const RingFrame& frame = frames[static_cast<std::size_t>(first_ring_[n]) + k - begin_[n]];
            position += weight_[k] * frame.position + frame.rotation * offset_[k];
        }
        return position;
    }
    /// Shifts the local row of vertex v to the wide position under these frames: the difference is attached
    /// rigidly to the ring of largest weight. The row's ring indices must match the frames.
    template <typename Frames>
    void correct(std::int32_t v, const Frames& frames, SkinRow& row) const {
        int heaviest = 0;
        for (int j = 1; j < skin_rings; ++j)
            if (row.weight[j] > row.weight[heaviest]) heaviest = j;
        const RingFrame& frame = frames[static_cast<std::size_t>(row.first_ring + heaviest)];
        row.offset[heaviest] += frame.rotation.inverse() * (vertex(v, frames) - skin_vertex(row, frames));
    }
    std::size_t bytes() const;

  private:
    std::vector<std::int32_t> first_ring_;
    std::vector<std::size_t> begin_;  ///< vertices + 1
    std::vector<double> weight_;
    std::vector<Vector3> offset_;
};

}  // namespace fulcrum
