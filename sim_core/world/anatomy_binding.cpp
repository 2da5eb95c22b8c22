// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/anatomy_binding.h"

#include "sim_core/numerics/input_error.h"

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

TriangleMesh cavity_mesh(const CavitySpec& spec) { return make_cavity(pelvis_parameters(spec)).mesh; }

BowelAnatomy bowel_anatomy(const Scene& scene) {
    if (!scene.bowel || !scene.cavity) throw InputError(scene.id, "/bowel", "needs a cavity to lie in", "add a cavity to the scene");
    BowelShape shape = make_bowel(bowel_parameters(*scene.bowel), pelvis_parameters(*scene.cavity));
    BowelAnatomy anatomy;
    anatomy.surface = std::move(shape.surface);
    anatomy.length = shape.length;
    anatomy.radius = std::move(shape.radius);
    anatomy.centre_line = std::move(shape.centre_line);
    anatomy.root_line = std::move(shape.root_line);
    return anatomy;
}

}  // namespace fulcrum
