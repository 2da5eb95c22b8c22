// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/sheet/sheet_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/world/part/sheet_material.h"

namespace fulcrum {

using sheet_rows::at;

using namespace blade_law;

namespace {

constexpr int surface_steps = 1000;      // room for so many steps of a blade
constexpr double station_gap = 0.005;    // m between points of the marked line
constexpr double tension_reach = 0.006;  // m about a blade whose springs give the traction
constexpr int settling_steps = 80;
constexpr double off_rim =
    1e-6;  // m: places are reported as being this far from the rim of a septum at least

SheetLayout layout_of(const Scene& scene) {
    return scene.septa ? lay_out_septa(*scene.septa, rectum_parameters(scene).curve)
                       : lay_out_sheet(*scene.sheet);
}

MembraneMaterial material_of(const SheetSpec& spec, const SheetLayout& layout) {
    MembraneMaterial material = sheet_material(spec, layout.mesh);
    material.zones = layout.zones;
    return material;
}

}  // namespace

SheetBody::SheetBody(const Scene& scene, double dt)
    : spec_(scene.septa ? common_spec(*scene.septa) : *scene.sheet),
      septa_(scene.septa),
      tissue_(scene.tissues[at(scene.tissue_index(spec_.tissue))]),
      fat_(scene.tissues[at(scene.tissue_index(septa_ ? septa_->fat_tissue : spec_.tissue))]),
      tissue_index_(static_cast<std::int16_t>(scene.tissue_index(spec_.tissue))),
      fat_index_(static_cast<std::int16_t>(scene.tissue_index(septa_ ? septa_->fat_tissue : spec_.tissue))),
      gravity_(scene.gravity),
      layout_(layout_of(scene)),
      surface_(layout_.mesh, layout_.held, CutMesh::capacity_for(layout_.mesh, surface_steps)),
      membrane_(layout_.mesh, material_of(spec_, layout_), layout_.attachments,
                surface_.capacity().fragments),
      scratch_(membrane_.make_scratch()) {
    if (!(dt <= 1000 * membrane_.safe_time_step())) {
        throw InputError(
            scene.id, septa_ ? "/septa" : "/sheet",
            QT_TRANSLATE_NOOP("errors", "the sheet is too stiff for its mass at this step"),
            QT_TRANSLATE_NOOP("errors",
                              "lower its stiffness, raise surface_density or take fewer ticks_per_step"));
    }
    line_start_ = spec_.centre - 0.5 * spec_.line_length * spec_.along +
                  (spec_.line_at - 0.5) * spec_.width * spec_.across;
    state_.membrane = membrane_.make_state();
    state_.positions.assign(at(surface_.capacity().vertices), Vector3::Zero());
    state_.bindings.resize(at(surface_.capacity().vertices));
    state_.loose.assign(at(surface_.capacity().fragments), 0);
    visible_.reserve(at(surface_.capacity().triangles));
    touched_.assign(at(surface_.root_count()), 0);
    cut_.roots.reserve(at(surface_.root_count()));
    cut_.pieces.reserve(at(surface_.capacity().fragments));
    cut_.contacts.reserve(6 * at(surface_.capacity().fragments));
    inputs_.links.reserve((Jaws::most_points + 1) * hand_count);
    inputs_.gravity = spec_.weight * gravity_;
    inputs_.isolated_gravity = gravity_;
    for (std::int32_t v = 0; v < surface_.vertex_count(); ++v) bind(v);
    list_visible();
    update_positions();
    mark_line(septa_ ? rectum_parameters(scene).curve : SacralCurve());
    state_.divided.assign(state_.line.size(), 0);
    state_.traction.assign(state_.line.size(), 0.0);
    settle(dt);
    for (std::size_t i = 0; i < state_.line.size(); ++i) measure_station();
}

void SheetBody::mark_line(const SacralCurve& curve) {
    if (!septa_) {
        const int stations =
            spec_.line_length > 0 ? static_cast<int>(std::ceil(spec_.line_length / station_gap)) + 1 : 0;
        for (int i = 0; i < stations; ++i) {
            line_positions_.push_back(spec_.line_length * i / (stations - 1));
            state_.line.push_back(closest(line_start_ + line_positions_.back() * spec_.along));
        }
        return;
    }
    // In the middle of equal parts of each septum's line: none lies on two of them.
    stations_ = std::max(2, static_cast<std::int32_t>(std::ceil(septa_->width / station_gap)));
    const double turn = septa_->width / (curve.fascia_radius() - septa_->plane_height);
    for (std::int32_t k = 0; k < layout_.pieces; ++k) {
        for (std::int32_t i = 0; i < stations_; ++i) {
            const double share = (i + 0.5) / stations_;
            line_positions_.push_back((k + share) * septa_->width);
            state_.line.push_back(
                closest(curve.point(layout_.arc_lengths[at(k)], (share - 0.5) * turn, septa_->plane_height)));
        }
    }
}

void SheetBody::settle(double dt) noexcept {
    // From the shape in which every spring is stretched alike to rest: the speed is taken out at each peak.
    double kinetic = 0;
    for (int i = 0; i < settling_steps; ++i) {
        membrane_.step(state_.membrane, inputs_, dt, scratch_);
        const double now = membrane_.energy(state_.membrane).kinetic;
        if (now < kinetic) {
            for (Vector3& v : state_.membrane.velocities) v.setZero();
            kinetic = 0;
        } else {
            kinetic = now;
        }
    }
    for (Vector3& v : state_.membrane.velocities) v.setZero();
    update_positions();
}

Vector3 SheetBody::place(const SheetPlace& where) const noexcept {
    if (where.fragment < 0 || state_.membrane.pieces[at(where.fragment)].root < 0) return Vector3::Zero();
    return CutMembrane::point(state_.membrane, where.fragment, where.barycentric);
}

Vector3 SheetBody::rest(const SheetPlace& where) const noexcept {
    if (where.fragment < 0) return Vector3::Zero();
    const Triangle& corners = layout_.mesh.triangles[at(surface_.fragment(where.fragment).root)];
    Vector3 sum = Vector3::Zero();
    const std::vector<Vector3>& from = septa_ ? layout_.rest : layout_.mesh.vertices;
    for (std::size_t c = 0; c < 3; ++c) sum += where.barycentric[static_cast<int>(c)] * from[at(corners[c])];
    if (septa_) return sum;
    sum -= line_start_;
    return Vector3(sum.dot(spec_.along), sum.dot(spec_.across), 0);
}

void SheetBody::bind(std::int32_t vertex) noexcept {
    SheetPlace& binding = state_.bindings[at(vertex)];
    binding = SheetPlace();
    const CutVertex& row = surface_.vertex(vertex);
    if (row.triangle < 0) return;
    const std::int32_t root = surface_.triangle(row.triangle).root;
    if (!barycentric_in(surface_.model(), row, root, binding.barycentric)) return;
    binding.fragment = surface_.fragment_of_triangle(row.triangle);
    binding.triangle = row.triangle;
}

void SheetBody::list_visible() noexcept {
    visible_.clear();
    for (std::int32_t t = 0; t < surface_.triangle_count(); ++t) {
        if (surface_.visible(t)) visible_.push_back({t, surface_.triangle(t).vertices});
    }
}

void SheetBody::update_positions() noexcept {
    for (std::int32_t v = 0; v < surface_.vertex_count(); ++v) {
        const SheetPlace& binding = state_.bindings[at(v)];
        if (binding.fragment >= 0)
            state_.positions[at(v)] =
                CutMembrane::point(state_.membrane, binding.fragment, binding.barycentric);
    }
}

double SheetBody::traction_at(const Vector3& point, const Vector3& way,
                              const Vector3& normal) const noexcept {
    const Vector3 across = normal.cross(way);
    if (!(across.squaredNorm() > 1e-24)) return 0;
    const Vector3 unit = across.normalized();
    return unit.dot(membrane_.tension(state_.membrane, point, tension_reach) * unit);
}

void SheetBody::measure_station() noexcept {
    if (state_.line.empty()) return;
    const auto count = static_cast<std::int32_t>(state_.line.size());
    const std::int32_t i = state_.next_station;
    state_.next_station = (i + 1) % count;
    const SheetPlace& here = state_.line[at(i)];
    double& traction = state_.traction[at(i)];
    traction = 0;
    if (state_.divided[at(i)] != 0 || here.fragment < 0) return;
    const std::int32_t first = septa_ ? i / stations_ * stations_ : 0,
                       last = septa_ ? first + stations_ - 1 : count - 1;
    const SheetPlace &before = state_.line[at(std::max(first, i - 1))],
                     &after = state_.line[at(std::min(last, i + 1))];
    if (before.fragment < 0 || after.fragment < 0) return;
    const auto& nodes = state_.membrane.pieces[at(here.fragment)].nodes;
    const auto& x = state_.membrane.positions;
    const Vector3 normal = (x[at(nodes[1])] - x[at(nodes[0])]).cross(x[at(nodes[2])] - x[at(nodes[0])]);
    traction = traction_at(place(here), place(after) - place(before), normal);
}

void SheetBody::add_event(std::uint32_t tick, EventKind kind, int hand, double value, double detail,
                          bool fat) noexcept {
    events_.add(tick, kind, hand, fat ? fat_index_ : tissue_index_, value, detail);
}

void SheetBody::add_place_event(std::uint32_t tick, EventKind kind, int hand, const Vector3& where) noexcept {
    add_event(tick, kind, hand, where.x(), -1e6 * where.y(),
              in_fat(where));  // the flap's side is the line's y
}

SheetPlace SheetBody::place_in(std::int32_t triangle, const Vector3& weights) const noexcept {
    SheetPlace found;
    const CutTriangle& row = surface_.triangle(triangle);
    Vector3 corner;
    for (std::size_t c = 0; c < 3; ++c) {
        if (!barycentric_in(surface_.model(), surface_.vertex(row.vertices[c]), row.root, corner))
            return SheetPlace();
        found.barycentric += weights[static_cast<int>(c)] * corner;
    }
    found.fragment = row.fragment;
    found.triangle = triangle;
    return found;
}

SheetPlace SheetBody::closest(const Vector3& point) const noexcept {
    double least = std::numeric_limits<double>::infinity();
    const auto on = [&](const Triangle& v) {
        return closest_point_on_triangle(point, state_.positions[at(v[0])], state_.positions[at(v[1])],
                                         state_.positions[at(v[2])]);
    };
    // A bound beyond what rounding can do to the distance, so that the first of the closest is found all the
    // same.
    for (const std::size_t k : recent_) {
        if (k < visible_.size())
            least = std::min(least,
                             (1 + 1e-9) * (on(visible_[k].vertices).position - point).squaredNorm() + 1e-30);
    }
    std::size_t closest = visible_.size();
    Vector3 weights = Vector3::Zero();
    for (std::size_t k = 0; k < visible_.size(); ++k) {
        const Triangle& v = visible_[k].vertices;
        if (box_distance(point, state_.positions[at(v[0])], state_.positions[at(v[1])],
                         state_.positions[at(v[2])]) >= least)
            continue;
        const TrianglePoint found = on(v);
        const double distance = (found.position - point).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        closest = k;
        weights = found.barycentric;
    }
    if (closest == visible_.size()) return SheetPlace();
    if (recent_[0] != closest) recent_ = {closest, recent_[0]};
    return place_in(visible_[closest].number, weights);
}

SheetPlace SheetBody::find_in_root(std::int32_t root, const Vector3& barycentric,
                                   double slack) const noexcept {
    SheetPlace found;
    double best = -std::numeric_limits<double>::infinity();
    for (std::int32_t t = surface_.root(root).first_visible; t >= 0; t = surface_.triangle(t).next_in_root) {
        const CutTriangle& row = surface_.triangle(t);
        Vector3 corner[3];
        bool good = true;
        for (std::size_t c = 0; c < 3; ++c)
            good =
                good && barycentric_in(surface_.model(), surface_.vertex(row.vertices[c]), root, corner[c]);
        if (!good || !(row.share > 0)) continue;
        double least = 1;
        for (int c = 0; c < 3; ++c)
            least =
                std::min(least, share_of(barycentric, corner[(c + 1) % 3], corner[(c + 2) % 3]) / row.share);
        if (least <= best) continue;
        best = least;
        found.fragment = row.fragment;
        found.triangle = t;
    }
    found.barycentric = barycentric;
    return best >= -slack ? found : SheetPlace();
}

bool SheetBody::crosses(const Vector3& from, const Vector3& to) const noexcept {
    return visit_crossings(from, to, [](std::int32_t, double) { return true; });
}

bool SheetBody::crosses(const Vector3& from, const Vector3& to, std::int32_t septum) const noexcept {
    return visit_crossings(from, to, [&](std::int32_t t, double) {
        return septum_of_root(surface_.triangle(t).root) == septum;
    });
}

double SheetBody::friction(const SheetAction& action) const noexcept {
    const bool bites =
        action.instrument->cuts() && (action.tool.buttons & button_primary) != 0 && tissue_.cutting;
    return bites ? tissue_.friction : std::min(slide_friction, tissue_.friction);
}

void SheetBody::leave(int number, std::uint32_t tick) noexcept {
    SheetHand& hand = state_.hands[static_cast<std::size_t>(number)];
    add_place_event(tick, EventKind::cut_end, number, hand.way);
    hand.touch = BladeTouch::clearing;
    hand.linked = hand.adrift = false;
    hand.cover = 0;
    hand.reaction.setZero();
}

const CuttingSpec* SheetBody::cutting_at(const SheetPlace& where) const noexcept {
    const TissueSpec& tissue = in_fat(rest(where)) ? fat_ : tissue_;
    return tissue.cutting ? &*tissue.cutting : nullptr;
}

// Lines lie end to end: what runs over the rim of one septum is not on the next.
Vector3 SheetBody::on_septum(const SheetPlace& where, Vector3 rest) const noexcept {
    if (!septa_ || where.fragment < 0) return rest;
    const double first = septum_of(where) * septa_->width;
    rest.x() = std::clamp(rest.x(), first + off_rim, first + septa_->width - off_rim);
    return rest;
}

void SheetBody::begin(std::uint32_t tick) noexcept {
    events_.clear();
    faults_ = 0;
    tick_ = tick;
}

void SheetBody::step_membrane(double dt) noexcept {
    const MembraneReport report = membrane_.step(state_.membrane, inputs_, dt, scratch_);
    if (report.fault == MembraneFault::refused || report.fault == MembraneFault::frozen) faults_ = 2;
}

Vector3 SheetBody::trial_edge_force(int axis, double displacement, double dt) {
    CutMembraneState trial = state_.membrane;
    CutMembraneInputs inputs = inputs_;
    for (DrivenVertex& driven : inputs.driven) {
        if (axis >= 0) driven.target[axis] += displacement;
    }
    membrane_.step(trial, inputs, dt, scratch_);
    Vector3 sum = Vector3::Zero();
    for (const DrivenVertex& driven : inputs.driven) sum += driven.reaction;
    return sum;
}

void SheetBody::follow_restore() noexcept {
    list_visible();
    events_.clear();
}

}  // namespace fulcrum
