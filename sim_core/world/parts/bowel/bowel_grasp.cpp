// SPDX-License-Identifier: Apache-2.0
// Jaws on the bowel: taking hold, holding a wall point through the pinched wall, slipping, letting go.
#include <algorithm>
#include <cmath>

#include "sim_core/contact/series_stiffness.h"
#include "sim_core/world/parts/bowel/bowel_part.h"

namespace fulcrum {

// The wall's vertex within the root of `least`, m2, which is lowered to its squared distance; -1: none.
std::int32_t BowelPart::nearest_to(const Vector3& jaws, double& least) const noexcept {
    // Sphere -> its rings -> their vertices: only what can be within reach is skinned.
    std::int32_t nearest = -1;
    for (int r = 0; r + skin_rings <= skin_->rings(); ++r) {
        const auto first = static_cast<std::size_t>(skin_->by_ring_offsets()[static_cast<std::size_t>(r)]);
        const auto last = static_cast<std::size_t>(skin_->by_ring_offsets()[static_cast<std::size_t>(r) + 1]);
        if (first == last || (ring_frames_[static_cast<std::size_t>(r) + 1].position - jaws).norm() > 0.05)
            continue;
        for (std::size_t k = first; k < last; ++k) {
            const std::int32_t vertex = skin_->by_ring()[k];
            const double distance =
                (skin_vertex(skin_->rows()[static_cast<std::size_t>(vertex)], ring_frames_) - jaws)
                    .squaredNorm();
            if (distance < least && (!cut_ || cut_->vertex_share(vertex) > 0)) {
                least = distance;
                nearest = vertex;
            }
        }
    }
    return nearest;
}

// m2 of the wall, at rest, about `middle`; of what blades left.
double BowelPart::area_in(const JawBox& box, const Vector3& middle) const noexcept {
    double area = 0;
    for (int r = 0; r + skin_rings <= skin_->rings(); ++r) {
        if ((ring_frames_[static_cast<std::size_t>(r) + 1].position - middle).norm() > 0.05) continue;
        const auto first = static_cast<std::size_t>(skin_->by_ring_offsets()[static_cast<std::size_t>(r)]);
        const auto last = static_cast<std::size_t>(skin_->by_ring_offsets()[static_cast<std::size_t>(r) + 1]);
        for (std::size_t k = first; k < last; ++k) {
            const std::int32_t vertex = skin_->by_ring()[k];
            const auto v = static_cast<std::size_t>(vertex);
            if (!box.contains(skin_vertex(skin_->rows()[v], ring_frames_))) continue;
            area += skin_->vertex_areas()[v] * (cut_ ? cut_->vertex_share(vertex) : 1.0);
        }
    }
    return area;
}

double BowelPart::offer(int hand, const HeldTool& held) const noexcept {
    const ToolKinematics& tool = held.tool;
    if (!type_of(held.instrument->kind).grasps ||
        !grasps_[hand].jaws.closing(tool, held.instrument->jaw_opening))
        return no_offer;
    const Vector3 jaws = tool.tip - 0.5 * held.instrument->jaw_length * tool.axis;
    constexpr double reach = Jaws::reach * Jaws::reach;
    double least = reach;
    nearest_to(jaws, least);
    return least < reach ? std::sqrt(least) : no_offer;
}

void BowelPart::begin_grasp(int hand, const ToolAction& action) noexcept {
    const Vector3 jaws = action.tool.tip - 0.5 * action.instrument->jaw_length * action.tool.axis;
    double least = Jaws::reach * Jaws::reach;
    const std::int32_t nearest = nearest_to(jaws, least);
    if (nearest < 0) return;
    HandGrasp& grasp = grasps_[hand];
    const Vector3 point = skin_vertex(skin_->rows()[static_cast<std::size_t>(nearest)], ring_frames_);
    grasp.state.held = true;
    grasp.state.slipped = false;
    grasp.state.arc_length =
        std::clamp(skin_->rest().vertices[static_cast<std::size_t>(nearest)].x(), 0.0, rod_->length());
    grasp.state.offset = rod_->wall_offset(state_, grasp.state.arc_length, point);
    grasp.state.point = point;
    grasp.state.reaction.setZero();
    grasp.state.patch = patches_->tissue_patches()[static_cast<std::size_t>(nearest)];
    grasp.jaws.clear_points();
    grasp.jaws.add_point(Vector3(0, 0, -0.5 * action.instrument->jaw_length), jaws, point);
    const TissueSpec& tissue =
        scene_.tissues[static_cast<std::size_t>(scene_.tissue_index(scene_.bowel->tissue))];
    const JawBox box(action.tool, action.tool.jaw_angle, action.instrument->jaw_length,
                     action.instrument->tip_box.y());
    grasp.jaws.take(action.tool, {tissue.stiffness, tissue.friction}, box.contact_area(area_in(box, jaws)));
    grasp.vertex = nearest;
    grasp.stiffness = rod_->stiffness_at(state_, grasp.state.arc_length, grasp.state.offset, scratch_);
    spread_pull(grasp, action);
}

// Shares of a pull at the grasp (Pan et al. 2011, Fig. 5): two rings around the vertex, skinned where they
// are read; of what blades left.
void BowelPart::spread_pull(HandGrasp& grasp, const ToolAction& action) noexcept {
    const std::int32_t nearest = grasp.vertex;
    const MeshAdjacency& adjacency = skin_->adjacency();
    const auto place = [&](std::int32_t vertex) {
        surface_[static_cast<std::size_t>(vertex)] =
            skin_vertex(skin_->rows()[static_cast<std::size_t>(vertex)], ring_frames_);
    };
    place(nearest);
    for (const std::int32_t first : adjacency.neighbours_of(nearest)) {
        place(first);
        for (const std::int32_t second : adjacency.neighbours_of(first)) {
            place(second);
            for (const std::int32_t third : adjacency.neighbours_of(second)) place(third);
        }
    }
    TipBox box;
    box.edges = action.instrument->tip_box;
    box.axes.col(0) = action.tool.axis;
    box.axes.col(1) = action.tool.rotation.col(0);
    box.axes.col(2) = action.tool.rotation.col(1);
    FilterOptions options;
    options.mode = filter_;
    filter_force(view_of(skin_->rest(), adjacency, surface_.data()), nearest, box, options, grasp.filtered);
    if (!cut_ || cut_->skin().whole()) return;
    FilteredForce& shares = grasp.filtered;
    double sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(shares.count); ++i)
        sum += shares.weight[i] *= cut_->vertex_share(shares.vertex[i]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(shares.count); ++i)
        shares.weight[i] = sum > 0 ? shares.weight[i] / sum : 0.0;
    if (!(sum > 0)) shares.count = 0;
}

