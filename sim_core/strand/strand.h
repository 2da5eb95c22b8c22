// SPDX-License-Identifier: Apache-2.0
// An elastic strand between two posts: a chain of nodes with fixed ends, held by jaws at any node, divided
// between any two. Model (const) / state; fixed capacity, no allocation, no exception, always finite.
//
// Each segment is a tension-only spring, of force k (l - L0); a step is implicit Euler, the minimum of
//     sum m/2 |x - y|^2 / dt^2 + sum k/2 max(0, l - L0)^2 + sum P(|x_h - target|),     y = x + v dt + g
//     dt^2,     P(d) = K/2 d^2 up to K d = most, with constant force beyond,
// by Newton with the positive part of each spring's tangent and a step that never raises that energy: one
// block tridiagonal solve per iteration.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "sim_core/numerics/types.h"

namespace fulcrum {

inline constexpr int strand_segments = 12;
inline constexpr int strand_nodes = strand_segments + 1;

struct StrandModel {
    double stiffness = 1000;                 ///< k, N/m of one segment
    double rest_length = 2e-3;               ///< L0, m of one segment
    double node_mass = 3e-5;                 ///< m, kg
    double damping = 25;                     ///< 1/s, of velocities
    Vector3 gravity = Vector3(0, 0, -9.81);  ///< m/s2
};

/// Grasp of one node by one hand.
struct StrandHold {
    int node = -1;                                          ///< -1: none
    Vector3 target = Vector3::Zero();                       ///< m
    double stiffness = 0;                                   ///< K, N/m, of the pinched tissue
    double most = std::numeric_limits<double>::infinity();  ///< N, that the jaws hold: beyond it it slides
};

struct StrandState {
    std::array<Vector3, strand_nodes> position, velocity;  ///< m, m/s; the first and last never move
    std::uint32_t parted = 0;                              ///< bit s: segment s is divided
    bool is_parted(int segment) const { return (parted >> static_cast<unsigned>(segment) & 1U) != 0; }
};

struct StrandReport {
    int rounds = 0;
    double residual = 0;  ///< N, largest residual force on a node
    bool settled = true;  ///< false: the iteration limit was reached
};

/// State at rest, straight between two points.
StrandState make_strand_state(const Vector3& first, const Vector3& last);
/// One step of dt s (no effect unless dt > 0). Non-finite targets count as no hold.
StrandReport step_strand(const StrandModel& model, const StrandHold (&holds)[hand_count], double dt,
                         StrandState& state) noexcept;
/// Tension of a segment, N; 0 if it is divided or slack.
double strand_tension(const StrandModel& model, const StrandState& state, int segment) noexcept;
/// Force of the jaws on the strand, N.
Vector3 hold_force(const StrandHold& hold, const StrandState& state) noexcept;
/// Stiffness of the strand at a node with everything else at rest, N/m: that of its two neighbouring
/// segments.
double strand_stiffness(const StrandModel& model, const StrandState& state, int node) noexcept;
/// The point of the strand nearest to a position: the nearest node and the distance to the line there, m.
int nearest_node(const StrandState& state, const Vector3& place, double& distance) noexcept;

}  // namespace fulcrum
