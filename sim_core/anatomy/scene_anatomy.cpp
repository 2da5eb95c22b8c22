// SPDX-License-Identifier: Apache-2.0
#include "sim_core/anatomy/scene_anatomy.h"

namespace fulcrum {

PelvisParameters pelvis_parameters(const CavitySpec& spec) {
    PelvisParameters pelvis;
    pelvis.width = spec.pelvis_width;
    pelvis.depth = spec.pelvis_depth;
    pelvis.seed = spec.seed;
    return pelvis;
}

BowelParameters bowel_parameters(const BowelSpec& spec) {
    BowelParameters bowel;
    bowel.length = spec.length;
    bowel.radius = spec.outer_radius;
    bowel.vertices = spec.surface_vertices;
    bowel.seed = spec.seed;
    return bowel;
}

TriangleMesh cavity_mesh(const CavitySpec& spec) {
    return make_cavity(pelvis_parameters(spec)).mesh;
}

RectumParameters rectum_parameters(const Scene& scene) {
    RectumParameters rectum;
    const PresacralSpec& presacral = *scene.presacral;
    rectum.curve = {presacral.centre, presacral.curve_radius, presacral.caudal_angle,
                    scene.bowel->outer_radius, presacral.gap};
    rectum.length = scene.bowel->length;
    rectum.promontory = rectum.curve.arc_length(presacral.promontory_angle);
    rectum.vertices = scene.bowel->surface_vertices;
    rectum.unevenness = presacral.unevenness;
    rectum.seed = presacral.seed;
    return rectum;
}

double septum_arc_length(const SeptaSpec& spec, const SacralCurve& curve, int index) {
    const double plane_radius = curve.fascia_radius() - spec.plane_height;
    return curve.arc_length(spec.first_angle - index * (spec.spacing / (curve.curve_radius + plane_radius)));
}

}  // namespace fulcrum
