// SPDX-License-Identifier: Apache-2.0
// The plane behind the rectum (task C4): values of the presacral wall and of the septa of layered tissue
// between it and the rectum in a scene. SI units. Mechanical values are provisional.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim_core/numerics/types.h"
#include "sim_core/scene/fibre_spec.h"

namespace fulcrum {

/// The presacral fascia as a smooth wall, and the curve of the rectum in front of it: an arc in the median
/// plane about `centre`, angles from posterior, positive cranially.
struct PresacralSpec {
    Vector3 centre = Vector3(0, -0.07, 0.079);  ///< m, of the arc
    double curve_radius = 0.123;                ///< m, of the rectum's centre line about it
    double caudal_angle = -0.2617993877991494;  ///< rad, where the rectum begins, at the levator
    double promontory_angle = 0.72;             ///< rad, where the wall leaves the arc and slopes posteriorly
    double gap = 0.018;          ///< m, from the muscularis of the rectum to the fascia: the mesorectum
    double hold_stiffness = 25;  ///< N/m, of each of the three ties at the rectum's cranial end
    double unevenness = 0.0004;  ///< m, largest depth of the wall below the fascia
    std::uint64_t seed = 1;
    std::string tissue = "fascia";
};

/// Septa between the fascia and the muscularis, the first the most cranial. Heights are m above the fascia.
struct SeptaSpec {
    int count = 4;
    double spacing = 0.020;     ///< m, distance between septa along the intended plane
    double first_angle = 0.60;  ///< rad, of the first one on the sacral curve
    double width =
        0.056;  ///< m, along the intended plane from border to border: length of the marked line of each
    double node_spacing = 0.0028;        ///< m between vertices along that line
    int areolar_rows = 3, fat_rows = 3;  ///< rows of triangles over the height of each zone
    double plane_height = 0.003;         ///< m, of the intended plane
    double areolar_height = 0.006;       ///< m, where the fat of the mesorectum begins
    double fat_height = 0.018;           ///< m, where the muscularis begins: PresacralSpec::gap
    double thickness = 0.0015;           ///< m
    std::string tissue = "areolar", fat_tissue = "fat";
    double structural_stiffness = 6;  ///< N/m each spring of the areolar zone, as shear and bend
    double shear_stiffness = 2.5;
    double bend_stiffness = 0.2;
    double fat_stiffness = 1.5;    ///< stiffness of the fat's springs over that of the areolar ones
    double surface_density = 2.5;  ///< kg/m2
    double pre_strain = 0.04;
    double stiffness_damping = 0;     ///< s
    double mass_damping = 60;         ///< 1/s
    double weight = 0;                ///< fraction of its weight not carried by the tissue beneath
    double blade_width = 0.0006;      ///< m, of the band that a blade removes
    std::optional<FibreSpec> fibres;  ///< of the areolar zone; absent: only a blade divides the tissue
};

}  // namespace fulcrum
