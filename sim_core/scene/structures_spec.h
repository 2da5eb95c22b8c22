// SPDX-License-Identifier: Apache-2.0
// Structures in and in front of the wall behind the rectum (task C4): presacral veins beneath the fascia, two
// hypogastric nerves in front of it. SI units; generated from these values over the wall of the scene.
#pragma once

#include "sim_core/scene/field_spec.h"

namespace fulcrum {

/// Veins: one in the middle, one on either side, rungs between them. vessel_radius is that of the long ones.
/// Venous pressure of a supine patient; flow by VesselModel.
struct StructuresSpec : FieldSpec {
    StructuresSpec() {
        vessel_radius = 0.0012;
        vessel_pressure = 1330;  // 10 mmHg
        feeding_length = 0.15;
        clotting_time = 900;
        seal_time = 2.0;
        bed_tissue = "fascia";
        vessel_tissue = "vein";
    }
    double vein_lateral = 0.014;  ///< m along the wall from its middle, of the long veins to either side
    int rungs = 5;                ///< 0 .. 16, across from one lateral vein to the other
    double rung_radius = 0.0008;  ///< m
    double vein_depth = 0.0005;   ///< m of fascia over a vein, which a blade must penetrate
    double vein_tear_force =
        2.5;                ///< N, force of a blunt tip on the fascia over a vein above which the vein tears
    double wander = 0.001;  ///< m, lateral deviation of the veins, drawn from the attempt's seed
    double nerve_cranial = 0.037;  ///< m along the wall from its middle, where a nerve enters
    double nerve_caudal = 0.039;   ///< m along the wall from its middle, where it leaves
    double nerve_height = 0.0025;  ///< m, distance of its axis from the fascia
    double cell = 0.005;           ///< m, edge of a wall cell, the grid of pooled blood and heat
};

}  // namespace fulcrum
