// SPDX-License-Identifier: Apache-2.0
// Sigmoid colon or rectum: its values in a scene. SI units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim_core/material/layered_wall.h"

namespace fulcrum {

/// A stiff lump under the mucosa, for the contact with a layered wall.
struct NoduleSpec {
    double at = 0.5;   ///< fraction of the bowel's length
    double angle = 0;  ///< rad around the bowel, from d1 towards d2
    WallNodule shape;
};

/// Where a bowel lies.
enum class BowelLayout : std::uint8_t {
    colon,   ///< the rectosigmoid in a cavity
    rectum,  ///< along the sacral hollow; needs presacral
};

struct BowelSpec {
    double length = 0.9;            ///< m
    double outer_radius = 0.016;    ///< m, mean
    double wall_thickness = 0.003;  ///< m
    double young_modulus = 32.3e3;  ///< Pa
    double poisson_ratio = 0.35;
    std::vector<WallLayer> layers;     ///< of the wall, lumen first; then wall_thickness is their sum and
                                       ///< young_modulus the mean of the tube
    std::optional<NoduleSpec> nodule;  ///< with layers only
    double luminal_bulk_modulus = 0;   ///< Pa, of contents that fill the lumen and cannot leave; 0: none
    double linear_density = 0.25;      ///< kg/m
    double damping = 6.0;              ///< 1/s, mass-proportional
    int segments = 64;
    double sphere_spacing = 0.016;  ///< m
    int surface_vertices = 20000;   ///< requested, the generator rounds
    std::uint64_t seed = 1;
    std::string tissue = "bowel";
    double floor_friction = 0.3;
    BowelLayout layout = BowelLayout::colon;
    double weight = 1;            ///< fraction of its weight not carried by the tissue beneath
    double blade_width = 0.0006;  ///< m, of the band that a blade removes; its surface can be cut if its
                                  ///< tissue has `cutting`
};

}  // namespace fulcrum
