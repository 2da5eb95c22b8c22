// SPDX-License-Identifier: Apache-2.0
// Per-segment and per-joint constants of a rod. Joint i precedes segment i; joints 0 and n lie between an end
// frame and the first or last segment and act over half a cell. Joint arrays are padded to a multiple of four
// with zero stiffness.
#pragma once

#include <optional>
#include <vector>

#include "sim_core/material/section.h"
#include "sim_core/rod/rod.h"

namespace fulcrum {

struct Rod::Tables {
    int segments = 0;
    bool curved = false;  ///< at least one joint has natural curvature
    bool directors_matter =
        false;  ///< twist or natural curvature can occur (always true with held ends or loads)
    std::vector<double> bend, twist;           ///< per joint: EI/cell, GJ/cell, N m
    std::vector<double> rest_1, rest_2;        ///< per joint: natural 2 tan(angle/2) about d1, d2
    std::vector<double> rest_twist;            ///< per joint: rad
    std::vector<double> cell;                  ///< per joint: m
    std::vector<double> rest_length, stretch;  ///< per segment: m, EA/length in N/m
    std::optional<TubeSection> section;        ///< EXP2 only: bend and stretch are then its values at rest
    std::vector<double> unit, none;            ///< per joint: 1 if the joint bends, else 0
    std::vector<double> mass;                  ///< per node, kg
    std::vector<double> spin_inertia;          ///< per segment, kg m2
    std::vector<double> node_s;                ///< per node, m
    std::vector<Vector3> rest_nodes, rest_directors;
    RodFrame rest_ends[2];
    double contact_penalty = 0;  ///< N/m, of contacts
    double self_penalty = 0;     ///< N/m, of contacts of the rod with itself
    double grasp_penalty = 0;    ///< N/m, of grasps
    double turn_penalty = 0;     ///< N m, of held rotations
    double outer_radius = 0;     ///< m, lever arm that converts the residual of a held rotation to m
};

}  // namespace fulcrum
