// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/objects/objects_part.h"

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"

namespace fulcrum {
namespace {

constexpr double jaw_reach = 0.004;     // m, from the jaws' middle line to a tube that they take
constexpr double half_hold = 0.003;     // m, from the middle of a hold to its outer points
constexpr double pusher_length = 0.05;  // m of an instrument that can push rings
constexpr double free_load = 4;         // times a ring's weight: what moves a free ring is not felt as a wall

Vector3 between_jaws(const HeldTool& held, double share) {
    return held.tool.tip - share * held.instrument->jaw_length * held.tool.axis;
}

// Stiffness that a hand feels along the force on what it holds or pushes: none while the ring is free.
Matrix3 felt_stiffness(const Vector3& force, double weight, double stiffness) {
    const double size = force.norm();
    const double blocked = std::clamp((size - free_load * weight) / (free_load * weight), 0.0, 1.0);
    if (!(blocked > 0)) return Matrix3::Zero();
    return blocked * stiffness * force * force.transpose() / (size * size);
}

}  // namespace

ObjectsPart::ObjectsPart(const Scene& scene, std::uint64_t seed)
    : spec_(*scene.objects),
      layout_(place_objects(spec_, scene.gravity, seed)),
      tray_(tray_mesh(spec_, layout_.feet), FreeSide::front),
      tissue_index_(static_cast<std::int16_t>(scene.tissue_index(spec_.tissue))),
      bodies_(layout_.bodies),
      solver_(layout_.ring, layout_.ground),
      before_(layout_.bodies) {
    tissue_ = scene.tissues[static_cast<std::size_t>(tissue_index_)];
}

ObjectsPart::Reach ObjectsPart::nearest(const HeldTool& held) const noexcept {
    const Vector3 root = between_jaws(held, 1);
    Reach reach;
    reach.distance = jaw_reach;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if ((bodies_[i].position - held.tool.tip).norm() >
            layout_.ring.reach + held.instrument->jaw_length + jaw_reach)
            continue;
        const std::size_t count = layout_.ring.corners.size();
        for (std::size_t k = 0; k < count; ++k) {
            const SegmentPair pair = closest_points_of_segments(
                point_of(bodies_[i], layout_.ring.corners[k]),
                point_of(bodies_[i], layout_.ring.corners[(k + 1) % count]), root, held.tool.tip);
            const double distance =
                std::max(0.0, (pair.on_first - pair.on_second).norm() - layout_.ring.radius);
            if (distance >= reach.distance) continue;
            reach = {static_cast<std::int32_t>(i), k, distance, pair.on_first};
        }
    }
    return reach;
}

double ObjectsPart::offer(int hand, const HeldTool& held) const noexcept {
    if (!type_of(held.instrument->kind).grasps ||
        !hands_[hand].jaws.closing(held.tool, held.instrument->jaw_opening))
        return no_offer;
    const Reach reach = nearest(held);
    return reach.object >= 0 ? reach.distance : no_offer;
}

void ObjectsPart::take(int number, const HeldTool& held) noexcept {
    const Reach reach = nearest(held);
    if (reach.object < 0) return;
    HandState& hand = hands_[number];
    const BodyState& body = bodies_[static_cast<std::size_t>(reach.object)];
    const std::vector<Vector3>& corners = layout_.ring.corners;
    const Vector3 along = (corners[(reach.tube + 1) % corners.size()] - corners[reach.tube]).normalized();
    const Vector3 inward = Vector3::UnitZ().cross(along);
    const Vector3 middle = body.rotation.conjugate() * (reach.on_ring - body.position);
    hand.at = {middle - half_hold * along, middle + half_hold * along, middle + half_hold * inward};
    // It stays where the jaws closed on it: what is rigid is not drawn into them, so that a second pair of
    // jaws does not pull it out of the first.
    hand.jaws.clear_points();
    for (const Vector3& at : hand.at) {
        const Vector3 point = point_of(body, at);
        hand.jaws.add_point(held.tool.rotation.transpose() * (point - held.tool.tip), point, point);
    }
    hand.jaws.take(held.tool, {tissue_.stiffness, tissue_.friction}, 2 * half_hold * 2 * layout_.ring.radius);
    hand.object = reach.object;
}

