// SPDX-License-Identifier: Apache-2.0
// What the world looks like after a step: read by the viewport, the task monitor and the synthetic operators,
// never by the tick. Vectors have their final size from the start, so copying a snapshot into a slot of the
// same scene allocates nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/bowel/skin.h"
#include "sim_core/geometry/mesh.h"
#include "sim_core/instrument/poses.h"
#include "sim_core/numerics/types.h"
#include "sim_core/rigid/target_sphere.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/world/part/bands_view.h"
#include "sim_core/world/part/camera_targets_view.h"
#include "sim_core/world/part/field_view.h"
#include "sim_core/world/part/objects_view.h"
#include "sim_core/world/part/structures_view.h"

namespace fulcrum {

/// What jaws can hold.
enum class HeldBody : std::uint8_t { none, bowel, membrane, sheet, band, object };

/// What a pair of jaws holds. The world writes it, from the part that holds (Part::grasp); after the hold it
/// shows the last one, without reaction.
struct GraspState {
    bool held = false;
    double arc_length = 0;               ///< m along the bowel; -1 where it is a membrane that is held
    Vector3 offset = Vector3::Zero();    ///< wall point in the ring frame, m
    Vector3 point = Vector3::Zero();     ///< wall point, patient frame, m
    Vector3 reaction = Vector3::Zero();  ///< N, jaw on tissue
    std::int32_t patch = -1;             ///< of the bowel's wall, or which band or object; -1 of a membrane
    HeldBody body = HeldBody::none;
    std::int8_t tissue = -1;  ///< index in Scene::tissues of what is or was last held; -1: nothing yet
    bool slipped =
        false;  ///< the last hold ended because its reaction left the friction cone, not by opening the jaws
};

/// A vector of fixed size of which the first `used` entries have a meaning: assignment copies only those, so
/// that room for what an attempt may still cut costs nothing in each step.
template <typename T>
class UsedVector : public std::vector<T> {
  public:
    UsedVector() = default;
    UsedVector(const UsedVector&) = default;
    UsedVector(UsedVector&&) noexcept = default;
    UsedVector& operator=(UsedVector&&) noexcept = default;
    ~UsedVector() = default;
    UsedVector& operator=(const UsedVector& other) {
        if (this == &other) return *this;
        if (this->size() != other.size()) this->resize(other.size());
        used = other.used;
        std::copy_n(other.begin(), std::min(used, other.size()), this->begin());
        return *this;
    }
    /// A replay's key frame keeps it whole.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(static_cast<std::vector<T>&>(*this), used);
    }
    std::size_t used = 0;
};

/// A membrane to be drawn: open sheet, seen from both sides.
struct MembraneView {
    std::vector<Vector3> positions;   ///< m, patient frame
    std::vector<Triangle> triangles;  ///< change with `topology` only
    std::uint32_t topology = 0;

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(positions, triangles, topology);
    }
};

/// A sheet that is divided along a marked line.
struct SheetView {
    std::vector<Vector3>
        line;  ///< m, where the marked line's points are now, patient frame; empty without a sheet
    std::vector<double> line_positions;      ///< m at rest from the line's start, rising; one for each point
    std::vector<double> line_traction;       ///< N/m across the line at each point; 0 where it is divided
    std::vector<std::uint8_t> line_divided;  ///< 1 where the sheet is divided across the line at this point
    std::vector<Vector3> flap;  ///< m, the free edge that can be taken hold of, in the line's direction
    /// To be drawn: an open sheet, seen from both sides. Fixed capacity, *_count valid; rest and triangles
    /// change with `topology` only.
    UsedVector<Vector3> positions;  ///< m, patient frame
    UsedVector<Vector3> rest;  ///< m, in the sheet as it was made: x along the marked line from its start, y
                               ///< from it towards the flap, z = 0
    UsedVector<Triangle> triangles;  ///< visible ones
    UsedVector<std::int32_t>
        roots;  ///< of each: the triangle as it was made that it is a part of, StructuresView::sheet_char
    std::int32_t vertex_count = 0, triangle_count = 0;
    std::uint32_t topology = 0;
    double thickness = 0;  ///< m
    // Septa: the marked lines laid end to end, the first the most cranial; septum = floor(x / septum_length).
    double septum_length = 0;       ///< m; 0: one sheet
    double fat_from = 0;            ///< m, y at rest where the fat of the mesorectum begins
    std::vector<Vector3> envelope;  ///< m, where that border is now, septum * envelope_columns + column, the
                                    ///< patient's right first; where the tissue is gone its last place
    std::int32_t envelope_columns = 0;
    double visible_area = 0, removed_area = 0;  ///< m2 at rest

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(line, line_positions, line_traction, line_divided, flap, positions, rest, triangles, roots,
              vertex_count, triangle_count, topology, thickness, septum_length, fat_from, envelope,
              envelope_columns, visible_area, removed_area);
    }
};

