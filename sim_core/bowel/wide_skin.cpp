// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/wide_skin.h"

namespace fulcrum {

WideSkin::WideSkin(const BowelSkin& skin, SkinScope scope) {
    const Cage& cage = skin.cage();
    std::vector<RingFrame> frames;
    for (const double s : cage.arc_lengths) frames.push_back(rest_frame(s));
    std::vector<Vector3> rings = cage_vertices(cage, frames.data());
    rings.resize(rings.size() - 2);  // without the cap centres
    RingWindows windows(std::move(rings), ring_size, 2);
    WindowWeights weights;
    begin_.push_back(0);
    for (const Vector3& vertex : skin.rest().vertices) {
        if (scope == SkinScope::global) {
            windows.global_weights(vertex, weights);
        } else {
            windows.weights(windows.gap_of(vertex), vertex, weights);
        }
        first_ring_.push_back(weights.first);
        for (int r = 0; r < weights.rings; ++r) {
            double sum = 0;
            Vector3 offset = Vector3::Zero();
            for (std::size_t k = 0; k < ring_size; ++k) {
                const double w = weights.weight[static_cast<std::size_t>(r) * ring_size + k];
                sum += w;
                offset += w * cage.templates[static_cast<std::size_t>(weights.first + r)][k];
            }
            weight_.push_back(sum);
            offset_.push_back(offset);
        }
        begin_.push_back(weight_.size());
    }
}

std::size_t WideSkin::bytes() const {
    return first_ring_.capacity() * sizeof(std::int32_t) + begin_.capacity() * sizeof(std::size_t) +
           weight_.capacity() * sizeof(double) + offset_.capacity() * sizeof(Vector3);
}

}  // namespace fulcrum