void ObjectsPart::let_go(int number, std::uint32_t tick) noexcept {
    const std::int32_t object = hands_[number].object;
    hands_[number].object = -1;
    for (const HandState& other : hands_) {
        if (other.object == object) return;
    }
    const BodyState& body = bodies_[static_cast<std::size_t>(object)];
    const double height = solver_.height(body);
    if (height > drop_height && peg_of(body) < 0)
        events_.add(tick, EventKind::drop, number, tissue_index_, height, object);
}

void ObjectsPart::follow_jaws(int number, const StepInput& input) noexcept {
    const HeldTool& held = input.held[number];
    HandState& hand = hands_[number];
    const HeldTissue ring = {tissue_.stiffness, tissue_.friction};
    BodyGrip& grip = grips_[number];
    grip = BodyGrip();
    const JawAction action = hand.jaws.step(held.tool, held.instrument->jaw_opening);
    if (action == JawAction::close && input.taker[number] == this) take(number, held);
    if (action == JawAction::let_go) let_go(number, input.tick());
    if (hand.object < 0) return;
    if (action == JawAction::hold) {
        std::array<Vector3, grip_points> now;
        const BodyState& body = bodies_[static_cast<std::size_t>(hand.object)];
        for (std::size_t i = 0; i < now.size(); ++i) now[i] = point_of(body, hand.at[i]);
        hand.jaws.carry(held.tool, ring, now.data(), held.instrument->jaw_length, input.dt);
    }
    grip.body = hand.object;
    grip.count = grip_points;
    grip.at = hand.at;
    grip.stiffness = hand.jaws.stiffness();
    grip.damping = tissue_.damping / grip_points;
    grip.most = hand.jaws.most();
    for (std::size_t i = 0; i < hand.at.size(); ++i) {
        const Jaws::Point& point = hand.jaws.point(static_cast<int>(i));
        grip.target[i] = point.target;
        grip.last[i] = action == JawAction::hold ? point.last : point.target;
    }
}

void ObjectsPart::place_pusher(int number, const HeldTool& held) noexcept {
    HandState& hand = hands_[number];
    BodyPusher& pusher = pushers_[number];
    const bool open =
        type_of(held.instrument->kind).jaws && !Jaws::may_hold(held.tool, held.instrument->jaw_opening);
    const Vector3 end = open ? between_jaws(held, 1) : held.tool.tip;
    const Capsule now = {end - pusher_length * held.tool.axis, end, held.instrument->tip_radius};
    // An instrument whose device does not answer stays where it was, on its side of a tube.
    pusher.present = held.tool.inside && (held.tool.present || hand.present);
    pusher.spares = hand.object;
    pusher.before = hand.present ? hand.pusher : now;
    pusher.after = now;
    pusher.stiffness = tissue_.stiffness;
    pusher.damping = tissue_.damping;
    // Jaws that open or close do not move the instrument.
    if ((pusher.before.to - now.to).norm() > 0.5 * held.instrument->jaw_length) pusher.before = now;
    hand.pusher = now;
    hand.present = pusher.present;
}

void ObjectsPart::apply(const StepInput& input) noexcept {
    for (int number = 0; number < hand_count; ++number) {
        grips_[number] = BodyGrip();
        pushers_[number] = BodyPusher();
        const HeldTool& held = input.held[number];
        if (held.instrument == nullptr) continue;
        if (type_of(held.instrument->kind).grasps) follow_jaws(number, input);
        place_pusher(number, held);
    }
}

std::uint32_t ObjectsPart::solve(const StepInput& input) noexcept {
    std::copy(bodies_.begin(), bodies_.end(), before_.begin());
    solver_.step(bodies_, grips_, pushers_, hand_count, input.dt);
    for (int number = 0; number < hand_count; ++number) {
        const ToolKinematics& tool = input.held[number].tool;
        const BodyPusher& pusher = pushers_[number];
        hands_[number].hold_force = grips_[number].force;
        hands_[number].push_force = pusher.force;
        hands_[number].push_back =
            (tool.tip - pusher.after.to).dot(tool.axis) + (1 - pusher.place()) * pusher_length;
    }
    const bool finite = std::all_of(bodies_.begin(), bodies_.end(), [](const BodyState& body) {
        return body.position.allFinite() && body.rotation.coeffs().allFinite() && body.velocity.allFinite() &&
               body.spin.allFinite();
    });
    // Contacts that did not fit were left out of the step.
    if (finite) return solver_.contacts() < CapsuleBodies::contact_capacity ? 0 : 1;
    std::copy(before_.begin(), before_.end(), bodies_.begin());
    for (BodyState& body : bodies_) {
        body.velocity.setZero();
        body.spin.setZero();
    }
    for (HandState& hand : hands_) hand.hold_force = hand.push_force = Vector3::Zero();
    return 2;
}