/// The bowel's surface where it has been cut: what is drawn in place of some of the skin's triangles. Fixed
/// capacity, *_count valid; all but `fallen` changes with `topology` only. Vertices 0 .. first_vertex - 1 are
/// the skin's own.
struct BowelCutView {
    std::int32_t first_vertex = 0;
    std::int32_t vertex_count = 0, triangle_count = 0;
    UsedVector<std::int32_t>
        vertex_roots;                 ///< of vertex first_vertex + i: the skin's triangle that it lies in
    UsedVector<Vector3> barycentric;  ///< and where in it, of its corners
    UsedVector<Triangle> triangles;   ///< visible, counterclockwise from outside
    UsedVector<std::int32_t> triangle_roots;  ///< of each: the skin's triangle that it is a part of
    UsedVector<std::uint8_t> triangle_loose;  ///< of each: 0 hangs on, else 1 + place in `fallen`
    std::vector<std::uint8_t> hidden;  ///< by the skin's triangle, 1: it is not drawn itself; empty without
    std::array<Vector3, 8> fallen{};   ///< m, way that each piece that came free has made
    std::uint32_t topology = 0;
    double thickness = 0;                       ///< m, of the wall
    double visible_area = 0, removed_area = 0;  ///< m2 at rest

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(first_vertex, vertex_count, triangle_count, vertex_roots, barycentric, triangles,
              triangle_roots, triangle_loose, hidden, fallen, topology, thickness, visible_area,
              removed_area);
    }
};

struct WorldSnapshot {
    std::uint32_t step = 0;
    std::uint32_t tick = 0;     ///< last input tick the step consumed
    std::uint32_t outcome = 0;  ///< StepRecord::outcome
    ToolPose tools[hand_count];
    /// m, from the tips above to where the instruments are drawn: at the surface of what they touch.
    Vector3 lift[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    CameraPose camera;
    GraspState grasps[hand_count];
    std::vector<TargetSphere> targets;
    /// Bowel: centre-line nodes (n+1), their arc lengths at rest (n+1), ring frames. Empty without a bowel.
    std::vector<Vector3> nodes;
    std::vector<double> node_arc_lengths;
    std::vector<RingFrame> rings;
    std::vector<double> ring_arc_lengths;
    std::vector<DentVertex> dents;  ///< fixed capacity, dent_count valid
    std::int32_t dent_count = 0;
    std::vector<Vector3> tether_anchors;  ///< mesentery root points; empty without tethers
    std::vector<double> tether_arc_lengths;
    std::vector<MembraneView> membranes;  ///< Scene::membranes; empty without
    SheetView sheet;                      ///< Scene::sheet; empty without
    BowelCutView bowel_cut;               ///< empty where the bowel's tissue is not cut
    std::vector<Event> events;  ///< what this step did to tissue, for the monitor to pass on; fixed capacity,
                                ///< event_count valid
    std::int32_t event_count = 0;
    std::vector<FieldView> field;      ///< one with Scene::bands or Scene::structures; empty without
    BandsView bands;                   ///< Scene::bands; empty without
    StructuresView structures;         ///< Scene::structures; empty without
    ObjectsView objects;               ///< Scene::objects; empty without
    CameraTargetsView camera_targets;  ///< Scene::camera_targets; empty without
    std::vector<float> patch_damage;   ///< N s per tissue patch
    double solve_residual = 0;        ///< of the bowel's last solve: share of the largest force that was left
    double residual_penetration = 0;  ///< m, deepest sphere in the cavity after the step
    double floor_load = 0;            ///< N, sum of contact forces on the cavity

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(step, tick, outcome, tools, camera, grasps, targets, nodes, node_arc_lengths, rings,
              ring_arc_lengths, dents, dent_count, tether_anchors, tether_arc_lengths, membranes, sheet,
              bowel_cut, events, event_count, field, bands, structures, objects, camera_targets, patch_damage,
              solve_residual, residual_penetration, floor_load);
    }
};

}  // namespace fulcrum
