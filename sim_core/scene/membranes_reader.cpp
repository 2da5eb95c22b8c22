// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {

void read_membranes(const PartReading& reading, const nlohmann::json& list) {
    using scene_json::copy;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const nlohmann::json& node = list[i];
        MembraneSpec membrane;
        copy(node, "kind", membrane.kind);
        copy(node, "first", membrane.first);
        copy(node, "last", membrane.last);
        copy(node, "structural_stiffness", membrane.structural_stiffness);
        copy(node, "shear_stiffness", membrane.shear_stiffness);
        copy(node, "bend_stiffness", membrane.bend_stiffness);
        copy(node, "surface_density", membrane.surface_density);
        copy(node, "pre_strain", membrane.pre_strain);
        copy(node, "stiffness_damping", membrane.stiffness_damping);
        copy(node, "mass_damping", membrane.mass_damping);
        copy(node, "weight", membrane.weight);
        const std::string place = "/membranes/" + std::to_string(i);
        if (!reading.scene.bowel || !reading.scene.cavity) {
            reading.document.fail(
                place, QT_TRANSLATE_NOOP("errors", "a membrane needs a bowel and a cavity to attach to"),
                QT_TRANSLATE_NOOP("errors", "add \"bowel\" and \"cavity\" or remove \"membranes\""));
        }
        if (membrane.first >= membrane.last) {
            reading.document.fail(
                place + "/first", QT_TRANSLATE_NOOP("errors", "first must be below last"),
                QT_TRANSLATE_NOOP("errors", "give first < last, fractions of the bowel's length"));
        }
        reading.scene.membranes.push_back(membrane);
    }
}

}  // namespace fulcrum
