// SPDX-License-Identifier: Apache-2.0
// The plane behind the rectum (task C4): what a scene may say of the presacral wall and of the septa of
// layered tissue between it and the rectum. SI units. Mechanical figures are ours and provisional.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim_core/numerics/types.h"
#include "sim_core/scene/fibre_spec.h"

namespace fulcrum {

/// The presacral fascia as a smooth wall, and the curve that the rectum follows in front of it: an arc in the
/// median plane about `centre`, angles from straight behind it, positive cranially.
struct PresacralSpec {
    Vector3 centre = Vector3(0, -0.07, 0.079);  ///< m, of the arc
    double curve_radius = 0.123;                ///< m, of the rectum's centre line about it
    double caudal_angle = -0.2617993877991494;  ///< rad, where the rectum begins, at the levator
    double promontory_angle = 0.72;  ///< rad, where the wall leaves the arc and falls away cranially
    double gap = 0.018;              ///< m, from the muscularis of the rectum to the fascia: the mesorectum
    double hold_stiffness = 25;      ///< N/m, of each of three ties that hold the rectum's cranial end
    double unevenness = 0.0004;      ///< m, by how much the wall may lie deeper than the fascia
    std::uint64_t seed = 1;
    std::string tissue = "fascia";
};

/// Septa between the fascia and the muscularis, the first the most cranial. Heights are m above the fascia.
struct SeptaSpec {
    int count = 4;
    double spacing = 0.020;        ///< m, from one to the next along the intended plane
    double first_angle = 0.60;     ///< rad, of the first one on the sacral curve
    double width = 0.056;          ///< m, along the intended plane from rim to rim: the marked line of each
    double node_spacing = 0.0028;  ///< m between vertices along that line
    int areolar_rows = 3, fat_rows = 3;  ///< of triangles, in the height of each zone
    double plane_height = 0.003;         ///< m, of the intended plane
    double areolar_height = 0.006;       ///< m, where the fat of the mesorectum begins
    double fat_height = 0.018;           ///< m, where the muscularis begins: PresacralSpec::gap
    double thickness = 0.0015;           ///< m
    std::string tissue = "areolar", fat_tissue = "fat";
    double structural_stiffness = 6;  ///< N/m each spring of the areolar zone, as shear and bend
    double shear_stiffness = 2.5;
    double bend_stiffness = 0.2;
    double fat_stiffness = 1.5;    ///< of the fat's springs over the areolar ones'
    double surface_density = 2.5;  ///< kg/m2
    double pre_strain = 0.04;
    double stiffness_damping = 0;     ///< s
    double mass_damping = 60;         ///< 1/s
    double weight = 0;                ///< share of its weight that what lies beneath does not carry
    double blade_width = 0.0006;      ///< m, of the ground that a blade takes
    std::optional<FibreSpec> fibres;  ///< of the areolar zone; absent: they part by a blade alone
};

}  // namespace fulcrum
