// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {

void read_targets(const PartReading& reading, const nlohmann::json& node) {
    using scene_json::copy;
    TargetFieldSpec targets;
    copy(node, "per_hand", targets.per_hand);
    copy(node, "radius", targets.radius);
    copy(node, "centre", targets.centre);
    copy(node, "half_extent", targets.half_extent);
    copy(node, "minimum_distance", targets.minimum_distance);
    copy(node, "tissue", targets.tissue);
    copy(node, "stiffness", targets.stiffness);
    copy(node, "damping", targets.damping);
    reading.check_tissue("/targets", targets.tissue);
    if (targets.half_extent.minCoeff() <= 0 || targets.half_extent.maxCoeff() > 0.3) {
        reading.document.fail("/targets/half_extent",
                              QT_TRANSLATE_NOOP("errors", "the box has an edge of 0 or above 0.6 m"),
                              QT_TRANSLATE_NOOP("errors", "give three half edges in metres, each above 0"));
    }
    // Random packing of spheres of half the distance succeeds for fill ratios well below 0.2; above that
    // it may never end.
    const double box = 8 * targets.half_extent.prod();
    const double filled = 2 * targets.per_hand * 0.5236 * std::pow(targets.minimum_distance, 3);
    if (filled > 0.32 * box) {
        reading.document.fail(
            "/targets/per_hand",
            QT_TRANSLATE_NOOP("errors", "the box has no room for this many targets at this distance"),
            QT_TRANSLATE_NOOP("errors",
                              "give fewer targets, a smaller minimum_distance or a larger half_extent"));
    }
    reading.scene.targets = targets;
}

}  // namespace fulcrum
