// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {

void read_tethers(const PartReading& reading, const nlohmann::json& node) {
    using scene_json::copy;
    TetherSpec tethers;
    copy(node, "count", tethers.count);
    copy(node, "first", tethers.first);
    copy(node, "last", tethers.last);
    copy(node, "stiffness", tethers.stiffness);
    copy(node, "damping", tethers.damping);
    copy(node, "slack", tethers.slack);
    if (!reading.document.root().contains("bowel")) {
        reading.document.fail("/tethers", QT_TRANSLATE_NOOP("errors", "tethers need a bowel"),
                              QT_TRANSLATE_NOOP("errors", "add a \"bowel\" or remove \"tethers\""));
    }
    if (tethers.first >= tethers.last) {
        reading.document.fail(
            "/tethers/first", QT_TRANSLATE_NOOP("errors", "first must be below last"),
            QT_TRANSLATE_NOOP("errors", "give first < last, fractions of the bowel's length"));
    }
    reading.scene.tethers = tethers;
}

}  // namespace fulcrum
