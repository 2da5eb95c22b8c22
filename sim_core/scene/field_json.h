// SPDX-License-Identifier: Apache-2.0
// Keys shared by "bands" and "structures" of a scene file.
#pragma once

#include "sim_core/scene/field_spec.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum::scene_json {

inline void copy_field(const nlohmann::json& node, FieldSpec& field) {
    copy(node, "nerve_radius", field.nerve_radius);
    copy(node, "nerve_dose_limit", field.nerve_dose_limit);
    copy(node, "safe_distance", field.safe_distance);
    copy(node, "vessel_radius", field.vessel_radius);
    copy(node, "vessel_pressure", field.vessel_pressure);
    copy(node, "feeding_length", field.feeding_length);
    copy(node, "clotting_time", field.clotting_time);
    copy(node, "seal_time", field.seal_time);
    copy(node, "density", field.density);
    copy(node, "conductivity", field.conductivity);
    copy(node, "specific_heat", field.specific_heat);
    copy(node, "water_share", field.water_share);
    copy(node, "suction_flow", field.suction_flow);
    copy(node, "clips", field.clips);
    copy(node, "exchange_time", field.exchange_time);
    copy(node, "bed_tissue", field.bed_tissue);
    copy(node, "nerve_tissue", field.nerve_tissue);
    copy(node, "vessel_tissue", field.vessel_tissue);
}

}  // namespace fulcrum::scene_json
