// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include "sim_core/numerics/functions.h"
#include "sim_core/scene/json_names.h"
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {

namespace {

ObjectsSpec read_objects_spec(const JsonDocument& document, const nlohmann::json& node) {
    using scene_json::copy;
    ObjectsSpec objects;
    copy(node, "count", objects.count);
    copy(node, "sides", objects.sides);
    copy(node, "corner_radius", objects.corner_radius);
    copy(node, "tube_radius", objects.tube_radius);
    copy(node, "mass", objects.mass);
    copy(node, "friction", objects.friction);
    copy(node, "centre", objects.centre);
    copy(node, "half_length", objects.half_length);
    copy(node, "half_width", objects.half_width);
    copy(node, "gap", objects.gap);
    copy(node, "spacing", objects.spacing);
    copy(node, "jitter", objects.jitter);
    copy(node, "peg_radius", objects.peg_radius);
    copy(node, "peg_height", objects.peg_height);
    copy_named(document, node, "/objects", "from", hand_names, objects.from);
    copy(node, "tissue", objects.tissue);
    copy(node, "tray_tissue", objects.tray_tissue);

    constexpr double pi = 3.14159265358979323846;
    const double hole = objects.corner_radius * math::cos(pi / objects.sides) - objects.tube_radius;
    if (hole < objects.peg_radius + 0.0005) {
        document.fail("/objects/corner_radius",
                      QT_TRANSLATE_NOOP("errors", "the rings do not fit around the pegs"),
                      QT_TRANSLATE_NOOP("errors", "give larger rings, thinner tubes or thinner pegs"));
    }
    const double widest = objects.corner_radius + objects.tube_radius;
    if (objects.spacing < 2 * (widest + objects.jitter)) {
        document.fail(
            "/objects/spacing", QT_TRANSLATE_NOOP("errors", "rings around neighbouring pegs would overlap"),
            QT_TRANSLATE_NOOP("errors", "give pegs that are further apart, smaller rings or less jitter"));
    }
    // Two columns of up to three pegs in each group.
    const int rows = (std::min(objects.count, 6) + 1) / 2;
    const double x = 0.5 * objects.gap + 0.5 * objects.spacing + widest + objects.jitter;
    const double y = 0.5 * (rows - 1) * objects.spacing + widest + objects.jitter;
    if (objects.gap < 2 * objects.spacing || x > objects.half_length || y > objects.half_width) {
        document.fail(
            "/objects/half_length",
            QT_TRANSLATE_NOOP("errors", "the pegs do not fit on the tray side by side"),
            QT_TRANSLATE_NOOP("errors",
                              "give a larger tray, a gap of at least twice the spacing, or fewer rings"));
    }
    return objects;
}

}  // namespace

void read_objects(const PartReading& reading, const nlohmann::json& node) {
    const ObjectsSpec objects = read_objects_spec(reading.document, node);
    for (const std::string& label : {objects.tissue, objects.tray_tissue})
        reading.check_tissue("/objects", label);
    if (reading.scene.bowel || reading.scene.cavity || reading.scene.targets || reading.scene.sheet ||
        reading.scene.bands || reading.scene.presacral) {
        reading.document.fail(
            "/objects",
            QT_TRANSLATE_NOOP("errors",
                              "objects on a tray cannot be combined with tissue, cavity or targets"),
            QT_TRANSLATE_NOOP("errors", "remove those parts or \"objects\""));
    }
    reading.scene.objects = objects;
}

}  // namespace fulcrum
