// SPDX-License-Identifier: Apache-2.0
// From what a scene asks for to the generator's parameters: the one place where scenes and anatomy meet.
#pragma once

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/anatomy/rectum.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/parts/bowel/bowel_part.h"

namespace fulcrum {

PelvisParameters pelvis_parameters(const CavitySpec& spec);
BowelParameters bowel_parameters(const BowelSpec& spec);
TriangleMesh cavity_mesh(const CavitySpec& spec);
/// Of a scene with a rectum and a presacral wall.
RectumParameters rectum_parameters(const Scene& scene);
/// The scene has a bowel, and a cavity or a presacral wall for it. Throws InputError.
BowelAnatomy bowel_anatomy(const Scene& scene);

}  // namespace fulcrum
