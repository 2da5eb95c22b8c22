// SPDX-License-Identifier: Apache-2.0
// The local contact model: data from the world with which the haptic tick computes force without reading
// world state (docs/THEORY.md, section 4). One per hand; fixed capacities, so that a copy does not allocate;
// written in place in a TripleBuffer slot by the world, read by the tick.
//
// Surface mode contains a patch of the bowel: its rings with their velocities, and the skinning rows of the
// vertices near the tool. At every tick the haptic thread extrapolates the rings by velocity times age, skins
// the vertices that it needs and finds the contact again. The dent is not part of the patch: the Winkler bed
// of the wall is the stiffness of the model, so the force is measured from the undented surface and the dent
// that this force causes is what is drawn. drawn.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "sim_core/bowel/skin.h"
#include "sim_core/geometry/mesh.h"
#include "sim_core/material/layered_wall.h"

namespace fulcrum {

inline constexpr int patch_ring_capacity = 12;
inline constexpr int patch_vertex_capacity = 512;
inline constexpr int patch_triangle_capacity = 1024;
inline constexpr int patch_neighbour_capacity = 3584;
inline constexpr int target_capacity = 64;

enum class LocalMode : std::uint8_t {
    none,     ///< no tissue nearby: only targets and wall
    surface,  ///< patch
    grasp,    ///< the jaws hold tissue; a patch may be present too, for its numbers, but exerts no force
};

/// Contact properties of a tissue.
struct TissueContact {
    std::int16_t tissue = -1;           ///< index into the scene's tissue table
    double stiffness_per_area = 1.6e7;  ///< N/m3, Winkler bed of wall and backing
    double least_stiffness = 100;       ///< N/m, lower bound of the local model's K
    double most_stiffness = 800;        ///< N/m, upper bound of K; Eq. 8 is checked for it
    double damping = 0.4;               ///< N s/m
    double friction = 0.1;              ///< of a tool that slides over it
    /// Layered wall that replaces the Winkler bed; null: none. Immutable, so the tick may read it.
    const LayeredWall* wall = nullptr;
    double puncture_force =
        std::numeric_limits<double>::infinity();  ///< N, for this attempt; used with `wall`
};

/// A patch of the deforming surface. Triangles and adjacency are in patch numbers; *_id are surface numbers,
/// ascending.
struct SurfacePatch {
    std::int32_t ring_count = 0, vertex_count = 0, triangle_count = 0;
    std::int32_t first_ring = 0;  ///< surface number of rings[0]
    std::array<RingMotion, patch_ring_capacity> rings;
    std::array<SkinRow, patch_vertex_capacity> rows;  ///< first_ring in patch numbers
    std::array<std::int32_t, patch_vertex_capacity> vertex_id;
    std::array<double, patch_vertex_capacity> vertex_area;         ///< m2, at rest
    std::array<std::int16_t, patch_vertex_capacity> tissue_patch;  ///< -1 none
    std::array<double, patch_vertex_capacity> nodule;  ///< m, height under the vertex; with a wall
    std::array<std::uint8_t, patch_vertex_capacity>
        border;  ///< 1: some triangles around it are not in the patch
    std::array<Triangle, patch_triangle_capacity> triangles;
    std::array<std::int32_t, patch_triangle_capacity> triangle_id;
    std::array<std::int32_t, 3 * patch_triangle_capacity> triangle_neighbours;
    std::array<std::int32_t, patch_vertex_capacity + 1> vertex_triangle_offsets;
    std::array<std::int32_t, 3 * patch_triangle_capacity> vertex_triangles;
    std::array<std::int32_t, patch_vertex_capacity + 1> vertex_neighbour_offsets;
    std::array<std::int32_t, patch_neighbour_capacity> vertex_neighbours;
    TissueContact contact;
    double curvature_radius = 0.016;  ///< m, of the tube here; sets the step length along the shaft
    std::int32_t seed_triangle =
        -1;  ///< patch number where the world's full search found the surface nearest to the tool
    double seed_shaft = 1.0;   ///< fraction of the shaft at the seed
    double seed_distance = 0;  ///< m, signed, shaft axis to surface
    bool overflow = false;     ///< a capacity was too small: the patch is smaller than asked
    double cover = 1;  ///< fraction of the contact's stiffness: less where tissue was cut away, 0: none

