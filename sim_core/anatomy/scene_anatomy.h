// SPDX-License-Identifier: Apache-2.0
// From what a scene asks for to the parameters of the anatomy generator.
#pragma once

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/anatomy/rectum.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

PelvisParameters pelvis_parameters(const CavitySpec& spec);
BowelParameters bowel_parameters(const BowelSpec& spec);
TriangleMesh cavity_mesh(const CavitySpec& spec);
/// Of a scene with a rectum and a presacral wall.
RectumParameters rectum_parameters(const Scene& scene);
/// m along the rectum, of septum `index`; 0 is the most cranial.
double septum_arc_length(const SeptaSpec& spec, const SacralCurve& curve, int index);

}  // namespace fulcrum
