// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/json_names.h"
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {
namespace {

using nlohmann::json;

using scene_json::copy;

constexpr NameRow<BowelLayout> bowel_layouts[] = {
    {BowelLayout::colon, "colon", "rectosigmoid in a cavity"},
    {BowelLayout::rectum, "rectum", "rectum along the sacral hollow"},
};
static_assert(in_order(bowel_layouts));

// Thickness and stiffness of the whole wall follow from its layers.
void read_layers(const JsonDocument& document, const json& node, BowelSpec& bowel) {
    bowel.wall_thickness = 0;
    for (const json& entry : node) {
        WallLayer layer;
        copy(entry, "thickness", layer.thickness);
        copy(entry, "young_modulus", layer.young);
        copy(entry, "exponent", layer.exponent);
        bowel.wall_thickness += layer.thickness;
        bowel.layers.push_back(layer);
    }
    if (bowel.wall_thickness >= bowel.outer_radius) {
        document.fail(
            "/bowel/layers",
            QT_TRANSLATE_NOOP("errors", "the layers together are thicker than the bowel's radius"),
            QT_TRANSLATE_NOOP("errors", "give layers whose thicknesses add up to less than outer_radius"));
    }
    const double one_pascal = tube_stiffness({{bowel.wall_thickness, 1.0, 1.0}}, bowel.outer_radius, 0).axial;
    bowel.young_modulus = tube_stiffness(bowel.layers, bowel.outer_radius, 0).axial / one_pascal;
}

NoduleSpec read_nodule(const JsonDocument& document, const json& node, const BowelSpec& bowel) {
    if (bowel.layers.empty()) {
        document.fail("/bowel/nodule", QT_TRANSLATE_NOOP("errors", "a nodule needs a wall with layers"),
                      QT_TRANSLATE_NOOP("errors", "give the bowel \"layers\""));
    }
    NoduleSpec nodule;
    copy(node, "at", nodule.at);
    double degrees = 0;
    copy(node, "angle_deg", degrees);
    nodule.angle = degrees * 3.14159265358979323846 / 180;
    copy(node, "height", nodule.shape.height);
    copy(node, "radius", nodule.shape.radius);
    copy(node, "young_modulus", nodule.shape.young);
    if (nodule.shape.height > bowel.layers.front().thickness) {
        document.fail("/bowel/nodule/height",
                      QT_TRANSLATE_NOOP("errors", "the nodule is thicker than the layer that it replaces"),
                      QT_TRANSLATE_NOOP("errors", "give a height of at most the first layer's thickness"));
    }
    return nodule;
}

BowelSpec read_bowel_spec(const JsonDocument& document, const json& node) {
    BowelSpec bowel;
    copy(node, "length", bowel.length);
    copy(node, "outer_radius", bowel.outer_radius);
    copy(node, "wall_thickness", bowel.wall_thickness);
    copy(node, "young_modulus", bowel.young_modulus);
    copy(node, "poisson_ratio", bowel.poisson_ratio);
    if (node.contains("layers")) read_layers(document, node.at("layers"), bowel);
    if (node.contains("nodule")) bowel.nodule = read_nodule(document, node.at("nodule"), bowel);
    copy(node, "luminal_bulk_modulus", bowel.luminal_bulk_modulus);
    copy(node, "linear_density", bowel.linear_density);
    copy(node, "damping", bowel.damping);
    copy(node, "segments", bowel.segments);
    copy(node, "sphere_spacing", bowel.sphere_spacing);
    copy(node, "surface_vertices", bowel.surface_vertices);
    copy(node, "seed", bowel.seed);
    copy(node, "tissue", bowel.tissue);
    copy(node, "floor_friction", bowel.floor_friction);
    copy_named(document, node, "/bowel", "layout", bowel_layouts, bowel.layout);
    copy(node, "weight", bowel.weight);
    copy(node, "blade_width", bowel.blade_width);
    if (bowel.wall_thickness >= bowel.outer_radius) {
        document.fail("/bowel/wall_thickness",
                      QT_TRANSLATE_NOOP("errors", "the wall is thicker than the bowel's radius"),
                      QT_TRANSLATE_NOOP("errors", "give a wall thinner than outer_radius"));
    }
    if (bowel.sphere_spacing > 4 * bowel.outer_radius || bowel.sphere_spacing < bowel.length / 1000) {
        document.fail(
            "/bowel/sphere_spacing",
            QT_TRANSLATE_NOOP("errors", "the spheres would leave gaps, or there would be more than 1000"),
            QT_TRANSLATE_NOOP("errors", "give a spacing near outer_radius, below four times it"));
    }
    return bowel;
}

}  // namespace

void read_bowel(const PartReading& reading, const nlohmann::json& node) {
    const BowelSpec bowel = read_bowel_spec(reading.document, node);
    reading.check_tissue("/bowel", bowel.tissue);
    if (bowel.layout == BowelLayout::rectum && !reading.document.root().contains("presacral")) {
        reading.document.fail(
            "/bowel/layout", QT_TRANSLATE_NOOP("errors", "a rectum and a presacral wall need each other"),
            QT_TRANSLATE_NOOP(
                "errors", "give the bowel the layout \"rectum\" and the scene \"presacral\", or neither"));
    }
    reading.scene.bowel = bowel;
}

}  // namespace fulcrum
