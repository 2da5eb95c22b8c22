// SPDX-License-Identifier: Apache-2.0
// Procedural anatomy: the abdominopelvic cavity, the rectosigmoid at rest and as it lies in the body, the root of its mesentery.
// Pure functions of parameters; deterministic (functions of sim_core/numerics only). Patient frame, m: origin in the middle of the
// pelvic inlet, +x to the patient's left, +y cranial, +z anterior.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/bowel/spheres.h"
#include "sim_core/geometry/mesh.h"

namespace fulcrum {

struct PelvisParameters {
    double width = 0.125;        ///< m, transverse diameter of the inlet, 0.09 .. 0.16
    double depth = 0.115;        ///< m, inlet to pelvic floor, 0.08 .. 0.15
    double abdomen_width = 0.27; ///< m, at the level of the trocars
    double height = 0.16;        ///< m, posterior to anterior wall under pneumoperitoneum
    double cranial_end = 0.21;   ///< m, where the modelled cavity ends
    int rows = 96, columns = 104;  ///< of the mesh; about 2 rows columns triangles
    std::uint64_t seed = 1;      ///< individual unevenness of the walls
};

struct BowelParameters {
    double length = 0.9;         ///< m
    double radius = 0.016;       ///< m, mean outer
    double haustra_spacing = 0.034;  ///< m
    double haustra_depth = 0.12;     ///< share of the radius
    double rectum_length = 0.13;     ///< m, without haustra, from the fixed end
    int vertices = 20000;        ///< asked; the generator rounds
    std::uint64_t seed = 1;      ///< individual spacing and depth of haustra
};

/// Height z of the posterior wall under (x, y), as make_cavity shapes it.
double posterior_wall(const PelvisParameters& pelvis, double x, double y);

/// Closed surface, outward oriented (the bodies are inside), texture coordinates in units of 0.1 m. Throws InputError for
/// parameters out of range.
TriangleMesh make_cavity(const PelvisParameters& pelvis);

struct BowelShape {
    TriangleMesh surface;              ///< rest tube along +x from the origin, closed, outward; u along, v around (0..1)
    double length = 0;                 ///< m
    RadiusProfile radius;              ///< lumen radius by rest arc length
    std::vector<Vector3> centre_line;  ///< in situ, first = rectal end, equal steps
    std::vector<Vector3> root_line;    ///< mesenteric root on the posterior wall, first = rectal end
};

/// Throws InputError where a bowel of that length cannot be laid into that cavity.
BowelShape make_bowel(const BowelParameters& bowel, const PelvisParameters& pelvis);

}  // namespace fulcrum
