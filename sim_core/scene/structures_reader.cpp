// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/field_json.h"
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {

namespace {

using scene_json::copy;

StructuresSpec read_structures_spec(const JsonDocument& document, const nlohmann::json& node) {
    StructuresSpec structures;
    scene_json::copy_field(node, structures);
    copy(node, "vein_lateral", structures.vein_lateral);
    copy(node, "rungs", structures.rungs);
    copy(node, "rung_radius", structures.rung_radius);
    copy(node, "vein_depth", structures.vein_depth);
    copy(node, "vein_tear_force", structures.vein_tear_force);
    copy(node, "wander", structures.wander);
    copy(node, "nerve_cranial", structures.nerve_cranial);
    copy(node, "nerve_caudal", structures.nerve_caudal);
    copy(node, "nerve_height", structures.nerve_height);
    copy(node, "cell", structures.cell);
    if (structures.rung_radius > structures.vessel_radius) {
        document.fail("/structures/rung_radius",
                      QT_TRANSLATE_NOOP("errors", "a rung is wider than the veins it joins"),
                      QT_TRANSLATE_NOOP("errors", "give at most \"vessel_radius\""));
    }
    if (structures.nerve_height < structures.nerve_radius) {
        document.fail("/structures/nerve_height",
                      QT_TRANSLATE_NOOP("errors", "the nerves would be inside the fascia"),
                      QT_TRANSLATE_NOOP("errors", "give at least \"nerve_radius\""));
    }
    if (structures.wander > 0.5 * structures.vein_lateral) {
        document.fail("/structures/wander",
                      QT_TRANSLATE_NOOP("errors", "veins that wander this far would intersect"),
                      QT_TRANSLATE_NOOP("errors", "give at most half of \"vein_lateral\""));
    }
    return structures;
}

}  // namespace

void read_structures(const PartReading& reading, const nlohmann::json& node) {
    const StructuresSpec structures = read_structures_spec(reading.document, node);
    for (const std::string& label :
         {structures.bed_tissue, structures.nerve_tissue, structures.vessel_tissue}) {
        reading.check_tissue("/structures", label);
    }
    if (!reading.scene.presacral) {
        reading.document.fail("/structures", QT_TRANSLATE_NOOP("errors", "structures need a presacral wall"),
                              QT_TRANSLATE_NOOP("errors", "add \"presacral\" or remove \"structures\""));
    }
    if (reading.scene.bands) {
        reading.document.fail("/structures",
                              QT_TRANSLATE_NOOP("errors", "bands and structures cannot be combined"),
                              QT_TRANSLATE_NOOP("errors", "remove \"bands\" or \"structures\""));
    }
    reading.scene.structures = structures;
}

}  // namespace fulcrum