// After a cut. The hold is a point of the wall in the rod's frame, which stays: what changes is what the jaws
// have between them. They keep what is left within their reach and bear on that, and let go where nothing is.
void BowelPart::keep_hold(const ToolAction* actions) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        HandGrasp& grasp = grasps_[hand];
        if (!grasp.state.held || actions[hand].instrument == nullptr) continue;
        const std::int32_t start = *skin_->adjacency().triangles_of(grasp.vertex).begin();
        const std::int32_t left =
            cut_->nearest_left(grasp.state.point, start, Jaws::reach, ring_frames_.data());
        if (left < 0) {
            grasp.jaws.lose();
            end_grasp(hand);
            continue;
        }
        grasp.vertex = left;
        grasp.state.patch = patches_->tissue_patches()[static_cast<std::size_t>(left)];
        spread_pull(grasp, actions[hand]);
    }
}

// Jaws that hold nothing any more.
void BowelPart::end_grasp(int hand) noexcept {
    HandGrasp& grasp = grasps_[hand];
    grasp.state.slipped = grasp.jaws.slipped();
    grasp.state.held = false;
    grasp.state.reaction.setZero();
    grasp.filtered.count = 0;
}

void BowelPart::update_grasps(const ToolAction* actions, double dt) noexcept {
    const TissueSpec& tissue =
        scene_.tissues[static_cast<std::size_t>(scene_.tissue_index(scene_.bowel->tissue))];
    for (int hand = 0; hand < hand_count; ++hand) {
        const ToolAction& action = actions[hand];
        HandGrasp& grasp = grasps_[hand];
        if (action.instrument == nullptr) continue;
        if (!type_of(action.instrument->kind).grasps) {
            grasp.jaws.block();
            continue;
        }
        switch (grasp.jaws.step(action.tool, action.instrument->jaw_opening)) {
            case JawAction::none:
                continue;
            case JawAction::let_go:
                end_grasp(hand);
                continue;
            case JawAction::close:
                if (action.takes) begin_grasp(hand, action);
                if (!grasp.state.held) continue;
                break;  // the wall follows the jaws from this step on
            case JawAction::hold:
                break;
        }
        grasp.jaws.carry(action.tool, {tissue.stiffness, tissue.friction}, &grasp.state.point,
                         action.instrument->jaw_length, dt);
        patch_damage_[static_cast<std::size_t>(std::max(0, grasp.state.patch))] +=
            static_cast<float>(action.tool.grip * dt);
    }
    inputs_.grasps.clear();
    for (const HandGrasp& grasp : grasps_) {
        if (!grasp.state.held) continue;
        RodGrasp hold;
        hold.s = grasp.state.arc_length;
        hold.offset = grasp.state.offset;
        hold.target = grasp.jaws.point(0).target;
        hold.stiffness = grasp.jaws.stiffness();
        hold.most = grasp.jaws.most();
        hold.reaction = grasp.state.reaction;
        inputs_.grasps.push_back(hold);
    }
}

