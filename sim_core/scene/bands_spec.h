// SPDX-License-Identifier: Apache-2.0
// Elastic bands between posts above a bed, some with a vessel, next to a nerve (task B3): their values in a
// scene. SI units. Mechanical, thermal and vascular values are provisional unless a source is given.
#pragma once

#include "sim_core/scene/field_spec.h"

namespace fulcrum {

/// Positions are drawn from the attempt's seed: two columns along y, the bands along x within `tilt` of it.
struct BandsSpec : FieldSpec {
    int count = 10;                         ///< 2 .. 16
    int vessels = 3;                        ///< number of bands with a vessel, at most count
    Vector3 centre = Vector3(0, 0, -0.03);  ///< m, middle of the bed
    Vector3 half_extent =
        Vector3(0.05, 0.04, 0.008);  ///< m, of the bed; z: height of its rim above its middle
    double height = 0.020;           ///< m, bands above the bed's middle
    double length = 0.026, width = 0.006, thickness = 0.002;  ///< m, of a band
    double jitter = 0.003;                                    ///< m, random displacement of a band
    double tilt = 0.26;                                       ///< rad, largest angle of a band to x
    double young_modulus = 200e3;                             ///< Pa
    double pre_strain = 0.15;
    double tear_force = 2.5;     ///< N, tension at which a band tears
    double nerve_gap = 0.010;    ///< m, depth of the nerve below the bands of its column
    double recoil_tension = 2;   ///< N at which the branch at a vessel's root tears open completely
    double least_recoil = 0.35;  ///< fraction of it that tears open without tension
    std::string tissue = "band";
};

}  // namespace fulcrum
