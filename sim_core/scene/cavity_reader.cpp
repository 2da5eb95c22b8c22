// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {

void read_cavity(const PartReading& reading, const nlohmann::json& node) {
    using scene_json::copy;
    CavitySpec cavity;
    copy(node, "pelvis_width", cavity.pelvis_width);
    copy(node, "pelvis_depth", cavity.pelvis_depth);
    copy(node, "seed", cavity.seed);
    copy(node, "tissue", cavity.tissue);
    reading.check_tissue("/cavity", cavity.tissue);
    reading.scene.cavity = cavity;
}

}  // namespace fulcrum
