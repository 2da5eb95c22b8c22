// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {
namespace {

using nlohmann::json;

using scene_json::copy;
using scene_json::copy_degrees;

PresacralSpec read_presacral_spec(const JsonDocument& document, const json& node, double length) {
    PresacralSpec presacral;
    copy(node, "centre", presacral.centre);
    copy(node, "curve_radius", presacral.curve_radius);
    copy_degrees(node, "caudal_angle_deg", presacral.caudal_angle);
    copy_degrees(node, "promontory_angle_deg", presacral.promontory_angle);
    copy(node, "gap", presacral.gap);
    copy(node, "hold_stiffness", presacral.hold_stiffness);
    copy(node, "unevenness", presacral.unevenness);
    copy(node, "seed", presacral.seed);
    copy(node, "tissue", presacral.tissue);
    if (!(presacral.promontory_angle > presacral.caudal_angle) ||
        presacral.promontory_angle > presacral.caudal_angle + length / presacral.curve_radius) {
        document.fail("/presacral/promontory_angle_deg",
                      QT_TRANSLATE_NOOP("errors", "the promontory is beyond an end of the rectum"),
                      QT_TRANSLATE_NOOP("errors", "give an angle between the rectum's ends"));
    }
    return presacral;
}

SeptaSpec read_septa_spec(const JsonDocument& document, const json& node, const PresacralSpec& presacral,
                          double length, double radius) {
    SeptaSpec septa;
    copy(node, "count", septa.count);
    copy(node, "spacing", septa.spacing);
    copy_degrees(node, "first_angle_deg", septa.first_angle);
    copy(node, "width", septa.width);
    copy(node, "node_spacing", septa.node_spacing);
    copy(node, "areolar_rows", septa.areolar_rows);
    copy(node, "fat_rows", septa.fat_rows);
    copy(node, "plane_height", septa.plane_height);
    copy(node, "areolar_height", septa.areolar_height);
    copy(node, "thickness", septa.thickness);
    copy(node, "tissue", septa.tissue);
    copy(node, "fat_tissue", septa.fat_tissue);
    copy(node, "structural_stiffness", septa.structural_stiffness);
    copy(node, "shear_stiffness", septa.shear_stiffness);
    copy(node, "bend_stiffness", septa.bend_stiffness);
    copy(node, "fat_stiffness", septa.fat_stiffness);
    copy(node, "surface_density", septa.surface_density);
    copy(node, "pre_strain", septa.pre_strain);
    copy(node, "stiffness_damping", septa.stiffness_damping);
    copy(node, "mass_damping", septa.mass_damping);
    copy(node, "weight", septa.weight);
    copy(node, "blade_width", septa.blade_width);
    copy(node, "fibres", septa.fibres);
    septa.fat_height = presacral.gap;
    if (!(septa.plane_height < septa.areolar_height)) {
        document.fail("/septa/plane_height",
                      QT_TRANSLATE_NOOP("errors", "the intended plane is outside the areolar zone"),
                      QT_TRANSLATE_NOOP("errors", "give less than areolar_height"));
    }
    if (!(septa.areolar_height < 0.8 * septa.fat_height)) {
        document.fail("/septa/areolar_height",
                      QT_TRANSLATE_NOOP("errors", "the areolar zone leaves no room for the mesorectal fat"),
                      QT_TRANSLATE_NOOP("errors", "give less than 0.8 of presacral.gap"));
    }
    // Beyond a right angle to either side a septum would be lateral to the rectum, not behind it.
    constexpr double widest = 3.0;  // rad
    const double plane_radius = radius + presacral.gap - septa.plane_height;
    if (septa.width > widest * plane_radius) {
        document.fail("/septa/width", QT_TRANSLATE_NOOP("errors", "the septa would extend around the rectum"),
                      QT_TRANSLATE_NOOP("errors", "give less, or a wider presacral.gap or rectum"));
    }
    if (septa.node_spacing > 0.25 * septa.width || septa.width / septa.node_spacing > 200) {
        document.fail(
            "/septa/node_spacing",
            QT_TRANSLATE_NOOP("errors",
                              "a septum would have fewer than five vertices along it, or more than 200"),
            QT_TRANSLATE_NOOP("errors", "give a spacing that suits the width"));
    }
    const double step = septa.spacing / (presacral.curve_radius + plane_radius);
    const double last = septa.first_angle - (septa.count - 1) * step;
    if (septa.first_angle > presacral.promontory_angle ||
        last < presacral.caudal_angle + 0.03 * length / presacral.curve_radius) {
        document.fail("/septa/first_angle_deg",
                      QT_TRANSLATE_NOOP("errors", "a septum is above the promontory or below the rectum"),
                      QT_TRANSLATE_NOOP(
                          "errors", "give fewer or closer septa, another first angle or a longer rectum"));
    }
    return septa;
}

}  // namespace

void read_presacral(const PartReading& reading, const json& node) {
    const Scene& scene = reading.scene;
    if (!scene.bowel)
        reading.document.fail("/presacral", QT_TRANSLATE_NOOP("errors", "a presacral wall needs a rectum"),
                              QT_TRANSLATE_NOOP("errors", "add a bowel of layout \"rectum\""));
    const PresacralSpec presacral = read_presacral_spec(reading.document, node, scene.bowel->length);
    reading.check_tissue("/presacral", presacral.tissue);
    if (scene.bowel->layout != BowelLayout::rectum) {
        reading.document.fail(
            "/presacral", QT_TRANSLATE_NOOP("errors", "a rectum and a presacral wall need each other"),
            QT_TRANSLATE_NOOP(
                "errors", "give the bowel the layout \"rectum\" and the scene \"presacral\", or neither"));
    }
    if (scene.cavity || scene.tethers || !scene.membranes.empty() || scene.targets) {
        reading.document.fail(
            "/presacral",
            QT_TRANSLATE_NOOP(
                "errors",
                "a scene with a presacral wall cannot have a cavity, tethers, membranes or targets"),
            QT_TRANSLATE_NOOP("errors", "remove cavity, tethers, membranes and targets"));
    }
    reading.scene.presacral = presacral;
}

void read_septa(const PartReading& reading, const json& node) {
    const Scene& scene = reading.scene;
    if (!scene.presacral || scene.sheet) {
        reading.document.fail(
            "/septa",
            QT_TRANSLATE_NOOP("errors", "septa need a rectum and a presacral wall, and exclude a sheet"),
            QT_TRANSLATE_NOOP("errors",
                              "add \"presacral\" and a bowel of layout \"rectum\", and remove \"sheet\""));
    }
    const SeptaSpec septa = read_septa_spec(reading.document, node, *scene.presacral, scene.bowel->length,
                                            scene.bowel->outer_radius);
    reading.check_tissue("/septa", septa.tissue);
    reading.check_tissue("/septa", septa.fat_tissue);
    reading.scene.septa = septa;
}

}  // namespace fulcrum
