// SPDX-License-Identifier: Apache-2.0
// The surface as a function of the ring frames: precomputed form of the mean value coordinates.
//
// Ring r has template vertices X_rk (k = 0..7) that move rigidly with its frame (c_r, R_r), so for a surface
// vertex
//     v = sum_j sum_k w_jk (c_rj + R_rj X_rjk) = sum_j (W_j c_rj + R_rj Y_j),   W_j = sum_k w_jk,  Y_j =
//     sum_k w_jk X_jk,
// exactly: four rings need 16 numbers per vertex instead of 32 weights and 32 cage points (docs/THEORY.md,
// section 1.4; Ju et al. 2005).
#pragma once

#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum {

inline constexpr int skin_rings = 4;  ///< rings a vertex follows in the local scope with k = 1

/// Frame of one cage ring, patient frame; columns of rotation are the directors d1, d2, d3 (d3 the tangent).
struct RingFrame {
    Vector3 position = Vector3::Zero();
    Matrix3 rotation = Matrix3::Identity();
};

/// Ring frame with its velocity, used by the haptic tick to extrapolate between world steps.
struct RingMotion {
    RingFrame frame;
    Vector3 velocity = Vector3::Zero();          ///< m/s
    Vector3 angular_velocity = Vector3::Zero();  ///< rad/s, patient frame
};

/// One surface vertex; it follows rings first_ring .. first_ring + 3.
struct SkinRow {
    std::int32_t first_ring = 0;
    double weight[skin_rings] = {0, 0, 0, 0};  ///< W_j, sum 1
    Vector3 offset[skin_rings] = {Vector3::Zero(), Vector3::Zero(), Vector3::Zero(),
                                  Vector3::Zero()};  ///< Y_j, m, ring frame
};

/// Local dent, added to the skinned position.
struct DentVertex {
    std::int32_t vertex = -1;
    Vector3 displacement = Vector3::Zero();  ///< m, patient frame
};

/// Position of a row's vertex under the given ring frames (indexed by ring number).
template <typename Frames>
Vector3 skin_vertex(const SkinRow& row, const Frames& frames) {
    Vector3 position = Vector3::Zero();
    for (int j = 0; j < skin_rings; ++j) {
        const auto& frame = frames[static_cast<std::size_t>(row.first_ring + j)];
        position += row.weight[j] * frame.position + frame.rotation * row.offset[j];
    }
    return position;
}

}  // namespace fulcrum
