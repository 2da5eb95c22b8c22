// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/sheet/sheet_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/world/part/sheet_material.h"

namespace fulcrum {
namespace {

constexpr int surface_steps = 1000;      // room for so many steps of a blade
constexpr double station_gap = 0.005;    // m between points of the marked line
constexpr double tension_reach = 0.006;  // m about a blade whose springs give the traction
constexpr int settling_steps = 80;
constexpr std::uint16_t loose_steps = 200;  // what has come free falls for so long, then it is removed

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

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

SheetPart::SheetPart(const Scene& scene, double dt)
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
    near_.reserve(at(surface_.capacity().triangles));
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

void SheetPart::mark_line(const SacralCurve& curve) {
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

void SheetPart::settle(double dt) noexcept {
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

Vector3 SheetPart::place(const SheetPlace& where) const noexcept {
    if (where.fragment < 0 || state_.membrane.pieces[at(where.fragment)].root < 0) return Vector3::Zero();
    return CutMembrane::point(state_.membrane, where.fragment, where.barycentric);
}

Vector3 SheetPart::rest(const SheetPlace& where) const noexcept {
    if (where.fragment < 0) return Vector3::Zero();
    const Triangle& corners = layout_.mesh.triangles[at(surface_.fragment(where.fragment).root)];
    Vector3 sum = Vector3::Zero();
    const std::vector<Vector3>& from = septa_ ? layout_.rest : layout_.mesh.vertices;
    for (std::size_t c = 0; c < 3; ++c) sum += where.barycentric[static_cast<int>(c)] * from[at(corners[c])];
    if (septa_) return sum;
    sum -= line_start_;
    return Vector3(sum.dot(spec_.along), sum.dot(spec_.across), 0);
}

void SheetPart::bind(std::int32_t vertex) noexcept {
    SheetPlace& binding = state_.bindings[at(vertex)];
    binding = SheetPlace();
    const CutVertex& row = surface_.vertex(vertex);
    if (row.triangle < 0) return;
    const std::int32_t root = surface_.triangle(row.triangle).root;
    if (!barycentric_in(surface_.model(), row, root, binding.barycentric)) return;
    binding.fragment = surface_.fragment_of_triangle(row.triangle);
    binding.triangle = row.triangle;
}

void SheetPart::list_visible() noexcept {
    visible_.clear();
    for (std::int32_t t = 0; t < surface_.triangle_count(); ++t) {
        if (surface_.visible(t)) visible_.push_back({t, surface_.triangle(t).vertices});
    }
}

void SheetPart::update_positions() noexcept {
    for (std::int32_t v = 0; v < surface_.vertex_count(); ++v) {
        const SheetPlace& binding = state_.bindings[at(v)];
        if (binding.fragment >= 0)
            state_.positions[at(v)] =
                CutMembrane::point(state_.membrane, binding.fragment, binding.barycentric);
    }
}

void SheetPart::apply(const StepInput& input) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        SheetAction& action = actions_[hand];
        action.instrument = input.held[hand].instrument;
        action.tool = input.held[hand].tool;
        action.energised = input.held[hand].energised;
        action.busy = input.busy(hand, this);
        action.takes = input.taker[hand] == this;
    }
    apply(actions_, input.tick(), input.dt);
}

std::uint32_t SheetPart::solve(const StepInput& input) noexcept {
    return solve(actions_, input.tick(), input.dt);
}

void SheetPart::apply(const SheetAction* actions, std::uint32_t tick, double dt) noexcept {
    events_.clear();
    faults_ = 0;
    tick_ = tick;
    for (int hand = 0; hand < hand_count; ++hand) {
        if (actions[hand].instrument == nullptr) continue;
        update_jaws(hand, actions[hand], dt);
        approach(hand, actions[hand], tick, dt);
    }
    add_links(actions);
}

std::uint32_t SheetPart::solve(const SheetAction* actions, std::uint32_t tick, double dt) noexcept {
    const MembraneReport report = membrane_.step(state_.membrane, inputs_, dt, scratch_);
    if (report.fault == MembraneFault::refused || report.fault == MembraneFault::frozen) faults_ = 2;
    read_links();
    update_positions();
    for (int hand = 0; hand < hand_count; ++hand) {
        if (actions[hand].instrument == nullptr) continue;
        follow(hand, actions[hand], tick);
        state_.hands[static_cast<std::size_t>(hand)].tip = actions[hand].tool.tip;
    }
    drop_loose(tick);
    measure_station();
    part_fibres(tick, dt);
    return faults_;
}

Vector3 SheetPart::trial_edge_force(int axis, double displacement, double dt) {
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

void SheetPart::stop() noexcept {
    for (Vector3& v : state_.membrane.velocities) v.setZero();
}

void SheetPart::drop_loose(std::uint32_t tick) noexcept {
    if (state_.any_loose == 0) return;
    std::int32_t due = -1;
    for (std::int32_t f = 0; f < surface_.fragment_count(); ++f) {
        std::uint16_t& age = state_.loose[at(f)];
        if (age == 0 || surface_.fragment(f).triangles == 0) continue;
        if (age <= loose_steps) ++age;
        if (age > loose_steps && due < 0) due = f;
    }
    if (due < 0) return;
    surface_.find_pieces();
    for (std::int32_t t = surface_.root(surface_.fragment(due).root).first_visible; t >= 0;
         t = surface_.triangle(t).next_in_root) {
        if (surface_.fragment_of_triangle(t) != due) continue;
        const std::int32_t piece = surface_.piece_of_triangle(t);
        if (jaws_hold(piece)) {  // it hangs in the jaws: asked again when it has fallen for as long
            for (const VisibleTriangle& v : visible_) {
                if (surface_.piece_of_triangle(v.number) == piece)
                    state_.loose[at(surface_.fragment_of_triangle(v.number))] = 1;
            }
            return;
        }
        if (surface_.remove_piece(piece, state_.positions.data()).outcome == CutOutcome::cut) {
            take_over();
            note_loose(tick);
        }
        return;
    }
}

bool SheetPart::jaws_hold(std::int32_t piece) const noexcept {
    for (const HandState& hand : state_.hands) {
        for (int g = 0; hand.jaws.held() && g < hand.jaws.count(); ++g) {
            const std::int32_t triangle = hand.held_at[static_cast<std::size_t>(g)].triangle;
            if (triangle >= 0 && surface_.piece_of_triangle(triangle) == piece) return true;
        }
    }
    return false;
}

double SheetPart::traction_at(const Vector3& point, const Vector3& way,
                              const Vector3& normal) const noexcept {
    const Vector3 across = normal.cross(way);
    if (!(across.squaredNorm() > 1e-24)) return 0;
    const Vector3 unit = across.normalized();
    return unit.dot(membrane_.tension(state_.membrane, point, tension_reach) * unit);
}

void SheetPart::measure_station() noexcept {
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

void SheetPart::add_event(std::uint32_t tick, EventKind kind, int hand, double value, double detail,
                          bool fat) noexcept {
    events_.add(tick, kind, hand, fat ? fat_index_ : tissue_index_, value, detail);
}

void SheetPart::add_place_event(std::uint32_t tick, EventKind kind, int hand, const Vector3& where) noexcept {
    add_event(tick, kind, hand, where.x(), -1e6 * where.y(),
              in_fat(where));  // the flap's side is the line's y
}

void SheetPart::restore(const State& state, const CutState& surface) {
    state_ = state;
    surface_.restore(surface);
    follow_restore();
}

void SheetPart::size_snapshot(WorldSnapshot& snapshot) const {
    SheetView& view = snapshot.sheet;
    view.line.resize(state_.line.size(), Vector3::Zero());
    view.line_positions = line_positions_;
    view.line_traction = state_.traction;
    view.line_divided = state_.divided;
    view.flap.resize(at(layout_.columns), Vector3::Zero());
    view.positions.resize(at(surface_.capacity().vertices), Vector3::Zero());
    view.rest.resize(at(surface_.capacity().vertices), Vector3::Zero());
    view.triangles.resize(at(surface_.capacity().triangles), Triangle{0, 0, 0});
    view.roots.resize(view.triangles.size(), 0);
    view.thickness = spec_.thickness;
    if (septa_) {
        view.septum_length = septa_->width;
        view.fat_from = septa_->areolar_height - septa_->plane_height;
        view.envelope_columns = layout_.columns;
        view.envelope.resize(at(layout_.pieces * layout_.columns), Vector3::Zero());
    }
    view.topology = 0xFFFFFFFFU;  // filled with the first picture
    events_.size(snapshot);
}

void SheetPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    SheetView& view = snapshot.sheet;
    for (std::size_t i = 0; i < state_.line.size(); ++i) {
        if (state_.line[i].fragment >= 0) view.line[i] = place(state_.line[i]);
    }
    std::copy(state_.traction.begin(), state_.traction.end(), view.line_traction.begin());
    std::copy(state_.divided.begin(), state_.divided.end(), view.line_divided.begin());
    for (std::int32_t c = 0; c < layout_.columns; ++c)
        view.flap[at(c)] = state_.positions[at((layout_.rows - 1) * layout_.columns + c)];
    for (std::size_t i = 0; i < view.envelope.size(); ++i) {
        const auto piece = static_cast<std::int32_t>(i) / layout_.columns,
                   column = static_cast<std::int32_t>(i) % layout_.columns;
        view.envelope[i] =
            state_.positions[at((piece * layout_.rows + layout_.envelope_row) * layout_.columns + column)];
    }
    view.vertex_count = surface_.vertex_count();
    view.positions.used = view.rest.used = at(view.vertex_count);
    std::copy_n(state_.positions.begin(), at(view.vertex_count), view.positions.begin());
    if (view.topology != state_.membrane.topology) {
        view.topology = state_.membrane.topology;
        for (std::int32_t v = 0; v < view.vertex_count; ++v) {
            if (septa_) {
                if (state_.bindings[at(v)].fragment >= 0) view.rest[at(v)] = rest(state_.bindings[at(v)]);
                continue;
            }
            const Vector3 from_start = surface_.vertex(v).rest - line_start_;
            view.rest[at(v)] = Vector3(from_start.dot(spec_.along), from_start.dot(spec_.across), 0);
        }
        view.triangle_count = static_cast<std::int32_t>(visible_.size());
        view.triangles.used = view.roots.used = visible_.size();
        for (std::size_t k = 0; k < visible_.size(); ++k) {
            view.triangles[k] = visible_[k].vertices;
            view.roots[k] = surface_.triangle(visible_[k].number).root;
        }
        view.visible_area = surface_.area_visible();
        view.removed_area = surface_.area_removed();
    }
    events_.append_to(snapshot);
}

GraspState SheetPart::grasp(int number) const noexcept {
    const HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    GraspState grasp;
    if (septa_) grasp.arc_length = -1;
    grasp.body = HeldBody::sheet;
    grasp.offset = rest(hand.held_at[0]);
    grasp.tissue = static_cast<std::int8_t>(in_fat(grasp.offset) ? fat_index_ : tissue_index_);
    grasp.point = place(hand.held_at[0]);
    grasp.reaction = hand.pull;
    return grasp;
}

SheetUnder SheetPart::under(int number) const noexcept {
    const HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    SheetUnder found;
    if ((hand.touch != BladeTouch::touching && hand.touch != BladeTouch::cutting) || hand.place.fragment < 0)
        return found;
    found.root = surface_.fragment(hand.place.fragment).root;
    found.fat = in_fat(rest(hand.place));
    return found;
}

bool SheetPart::root_in_fat(std::int32_t root) const {
    return in_fat(rest({root, Vector3::Constant(1.0 / 3), root}));
}

void SheetPart::follow_restore() {
    list_visible();
    events_.clear();
}

void SheetPart::list_state(StateList& list) {
    list.hashed(state_.membrane, [this](StateHash& hash) {
        const CutMembraneState& m = state_.membrane;
        for (std::size_t n = 0; n < at(m.node_end); ++n) {
            hash.add(m.positions[n]);
            hash.add(m.velocities[n]);
            hash.add(m.masses[n]);
        }
        hash.add(static_cast<std::int64_t>(m.topology));
    });
    list.hashed_through([this] { return surface_.state(); },
                        [this](const CutState& surface) { surface_.restore(surface); },
                        [this](StateHash& hash) { hash.add(surface_.digest()); },
                        [this] { return surface_.bytes(); }, surface_);
    list.hashed(state_.hands, [this](StateHash& hash) {
        for (const HandState& hand : state_.hands) {
            hash.add(static_cast<std::int64_t>(hand.touch));
            hash.add(static_cast<std::int64_t>(hand.place.fragment));
            hash.add(hand.place.barycentric);
            hash.add(hand.side);
            hash.add(hand.cover);
            hash.add(hand.target);
            hash.add(hand.reaction);
            hash.add(hand.adrift ? hand.drifted : Vector3(Vector3::Zero()));
            hash.add(static_cast<std::int64_t>(hand.jaws.count()));
            hash.add(hand.pull);
        }
    });
    list.hashed(state_.fibres, [this](StateHash& hash) {
        if (spec_.fibres) state_.fibres.hash(hash);
    });
    list.kept(state_.positions).kept(state_.bindings).kept(state_.loose).kept(state_.any_loose);
    list.kept(state_.line).kept(state_.divided).kept(state_.traction).kept(state_.next_station);
}

void SheetPart::add_costs(double us, std::vector<PartCost>& costs) const {
    costs.push_back({"sheet", us, bytes()});
}

std::unique_ptr<Part> build_sheet_part(const Scene& scene, std::uint64_t /*seed*/,
                                       const PartList& /*parts*/) {
    if (!scene.sheet && !scene.septa) return nullptr;
    return std::make_unique<SheetPart>(scene, scene.step_period());
}

std::size_t SheetPart::bytes() const {
    return sizeof(*this) + membrane_.bytes() + state_bytes();
}

}  // namespace fulcrum
