// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {

void read_sheet(const PartReading& reading, const nlohmann::json& node) {
    using scene_json::copy;
    SheetSpec sheet;
    copy(node, "kind", sheet.kind);
    copy(node, "tissue", sheet.tissue);
    copy(node, "centre", sheet.centre);
    copy(node, "along", sheet.along);
    copy(node, "across", sheet.across);
    copy(node, "length", sheet.length);
    copy(node, "width", sheet.width);
    copy(node, "spacing", sheet.spacing);
    copy(node, "thickness", sheet.thickness);
    sheet.line_length = std::min(sheet.line_length, sheet.length);
    copy(node, "line_length", sheet.line_length);
    copy(node, "line_at", sheet.line_at);
    copy(node, "flap_stiffness", sheet.flap_stiffness);
    copy(node, "structural_stiffness", sheet.structural_stiffness);
    copy(node, "shear_stiffness", sheet.shear_stiffness);
    copy(node, "bend_stiffness", sheet.bend_stiffness);
    copy(node, "surface_density", sheet.surface_density);
    copy(node, "pre_strain", sheet.pre_strain);
    copy(node, "stiffness_damping", sheet.stiffness_damping);
    copy(node, "mass_damping", sheet.mass_damping);
    copy(node, "weight", sheet.weight);
    copy(node, "blade_width", sheet.blade_width);
    copy(node, "fibres", sheet.fibres);
    reading.check_tissue("/sheet", sheet.tissue);
    for (Vector3* direction : {&sheet.along, &sheet.across}) {
        if (direction->norm() < 1e-6) {
            reading.document.fail(direction == &sheet.along ? "/sheet/along" : "/sheet/across",
                                  QT_TRANSLATE_NOOP("errors", "the direction has no length"),
                                  QT_TRANSLATE_NOOP("errors", "give a vector in the sheet's plane"));
        }
        direction->normalize();
    }
    sheet.across -= sheet.along * sheet.along.dot(sheet.across);
    if (sheet.across.norm() < 0.1) {
        reading.document.fail("/sheet/across",
                              QT_TRANSLATE_NOOP("errors", "across is parallel to the marked line"),
                              QT_TRANSLATE_NOOP("errors", "give a direction at right angles to \"along\""));
    }
    sheet.across.normalize();
    if (sheet.line_length > sheet.length) {
        reading.document.fail("/sheet/line_length",
                              QT_TRANSLATE_NOOP("errors", "the marked line is longer than the sheet"),
                              QT_TRANSLATE_NOOP("errors", "give at most length"));
    }
    if (sheet.spacing > 0.25 * std::min(sheet.length, sheet.width) ||
        sheet.length / sheet.spacing * (sheet.width / sheet.spacing) > 20000) {
        reading.document.fail(
            "/sheet/spacing",
            QT_TRANSLATE_NOOP("errors",
                              "the sheet would have fewer than five vertices along an edge, "
                              "or more than 20000 in total"),
            QT_TRANSLATE_NOOP("errors", "give a spacing that suits length and width"));
    }
    reading.scene.sheet = sheet;
}

}  // namespace fulcrum