void BowelPart::publish_model(int hand, const TickOutput& last, LocalModel& model) noexcept {
    const Touch& touch = touches_[static_cast<std::size_t>(hand)];
    PatchRequest request;
    request.tool = last.contact[hand].tool;
    request.shaft_radius = touch.model.instrument.shaft_radius;
    // Jaws that hold tissue have its vertex from this step on, not from the next one's contact.
    request.contact_vertex = grasps_[hand].state.held ? grasps_[hand].vertex : last.contact[hand].vertex;
    request.horizon = 2 * scene_.step_period();  // until the next model is there, were it a whole step late
    fill_grasp(hand, request, model);
    if (cut_) cut_->fill_local_model(hand, model);
}

void BowelPart::fill_grasp(int hand, const PatchRequest& request, LocalModel& model) noexcept {
    Stopwatch watch(measuring_, costs_.patches);
    patches_->build(rings_.data(), request, patch_scratch_, model);
    model.jaws = jaw_felt_[hand];
    const HandGrasp& grasp = grasps_[hand];
    if (!grasp.state.held) return;
    model.mode = LocalMode::grasp;
    const int index = scene_.tissue_index(scene_.bowel->tissue);
    grasp.jaws.fill(model.grasp);
    model.grasp.reaction = grasp.state.reaction;
    // In series with the pinched wall itself: however firmly the rod is held elsewhere, the jaws feel no more
    // than tissue.
    const double wall = Jaws::pinch_share * scene_.tissues[static_cast<std::size_t>(index)].stiffness;
    model.grasp.stiffness = stiffness_in_series(grasp.stiffness, wall);
    model.grasp.damping = scene_.tissues[static_cast<std::size_t>(index)].damping;
    model.grasp.friction = scene_.tissues[static_cast<std::size_t>(index)].friction;
    model.grasp.vertex = grasp.vertex;
    model.grasp.tissue = static_cast<std::int16_t>(index);
    model.grasp.tissue_patch = static_cast<std::int16_t>(grasp.state.patch);
}

GraspState BowelPart::grasp(int hand) const noexcept {
    GraspState grasp = grasps_[hand].state;
    grasp.body = HeldBody::bowel;
    grasp.tissue = static_cast<std::int8_t>(scene_.tissue_index(scene_.bowel->tissue));
    return grasp;
}

void BowelPart::size_snapshot(WorldSnapshot& snapshot) const {
    BowelView& view = snapshot.bowel;
    view.nodes = state_.nodes;
    view.node_arc_lengths = rod_->node_arc_lengths();
    view.rings = ring_frames_;
    view.ring_arc_lengths = skin_->cage().arc_lengths;
    view.dents.resize(dent_capacity);
    view.patch_damage = patch_damage_;
    view.tether_anchors.clear();
    view.tether_arc_lengths.clear();
    for (std::size_t i = anatomy_.cranial_holds.size(); i < inputs_.tethers.size(); ++i) {
        const RodTether& tether = inputs_.tethers[i];
        view.tether_anchors.push_back(tether.anchor);
        view.tether_arc_lengths.push_back(tether.s);
    }
    if (cut_) cut_->size_snapshot(snapshot);
}

void BowelPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    BowelView& view = snapshot.bowel;
    std::copy(state_.nodes.begin(), state_.nodes.end(), view.nodes.begin());
    std::copy(ring_frames_.begin(), ring_frames_.end(), view.rings.begin());
    std::copy(dents_.entries.begin(), dents_.entries.begin() + dents_.count, view.dents.begin());
    view.dent_count = dents_.count;
    std::copy(patch_damage_.begin(), patch_damage_.end(), view.patch_damage.begin());
    view.solve_residual = report_.residual;
    view.residual_penetration = contacts_.deepest_cavity;
    view.floor_load = report_.contact_sum;
    if (cut_) cut_->fill_snapshot(snapshot);
}

void BowelPart::show_touch(fulcrum::Touch& touch) const noexcept {
    if (touch.vertex < 0) return;
    for (int i = 0; i < dents_.count; ++i) {
        const DentVertex& dent = dents_.entries[static_cast<std::size_t>(i)];
        if (dent.vertex == touch.vertex)
            touch.depth = std::max(0.0, touch.depth + touch.normal.dot(dent.displacement));
    }
}

}  // namespace fulcrum