    /// Patch number of a surface triangle or vertex, -1 if it is not in the patch (binary search).
    std::int32_t find_triangle(std::int32_t id) const;
    std::int32_t find_vertex(std::int32_t id) const;
};

/// A held wall point, linearised about the world's solution. Force on tissue = lambda + K (x - x0) + B (v -
/// v0), x the hold point of the jaws.
struct GraspModel {
    Vector3 point = Vector3::Zero();        ///< x0, m: position of the held wall point at the model's tick
    Vector3 velocity = Vector3::Zero();     ///< v0, m/s
    Vector3 reaction = Vector3::Zero();     ///< lambda, N, jaw on tissue
    Vector3 hold_offset = Vector3::Zero();  ///< m, tool frame, the hold point relative to the tip
    Matrix3 stiffness = Matrix3::Zero();    ///< K, N/m, symmetric, of the tissue seen at the point
    double damping = 0;                     ///< B, N s/m
    double friction = 0.5;                  ///< of the jaw faces
    std::int32_t vertex = -1;               ///< surface vertex nearest the held point
    double area = 0;  ///< m2, jaw contact area (jaws.h): the same throughout a hold; 0: not known
    std::int16_t tissue = -1, tissue_patch = -1;
};

/// Jaws that press as boxes (fidelity level "jaws"), linearised about the world's solution: the force of the
/// jaws in addition to that of the shaft; or a shaft that pushes a ring. Force on tissue = force + K (x -
/// x0), x the place of the instrument that K acts at; none where it would be attractive.
struct JawPushModel {
    double back = 0;                      ///< m, from the tip back along the shaft to that place
    Vector3 place = Vector3::Zero();      ///< x0, m, at the model's tick
    Vector3 point = Vector3::Zero();      ///< m, centre of the pressed areas
    Vector3 force = Vector3::Zero();      ///< N, jaws on tissue
    Matrix3 stiffness = Matrix3::Zero();  ///< K, N/m, symmetric; no eigenvalue above the tissue's stiffness
    std::int16_t tissue = -1;             ///< index into the scene's tissue table, -1: no jaw presses
};

/// A sheet under the tip, or around a blade, linearised about the world's solution. Normal to the sheet:
/// push - K times displacement, never attractive. Tangential: drag + K' times displacement, at most grip +
/// friction times the push.
struct SheetContactModel {
    std::int16_t tissue = -1;            ///< index into the scene's tissue table, -1: no sheet nearby
    double back = 0;                     ///< m, from the tip back along a shaft or blade to where it is in it
    Vector3 place = Vector3::Zero();     ///< m, of that place of the tool at the model's tick
    Vector3 normal = Vector3::UnitZ();   ///< unit, of the sheet towards the tool
    Vector3 velocity = Vector3::Zero();  ///< m/s, of the sheet there
    bool pushes = false;                 ///< false: a blade is in it
    double push = 0;                     ///< N at that pose; negative: the tip is away by that value over K
    double stiffness = 0, damping = 0;   ///< N/m, N s/m
    Vector3 drag = Vector3::Zero();      ///< N, tool on sheet, along it, at that pose
    double drag_stiffness = 0;           ///< N/m
    double friction = 0, grip = 0;       ///< grip: N
    bool cutting = false;
};

/// Rigid sphere (A2).
struct TargetModel {
    Vector3 centre = Vector3::Zero();       ///< m
    double radius = 0;                      ///< m
    double stiffness = 600, damping = 0.5;  ///< N/m, N s/m
    std::int32_t id = -1;
    std::int16_t tissue = -1;
    bool solid = true;  ///< false: the tool passes through it
};

struct LocalModel {
    /// For a new step: nothing is near until the parts of the world say what is.
    void begin(std::uint32_t world_step, std::uint32_t last_tick) noexcept {
        step = world_step;
        tick = last_tick;
        mode = LocalMode::none;
        sheet = SheetContactModel();
        target_count = 0;
    }
    /// Read from bytes: the layered wall is the one that this world has; null: none.
    void point_to(const LayeredWall* wall) noexcept {
        if (patch.contact.wall != nullptr) patch.contact.wall = wall;
    }

    std::uint32_t step = 0;  ///< world step that produced it
    std::uint32_t tick = 0;  ///< tick of the poses that it is valid for; age = now - tick
    std::uint32_t topology_version =
        0;  ///< of the surface's triangles; a change invalidates remembered triangles
    LocalMode mode = LocalMode::none;
    bool energises =
        true;  ///< false: the instrument in this hand gives no energy, even if its pedal is pressed
    SurfacePatch patch;
    GraspModel grasp;
    JawPushModel jaws;
    SheetContactModel sheet;
    std::int32_t target_count = 0;
    std::array<TargetModel, target_capacity> targets;
    std::int32_t cavity_seed =
        -1;  ///< cavity triangle nearest the tip, -1: further away than the search radius
};

/// Both hands' models, as handed to the tick.
struct LocalModels {
    LocalModel hand[hand_count];
};

}  // namespace fulcrum
