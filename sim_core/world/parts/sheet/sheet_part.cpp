// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/sheet/sheet_part.h"

#include <algorithm>

namespace fulcrum {

using sheet_rows::at;
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
    body_.begin(tick);
    for (int hand = 0; hand < hand_count; ++hand) {
        if (actions[hand].instrument == nullptr) continue;
        contact_.update_jaws(hand, actions[hand], dt);
        contact_.approach(hand, actions[hand], tick, dt);
    }
    contact_.add_links(actions);
}

std::uint32_t SheetPart::solve(const SheetAction* actions, std::uint32_t tick, double dt) noexcept {
    body_.step_membrane(dt);
    contact_.read_links();
    body_.update_positions();
    for (int hand = 0; hand < hand_count; ++hand) {
        if (actions[hand].instrument == nullptr) continue;
        const ToolKinematics& tool = actions[hand].tool;
        SheetHand& of_hand = body_.state().hands[static_cast<std::size_t>(hand)];
        of_hand.in = tool.inside;
        if (!tool.present) continue;  // its device does not answer: it stays where it was and cuts nothing
        blades_.follow(hand, actions[hand], tick);
        if (!tool.inside || !tool.tip.allFinite()) continue;
        of_hand.tip = tool.tip;
        of_hand.been_in = true;
    }
    body_.drop_loose(tick);
    body_.measure_station();
    fibres_.step(tick, dt);
    return body_.faults();
}

void SheetPart::stop() noexcept {
    for (Vector3& v : body_.state().membrane.velocities) v.setZero();
}

void SheetPart::restore(const State& state, const CutState& surface) {
    body_.state() = state;
    body_.surface().restore(surface);
    follow_restore();
}

void SheetPart::size_snapshot(WorldSnapshot& snapshot) const {
    SheetView& view = snapshot.sheet;
    view.line.resize(body_.state().line.size(), Vector3::Zero());
    view.line_positions = body_.line_positions();
    view.line_traction = body_.state().traction;
    view.line_divided = body_.state().divided;
    view.flap.resize(at(body_.layout().columns), Vector3::Zero());
    view.positions.resize(at(body_.surface().capacity().vertices), Vector3::Zero());
    view.rest.resize(at(body_.surface().capacity().vertices), Vector3::Zero());
    view.triangles.resize(at(body_.surface().capacity().triangles), Triangle{0, 0, 0});
    view.roots.resize(view.triangles.size(), 0);
    view.thickness = body_.spec().thickness;
    if (body_.septa()) {
        view.septum_length = body_.septa()->width;
        view.fat_from = body_.septa()->areolar_height - body_.septa()->plane_height;
        view.envelope_columns = body_.layout().columns;
        view.envelope.resize(at(body_.layout().pieces * body_.layout().columns), Vector3::Zero());
    }
    view.topology = 0xFFFFFFFFU;  // filled with the first picture
    body_.events().size(snapshot);
}

void SheetPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    SheetView& view = snapshot.sheet;
    for (std::size_t i = 0; i < body_.state().line.size(); ++i) {
        if (body_.state().line[i].fragment >= 0) view.line[i] = body_.place(body_.state().line[i]);
    }
    std::copy(body_.state().traction.begin(), body_.state().traction.end(), view.line_traction.begin());
    std::copy(body_.state().divided.begin(), body_.state().divided.end(), view.line_divided.begin());
    for (std::int32_t c = 0; c < body_.layout().columns; ++c)
        view.flap[at(c)] =
            body_.state().positions[at((body_.layout().rows - 1) * body_.layout().columns + c)];
    for (std::size_t i = 0; i < view.envelope.size(); ++i) {
        const auto piece = static_cast<std::int32_t>(i) / body_.layout().columns,
                   column = static_cast<std::int32_t>(i) % body_.layout().columns;
        view.envelope[i] = body_.state().positions[at(
            (piece * body_.layout().rows + body_.layout().envelope_row) * body_.layout().columns + column)];
    }
    view.vertex_count = body_.surface().vertex_count();
    view.positions.used = view.rest.used = at(view.vertex_count);
    std::copy_n(body_.state().positions.begin(), at(view.vertex_count), view.positions.begin());
    if (view.topology != body_.state().membrane.topology) {
        view.topology = body_.state().membrane.topology;
        for (std::int32_t v = 0; v < view.vertex_count; ++v) {
            if (body_.septa()) {
                if (body_.state().bindings[at(v)].fragment >= 0)
                    view.rest[at(v)] = body_.rest(body_.state().bindings[at(v)]);
                continue;
            }
            const Vector3 from_start = body_.surface().vertex(v).rest - body_.line_start();
            view.rest[at(v)] =
                Vector3(from_start.dot(body_.spec().along), from_start.dot(body_.spec().across), 0);
        }
        view.triangle_count = static_cast<std::int32_t>(body_.visible().size());
        view.triangles.used = view.roots.used = body_.visible().size();
        for (std::size_t k = 0; k < body_.visible().size(); ++k) {
            view.triangles[k] = body_.visible()[k].vertices;
            view.roots[k] = body_.surface().triangle(body_.visible()[k].number).root;
        }
        view.visible_area = body_.surface().area_visible();
        view.removed_area = body_.surface().area_removed();
    }
    body_.events().append_to(snapshot);
}

GraspState SheetPart::grasp(int number) const noexcept {
    const SheetHand& hand = body_.state().hands[static_cast<std::size_t>(number)];
    GraspState grasp;
    if (body_.septa()) grasp.arc_length = -1;
    grasp.body = HeldBody::sheet;
    grasp.offset = body_.on_septum(hand.held_at[0], body_.rest(hand.held_at[0]));
    grasp.tissue =
        static_cast<std::int8_t>(body_.in_fat(grasp.offset) ? body_.fat_index() : body_.tissue_index());
    grasp.point = body_.place(hand.held_at[0]);
    grasp.reaction = hand.pull;
    return grasp;
}

SheetUnder SheetPart::under(int number) const noexcept {
    const SheetHand& hand = body_.state().hands[static_cast<std::size_t>(number)];
    SheetUnder found;
    if ((hand.touch != BladeTouch::touching && hand.touch != BladeTouch::cutting) || hand.place.fragment < 0)
        return found;
    found.root = body_.surface().fragment(hand.place.fragment).root;
    found.fat = body_.in_fat(body_.rest(hand.place));
    return found;
}

bool SheetPart::root_in_fat(std::int32_t root) const {
    return body_.in_fat(body_.rest({root, Vector3::Constant(1.0 / 3), root}));
}

void SheetPart::follow_restore() {
    body_.follow_restore();
}

void SheetPart::list_state(StateList& list) {
    list.hashed(body_.state().membrane, [this](StateHash& hash) {
        const CutMembraneState& m = body_.state().membrane;
        for (std::size_t n = 0; n < at(m.node_end); ++n) {
            hash.add(m.positions[n]);
            hash.add(m.velocities[n]);
            hash.add(m.masses[n]);
        }
        hash.add(static_cast<std::int64_t>(m.topology));
    });
    list.hashed_through([this] { return body_.surface().state(); },
                        [this](const CutState& surface) { body_.surface().restore(surface); },
                        [this](StateHash& hash) { hash.add(body_.surface().digest()); },
                        [this] { return body_.surface().bytes(); }, body_.surface());
    list.hashed(body_.state().hands, [this](StateHash& hash) {
        for (const SheetHand& hand : body_.state().hands) {
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
    list.hashed(body_.state().fibres, [this](StateHash& hash) {
        if (body_.spec().fibres) body_.state().fibres.hash(hash);
    });
    list.kept(body_.state().positions)
        .kept(body_.state().bindings)
        .kept(body_.state().loose)
        .kept(body_.state().any_loose);
    list.kept(body_.state().line)
        .kept(body_.state().divided)
        .kept(body_.state().traction)
        .kept(body_.state().next_station);
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
    return sizeof(*this) + body_.bytes() + state_bytes();
}

}  // namespace fulcrum
