// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/membranes/membranes_part.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr std::uint32_t most_frozen = 40;  // steps without a solution before it is reported, 0.2 s

Vector3 between_jaws(const HeldTool& held) {
    return held.tool.tip - 0.5 * held.instrument->jaw_length * held.tool.axis;
}

}  // namespace

MembranesPart::MembranesPart(const Scene& scene)
    : tissue_index_(static_cast<std::int16_t>(scene.tissue_index(scene.bowel->tissue))),
      layout_(lay_out_membranes(scene)) {
    tissue_ = scene.tissues[static_cast<std::size_t>(tissue_index_)];
    membranes_.reserve(layout_.size());
    for (std::size_t i = 0; i < layout_.size(); ++i)
        membranes_.emplace_back(scene, i, layout_[i], scene.step_period());
}

double MembranesPart::offer(int hand, const HeldTool& held) const noexcept {
    if (!type_of(held.instrument->kind).grasps ||
        !grasps_[hand].jaws.closing(held.tool, held.instrument->jaw_opening))
        return no_offer;
    constexpr double reach = Jaws::reach * Jaws::reach;
    double least = reach;
    Vector3 closest;
    for (const MembranePart& membrane : membranes_)
        membrane.nearest_triangle(between_jaws(held), least, closest);
    return least < reach ? std::sqrt(least) : no_offer;
}

void MembranesPart::take(int hand, const HeldTool& held) noexcept {
    HandGrasp& grasp = grasps_[hand];
    const Vector3 jaws = between_jaws(held);
    double least = Jaws::reach * Jaws::reach;
    Vector3 point = Vector3::Zero();
    std::int32_t triangle = -1;
    for (std::size_t i = 0; i < membranes_.size(); ++i) {
        Vector3 closest;
        const std::int32_t found = membranes_[i].nearest_triangle(jaws, least, closest);
        if (found < 0) continue;
        triangle = found;
        point = closest;
        grasp.membrane = static_cast<int>(i);
    }
    if (triangle < 0) return;
    MembranePart& membrane = membranes_[static_cast<std::size_t>(grasp.membrane)];
    membrane.take(hand, triangle, point, Jaws::pinch_share * tissue_.stiffness);
    grasp.jaws.clear_points();
    grasp.jaws.add_point(Vector3(0, 0, -0.5 * held.instrument->jaw_length), jaws, point);
    const JawBox box(held.tool, held.tool.jaw_angle, held.instrument->jaw_length,
                     held.instrument->tip_box.y());
    grasp.jaws.take(held.tool, {tissue_.stiffness, tissue_.friction},
                    box.contact_area(membrane.area_in(box)));
    grasp.stiffness = membrane.grip_stiffness(hand);
}

void MembranesPart::apply(const StepInput& input) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        const HeldTool& held = input.held[hand];
        HandGrasp& grasp = grasps_[hand];
        if (held.instrument == nullptr) continue;
        if (!type_of(held.instrument->kind).grasps) {
            grasp.jaws.block();
            continue;
        }
        MembranePart* membrane =
            grasp.membrane < 0 ? nullptr : &membranes_[static_cast<std::size_t>(grasp.membrane)];
        switch (grasp.jaws.step(held.tool, held.instrument->jaw_opening)) {
            case JawAction::none:
                break;
            case JawAction::close:  // what they take follows them from the next step on
                if (input.taker[hand] == this) take(hand, held);
                break;
            case JawAction::hold:
                grasp.jaws.carry(held.tool, {tissue_.stiffness, tissue_.friction},
                                 &membrane->grip(hand).point, held.instrument->jaw_length, input.dt);
                membrane->carry(hand, grasp.jaws.point(0).target);
                break;
            case JawAction::let_go:
                membrane->let_go(hand);
                break;
        }
    }
}

std::uint32_t MembranesPart::step(double dt) noexcept {
    std::uint32_t outcome = 0;
    for (MembranePart& membrane : membranes_) outcome = std::max(outcome, membrane.step(dt));
    frozen_steps_ = outcome >= 2 ? frozen_steps_ + 1 : 0;
    return frozen_steps_ > most_frozen ? 4 : outcome;
}

void MembranesPart::take_back() noexcept {
    for (MembranePart& membrane : membranes_) membrane.take_back();
}

void MembranesPart::stop() noexcept {
    for (MembranePart& membrane : membranes_) membrane.stop();
}

GraspState MembranesPart::grasp(int hand) const noexcept {
    const SheetGrip& grip = membranes_[static_cast<std::size_t>(grasps_[hand].membrane)].grip(hand);
    GraspState grasp;
    grasp.body = HeldBody::membrane;
    grasp.tissue = static_cast<std::int8_t>(tissue_index_);
    grasp.arc_length = -1;
    grasp.point = grip.point;
    grasp.reaction = grip.reaction;
    return grasp;
}

void MembranesPart::publish_model(int hand, const TickOutput& /*last*/, LocalModel& model) noexcept {
    const HandGrasp& grasp = grasps_[hand];
    if (!grasp.jaws.held()) return;
    model.mode = LocalMode::grasp;
    model.grasp = GraspModel();
    grasp.jaws.fill(model.grasp);
    model.grasp.reaction = membranes_[static_cast<std::size_t>(grasp.membrane)].grip(hand).reaction;
    model.grasp.stiffness = grasp.stiffness * Matrix3::Identity();
    model.grasp.damping = tissue_.damping;
    model.grasp.friction = tissue_.friction;
    model.grasp.tissue = tissue_index_;
}

void MembranesPart::size_snapshot(WorldSnapshot& snapshot) const {
    snapshot.membranes.resize(membranes_.size());
    for (std::size_t i = 0; i < membranes_.size(); ++i) membranes_[i].size_snapshot(snapshot.membranes[i]);
}

void MembranesPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    for (std::size_t i = 0; i < membranes_.size(); ++i) membranes_[i].fill_snapshot(snapshot.membranes[i]);
}

void MembranesPart::list_state(StateList& list) {
    for (MembranePart& membrane : membranes_) membrane.list_state(list);
    list.kept(grasps_).kept(frozen_steps_);
}

void MembranesPart::add_costs(double us, std::vector<PartCost>& costs) const {
    std::size_t bytes = 0;
    for (const MembranePart& membrane : membranes_) bytes += membrane.bytes();
    costs.push_back({"membranes", us, bytes});
}

std::unique_ptr<Part> build_membranes_part(const Scene& scene, std::uint64_t /*seed*/,
                                           const PartList& /*parts*/) {
    if (!scene.bowel || !scene.cavity || scene.membranes.empty()) return nullptr;
    return std::make_unique<MembranesPart>(scene);
}

}  // namespace fulcrum
