// SPDX-License-Identifier: Apache-2.0
// Elastic bands between posts above a bed, some with a vessel, beside a nerve (task B3): what a scene may say
// of them. SI units. Mechanical, thermal and vascular figures are ours and provisional except where a source
// is named.
#pragma once

#include <string>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Where they stand is drawn from the attempt's seed: two columns along y, the bands along x within `tilt` of
/// it.
struct BandsSpec {
    int count = 10;                         ///< 2 .. 16
    int vessels = 3;                        ///< how many of them carry one, at most count
    Vector3 centre = Vector3(0, 0, -0.03);  ///< m, middle of the bed
    Vector3 half_extent =
        Vector3(0.05, 0.04, 0.008);  ///< m, of the bed; z: how far its rim lies above its middle
    double height = 0.020;           ///< m, bands above the bed's middle
    double length = 0.026, width = 0.006, thickness = 0.002;  ///< m, of a band
    double jitter = 0.003;                                    ///< m, of a band's place
    double tilt = 0.26;                                       ///< rad, largest angle of a band to x
    double young_modulus = 200e3;                             ///< Pa
    double pre_strain = 0.15;
    double density = 1050;    ///< kg/m3
    double tear_force = 2.5;  ///< N, tension at which a band tears

    double nerve_gap = 0.010;      ///< m, nerve beneath the bands of its column
    double nerve_radius = 0.0015;  ///< m
    double nerve_dose_limit = 60;  ///< min (CEM43), above it the nerve is injured
    double safe_distance = 0.002;  ///< m, blade to nerve

    double vessel_radius = 0.6e-3;    ///< m
    double vessel_pressure = 12.4e3;  ///< Pa: mean arterial, 93 mmHg
    double feeding_length = 0.3;      ///< m
    double clotting_time = 600;       ///< s
    double seal_time = 1.2;           ///< s at full heat in which a vessel closes to 1/e
    double recoil_tension = 2.0;      ///< N at which the branch at a vessel's root tears open wholly
    double least_recoil = 0.35;       ///< share of it that tears open without tension

    double conductivity = 0.5;    ///< W/(m K), soft tissue (Duck 1990)
    double specific_heat = 3600;  ///< J/(kg K), soft tissue (Duck 1990)
    double water_share = 0.7;     ///< of a band's mass
    double suction_flow = 8e-6;   ///< m3/s of blood
    int clips = 12;               ///< in the applier
    double exchange_time = 2.0;   ///< s for one instrument to come through the trocar in place of another

    std::string tissue = "band", bed_tissue = "bed", nerve_tissue = "nerve", vessel_tissue = "vessel";
};

}  // namespace fulcrum
