// SPDX-License-Identifier: Apache-2.0
// Rigid rings and pegs on a tray, to be handed over (task A3): their values in a scene. SI units.
#pragma once

#include <string>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Two groups of pegs, half of them on either side of the tray's middle, and rings around those of one group.
/// The attempt's seed moves each peg and turns each ring.
struct ObjectsSpec {
    static constexpr int most = 6;
    int count = most;                        ///< rings, 1 .. most; twice as many pegs
    int sides = 3;                           ///< straight tubes of a ring, 3 .. 6
    double corner_radius = 0.013;            ///< m, from a ring's middle to its corners
    double tube_radius = 0.0015;             ///< m
    double mass = 0.0015;                    ///< kg, of a ring
    double friction = 0.4;                   ///< of rings on tray, pegs, each other and instruments
    Vector3 centre = Vector3(0, 0, -0.035);  ///< m, middle of the tray's upper face
    double half_length = 0.07;               ///< m, of the tray along x
    double half_width = 0.052;               ///< m, along y
    double gap = 0.07;                       ///< m along x between the two groups' middles
    double spacing = 0.034;                  ///< m between pegs of a group
    double jitter = 0.002;                   ///< m, largest displacement of a peg
    double peg_radius = 0.0015;              ///< m
    double peg_height = 0.014;               ///< m
    Hand from = Hand::left;                  ///< side on which the rings lie; left: +x of the patient
    std::string tissue = "object";           ///< label of the rings
    std::string tray_tissue = "tray";        ///< label of tray and pegs
};

}  // namespace fulcrum
