// SPDX-License-Identifier: Apache-2.0
// Rigid rings, pegs and tray as the viewport, the monitor and the operators see them after a step
// (WorldSnapshot::objects). Vectors have their final size from the start.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct ObjectView {
    Vector3 position = Vector3::Zero();            ///< m, middle of the ring
    Quaternion rotation = Quaternion::Identity();  ///< ring to patient frame
    Vector3 velocity = Vector3::Zero();            ///< m/s
    double height = 0;                             ///< m, of its lowest point above the tray
    std::int32_t start_peg = -1;                   ///< the peg that it lay around at the start
    std::int32_t peg = -1;                         ///< the peg that goes through it now; -1 none
};

struct PegView {
    Vector3 foot = Vector3::Zero(), top = Vector3::Zero();  ///< m
    Hand side = Hand::left;  ///< half of the tray that it stands on: left is +x of the patient
};

struct ObjectsView {
    std::vector<ObjectView> objects;
    std::vector<PegView> pegs;
    std::vector<Vector3> corners;      ///< m, of a ring in its own frame; a tube goes from each to the next
    double tube_radius = 0;            ///< m
    double peg_radius = 0;             ///< m
    Vector3 centre = Vector3::Zero();  ///< m, middle of the tray
    double half_length = 0, half_width = 0;  ///< m, along x and y

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(objects, pegs, corners, tube_radius, peg_radius, centre, half_length, half_width);
    }
};

}  // namespace fulcrum