GraspState ObjectsPart::grasp(int number) const noexcept {
    const HandState& hand = hands_[number];
    GraspState grasp;
    grasp.body = HeldBody::object;
    grasp.tissue = static_cast<std::int8_t>(tissue_index_);
    grasp.patch = hand.object;
    grasp.point = point_of(bodies_[static_cast<std::size_t>(hand.object)], 0.5 * (hand.at[0] + hand.at[1]));
    grasp.reaction = hand.hold_force;
    return grasp;
}

void ObjectsPart::publish_model(int number, const TickOutput& last, LocalModel& model) noexcept {
    const HandState& hand = hands_[number];
    const double weight = layout_.ring.mass * layout_.ground.gravity.norm();
    model.jaws = JawPushModel();
    if (hand.push_force.squaredNorm() > 0) {
        const ToolKinematics& tool = last.contact[number].tool;
        model.jaws.back = hand.push_back;
        model.jaws.place = model.jaws.point = tool.tip - hand.push_back * tool.axis;
        model.jaws.force = hand.push_force;
        model.jaws.stiffness = felt_stiffness(hand.push_force, weight, tissue_.stiffness);
        model.jaws.tissue = tissue_index_;
    }
    if (hand.object < 0) return;
    model.mode = LocalMode::grasp;
    model.grasp = GraspModel();
    hand.jaws.fill(model.grasp);
    model.grasp.reaction = hand.hold_force;
    model.grasp.stiffness = felt_stiffness(hand.hold_force, weight, grip_points * hand.jaws.stiffness());
    model.grasp.damping = tissue_.damping;
    model.grasp.friction = tissue_.friction;
    model.grasp.tissue = tissue_index_;
    model.grasp.tissue_patch = static_cast<std::int16_t>(hand.object);
}

std::int32_t ObjectsPart::peg_of(const BodyState& body) const noexcept {
    for (std::size_t i = 0; i < layout_.feet.size(); ++i) {
        if (goes_through(layout_.ring, body, layout_.feet[i], spec_.peg_height))
            return static_cast<std::int32_t>(i);
    }
    return -1;
}

void ObjectsPart::size_snapshot(WorldSnapshot& snapshot) const {
    ObjectsView& view = snapshot.objects;
    view.objects.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) view.objects[i].start_peg = static_cast<std::int32_t>(i);
    for (const Vector3& foot : layout_.feet)
        view.pegs.push_back({foot, foot + Vector3(0, 0, spec_.peg_height),
                             foot.x() > spec_.centre.x() ? Hand::left : Hand::right});
    view.corners = layout_.ring.corners;
    view.tube_radius = spec_.tube_radius;
    view.peg_radius = spec_.peg_radius;
    view.centre = spec_.centre;
    view.half_length = spec_.half_length;
    view.half_width = spec_.half_width;
    events_.size(snapshot);
}

void ObjectsPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        ObjectView& view = snapshot.objects.objects[i];
        view.position = bodies_[i].position;
        view.rotation = bodies_[i].rotation;
        view.velocity = bodies_[i].velocity;
        view.height = solver_.height(bodies_[i]);
        view.peg = peg_of(bodies_[i]);
    }
    events_.append_to(snapshot);
}

void ObjectsPart::list_state(StateList& list) {
    list.hashed(bodies_, [this](StateHash& hash) {
        for (const BodyState& body : bodies_) {
            hash.add(body.position);
            hash.add(Vector3(body.rotation.vec()));
        }
        for (const HandState& hand : hands_) hash.add(static_cast<std::int64_t>(hand.object));
    });
    list.kept(hands_);
}

void ObjectsPart::add_costs(double us, std::vector<PartCost>& costs) const {
    costs.push_back({"cavity", 0, tray_.bytes()});
    costs.push_back({"objects", us, sizeof(*this) - sizeof(solver_) + solver_.bytes() + state_bytes()});
}

std::unique_ptr<Part> build_objects_part(const Scene& scene, std::uint64_t seed, const PartList& /*parts*/) {
    return scene.objects ? std::make_unique<ObjectsPart>(scene, seed) : nullptr;
}

}  // namespace fulcrum
