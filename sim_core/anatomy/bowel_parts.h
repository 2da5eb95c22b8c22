// SPDX-License-Identifier: Apache-2.0
// The two halves of make_bowel: the tube at rest and its position in the body.
#pragma once

#include "sim_core/anatomy/anatomy.h"

namespace fulcrum {

/// Mean outer radius at fraction 0 .. 1 of the length, as a factor of the parameter: the rectum is wide, the
/// rectosigmoid narrow.
double bowel_width(double share);

/// The triangles of a closed tube, facing outwards: its first pole is vertex 0, ring i's vertices are
/// 1 + i around + k, k = 0 .. around - 1, its other pole is the vertex after the last ring's.
void add_capped_tube(int rings, int around, TriangleMesh& mesh);

/// Sets surface, taenia and radius.
void make_bowel_surface(const BowelParameters& parameters, BowelShape& bowel);

/// Sets centre_line and root_line. Throws InputError if a bowel of that length does not fit the cavity.
void lay_bowel(const BowelParameters& parameters, const CavityShape& cavity, BowelShape& bowel);

}  // namespace fulcrum
