// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {

namespace {

CameraTargetsSpec read_camera_targets_spec(const JsonDocument& document, const nlohmann::json& node) {
    using scene_json::copy;
    CameraTargetsSpec targets;
    copy(node, "count", targets.count);
    copy(node, "ball_radius", targets.ball_radius);
    copy(node, "cup_radius", targets.cup_radius);
    copy(node, "wall", targets.wall);
    copy(node, "cup_depth", targets.cup_depth);
    copy(node, "distance", targets.distance);
    copy(node, "spacing", targets.spacing);
    copy(node, "least_insertion", targets.least_insertion);
    copy(node, "most_insertion", targets.most_insertion);
    scene_json::copy_degrees(node, "swing_deg", targets.swing);
    scene_json::copy_degrees(node, "tilt_deg", targets.tilt);
    copy(node, "lens_radius", targets.lens_radius);
    copy(node, "tip_centre", targets.tip_centre);
    copy(node, "tip_extent", targets.tip_extent);
    copy(node, "tip_speed", targets.tip_speed);
    copy(node, "tissue", targets.tissue);
    if (targets.ball_radius >= targets.cup_radius) {
        document.fail("/camera_targets/ball_radius",
                      QT_TRANSLATE_NOOP("errors", "the balls do not fit into the cups"),
                      QT_TRANSLATE_NOOP("errors", "give smaller balls or wider cups"));
    }
    if (targets.distance < targets.cup_depth + 2 * targets.lens_radius) {
        document.fail(
            "/camera_targets/distance", QT_TRANSLATE_NOOP("errors", "the lens would be in the cup"),
            QT_TRANSLATE_NOOP("errors", "give a larger distance, a shallower cup or a thinner scope"));
    }
    if (targets.least_insertion > targets.most_insertion) {
        document.fail("/camera_targets/least_insertion",
                      QT_TRANSLATE_NOOP("errors", "least_insertion is above most_insertion"),
                      QT_TRANSLATE_NOOP("errors", "give at most the value of most_insertion"));
    }
    if (targets.tip_extent.minCoeff() < 0) {
        document.fail("/camera_targets/tip_extent",
                      QT_TRANSLATE_NOOP("errors", "a tip cannot move by less than 0"),
                      QT_TRANSLATE_NOOP("errors", "give three values from 0 on"));
    }
    return targets;
}

}  // namespace

void read_camera_targets(const PartReading& reading, const nlohmann::json& node) {
    const JsonDocument& document = reading.document;
    Scene& scene = reading.scene;
    scene.camera_targets = read_camera_targets_spec(document, node);
    if (scene.tissue_index(scene.camera_targets->tissue) < 0)
        document.fail(
            "/camera_targets",
            {QT_TRANSLATE_NOOP("errors", "the tissue \"%1\" is not listed"), scene.camera_targets->tissue},
            QT_TRANSLATE_NOOP("errors", "add it to \"tissues\" or name another"));
    if (!scene.camera)
        document.fail("/camera_targets", QT_TRANSLATE_NOOP("errors", "targets to look at need a scope"),
                      QT_TRANSLATE_NOOP("errors", "add \"camera\""));
    if (scene.targets || !scene.instruments.empty())
        document.fail(
            "/camera_targets",
            QT_TRANSLATE_NOOP("errors",
                              "a scene for the scope alone has no instruments and no targets to touch"),
            QT_TRANSLATE_NOOP("errors", "remove \"instruments\" and \"targets\", or \"camera_targets\""));
    for (const char* part : {"cavity", "bowel", "tethers", "membranes", "sheet", "septa", "presacral",
                             "bands", "structures", "objects"}) {
        if (document.root().contains(part))
            document.fail(std::string("/") + part,
                          QT_TRANSLATE_NOOP("errors", "cups for the camera would lie in the tissue"),
                          {QT_TRANSLATE_NOOP("errors", "remove \"%1\" or \"camera_targets\""), part});
    }
}

}  // namespace fulcrum
