// SPDX-License-Identifier: Apache-2.0
// Values shared by bands (B3) and the structures of a pelvic wall (C4): nerves, bleeding vessels, heat,
// suction, clips, instrument exchange. SI units. Values are provisional unless a source is given.
#pragma once

#include <string>

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct FieldSpec {
    double nerve_radius = 0.0015;  ///< m
    double nerve_dose_limit = 60;  ///< min (CEM43), thermal dose above which the nerve is injured
    double safe_distance = 0.002;  ///< m, from blade to nerve

    double vessel_radius = 0.6e-3;    ///< m
    double vessel_pressure = 12.4e3;  ///< Pa: mean arterial, 93 mmHg
    double feeding_length = 0.3;      ///< m
    double clotting_time = 600;       ///< s
    double seal_time = 1.2;           ///< s at full heat until a vessel has closed to 1/e

    double density = 1050;        ///< kg/m3
    double conductivity = 0.5;    ///< W/(m K), soft tissue (Duck 1990)
    double specific_heat = 3600;  ///< J/(kg K), soft tissue (Duck 1990)
    double water_share = 0.7;     ///< of a tissue's mass
    double suction_flow = 8e-6;   ///< m3/s of blood
    int clips = 12;               ///< clips in the applier
    double exchange_time = 2.0;   ///< s to exchange an instrument through the trocar; at least a step

    std::string bed_tissue = "bed", nerve_tissue = "nerve", vessel_tissue = "vessel";
};

}  // namespace fulcrum
