// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haptics/loop.h"

#include <algorithm>
#include <cmath>

#include "sim_core/haptics/clutch.h"
#include "sim_core/numerics/state_archive.h"
#include "sim_core/world/world.h"

namespace fulcrum {
namespace {

constexpr double unexplained = 0.02;  // N in a tick that tissue's own motion and a surface's bends may add

std::int32_t counts(double value, double unit) {
    const double scaled = value / unit;
    if (!(scaled > -2.0e9)) return scaled != scaled ? 0 : -2000000000;
    return scaled < 2.0e9 ? static_cast<std::int32_t>(std::lround(scaled)) : 2000000000;
}

void store(const Vector3& value, double unit, std::int32_t (&out)[3]) {
    for (int i = 0; i < 3; ++i) out[i] = counts(value[i], unit);
}

}  // namespace

struct HapticLoop::Parts {
    Scene scene;
    ToolContactModel contact[hand_count];
    ScopeModel scope;
    bool has_camera = false;
    bool has_hand[hand_count] = {false, false};
    double device_damping[hand_count] = {-1, -1};
    SafetyLimits limits;

    LocalModels models[2];
    int current = 0;
    bool swapped = false;  // the models changed since the last tick
    std::uint32_t model_step = 0;

    InstrumentState instrument[hand_count];
    ToolKinematics tool[hand_count];
    ToolContactState state[hand_count];
    ToolContactState state_before[hand_count];  // at the tick before
    ToolPairState pair;
    CameraPose camera;
    Vector3 tip_before[hand_count] = {Vector3::Zero(), Vector3::Zero()},
            velocity_before[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    double moved[hand_count] = {0, 0};         // m, displacement of a tip since the tick before
    double slope_before[hand_count] = {0, 0};  // N/m, of what a hand touched
    SafetyState safety[hand_count];
    PassivityController passivity[hand_count];
    DeviceSample held[hand_count];    // what the instruments follow: the devices except in pauses and losses
    DeviceSample offset[hand_count];  // clutch: added to the device after a resume
    bool on_hold = false;             // in a pause or while a device is lost
    ToolContactScratch scratch[hand_count];
    ToolContactResult result[hand_count], old_result;
    unsigned limited = 0;
    TickOutput output;

    void follow_device(int hand, const DeviceSample& device, bool was_on_hold) noexcept;
    void move_instruments(const RigSample& input) noexcept;
    void find_contacts(std::uint32_t tick) noexcept;
    double explained(int hand) noexcept;
    SafetyInput safety_input(int hand, std::uint32_t tick) noexcept;
    void limit_stiffness(int hand, SafetyInput& safety) noexcept;
    void record_hand(int hand, const RigSample& input, const SafetyOutput& sent, HandSample& record) noexcept;
    void record_grasp(int hand, HandSample& record) noexcept;
    void record_camera(CameraSample& record) const noexcept;
};

/// Clutches the device in where it is after a pause or a loss, so that the instrument does not jump.
void HapticLoop::Parts::follow_device(int hand, const DeviceSample& device, bool was_on_hold) noexcept {
    DeviceSample& follows = held[hand];
    DeviceSample& by = offset[hand];
    if (was_on_hold) {
        for (int i = 0; i < 3; ++i) by.handle[i] = clutch_offset(follows.handle[i], device.handle[i]);
        by.roll = clutch_offset(follows.roll, device.roll);
    }
    follows = device;
    for (int i = 0; i < 3; ++i) follows.handle[i] = clutched(follows.handle[i], by.handle[i]);
    follows.roll = clutched(follows.roll, by.roll);
}

/// During a pause or a loss the instruments stay where they are.
void HapticLoop::Parts::move_instruments(const RigSample& input) noexcept {
    const bool was_on_hold = on_hold;
    on_hold = (input.flags & (rig_paused | rig_device_lost)) != 0U;
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!has_hand[hand]) continue;
        if (!on_hold) follow_device(hand, input.hand[hand], was_on_hold);
        tool[hand] = step_instrument(contact[hand].instrument, held[hand], instrument[hand]);
        moved[hand] = (tool[hand].tip - tip_before[hand]).norm();
        tip_before[hand] = tool[hand].tip;
    }
    if (has_camera) camera = scope_pose(scope, input.camera);
}

/// Contact of each instrument with tissue, then of the instruments with each other.
void HapticLoop::Parts::find_contacts(std::uint32_t tick) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        state_before[hand] = state[hand];
        if (has_hand[hand])
            step_tool_contact(contact[hand], models[current].hand[hand], tool[hand], tick, state[hand],
                              scratch[hand], result[hand]);
    }
    if (has_hand[0] && has_hand[1])
        collide_tools(contact[0], tool[0], contact[1], tool[1], pair, result[0], result[1]);
}

/// N, by which a hand's force can have changed by the hands' motion since the last tick: what it touches
/// gives at most its slope, with that of dampers that come in with the depth.
double HapticLoop::Parts::explained(int hand) noexcept {
    const double stiffness = result[hand].stiffness.trace(), damping = result[hand].damping;
    const Vector3& velocity = tool[hand].tip_velocity;
    const double slope = stiffness + damping * velocity.norm() / contact[hand].onset_depth;
    const double other = result[hand].touching_tool ? moved[1 - hand] : 0.0;
    const double by_motion = std::max(slope, slope_before[hand]) * moved[hand] + shaft_stiffness * other +
                             damping * (velocity - velocity_before[hand]).norm();
    slope_before[hand] = slope;
    velocity_before[hand] = velocity;
    return by_motion + unexplained;
}

SafetyInput HapticLoop::Parts::safety_input(int hand, std::uint32_t tick) noexcept {
    SafetyInput safety_of_hand;
    safety_of_hand.force = -result[hand].force;
    safety_of_hand.model_changed = swapped;
    if (swapped) {
        // What the old model gives at this pose, from its own state: the current state is the new model's.
        ToolContactState old_state = state_before[hand];
        step_tool_contact(contact[hand], models[1 - current].hand[hand], tool[hand], tick, old_state,
                          scratch[hand], old_result);
        safety_of_hand.old_force = -(old_result.force + result[hand].tool_force);
    }
    safety_of_hand.model_age = result[hand].age;
    safety_of_hand.connected = !on_hold && tool[hand].present;
    safety_of_hand.explained = explained(hand);
    limit_stiffness(hand, safety_of_hand);
    return safety_of_hand;
}

/// Eq. 8: where the model is stiffer than the device can render stably, the device gets a reduced model's
/// force: the same direction, the size that the bound allows.
void HapticLoop::Parts::limit_stiffness(int hand, SafetyInput& of_hand) noexcept {
    const double b = device_damping[hand];
    if (!(b >= 0) || !(result[hand].stiffness.trace() > 0)) return;
    const double stiffest = result[hand].stiffness.diagonal().maxCoeff();
    const PassivityCheck check = check_passivity(stiffest, result[hand].damping, b, limits.tick_period);
    if (!check.limited) return;
    of_hand.force *= check.stiffness / std::max(1e-9, stiffest);
    of_hand.old_force *= check.stiffness / std::max(1e-9, stiffest);
    limited |= 1U << static_cast<unsigned>(hand);
}

void HapticLoop::Parts::record_hand(int hand, const RigSample& input, const SafetyOutput& sent,
                                    HandSample& record) noexcept {
    const ToolContactResult& touched = result[hand];
    const ToolKinematics& pose = tool[hand];
    const LocalModel& local = models[current].hand[hand];
    store(pose.tip, sample_length_unit, record.tip);
    store(pose.axis, sample_axis_unit, record.axis);
    record.roll = counts(pose.roll, sample_angle_unit);
    record.jaw_angle = counts(pose.jaw_angle, sample_angle_unit);
    // Without the force between the instruments, which acts on no tissue.
    store(touched.force - touched.tool_force, sample_force_unit, record.force);
    store(touched.torque, sample_torque_unit, record.torque);
    store(output.device_force[hand], sample_force_unit, record.device_force);
    record.tissue = touched.tissue;
    record.patch = touched.tissue_patch;
    record.filter_grade = static_cast<std::uint16_t>(touched.grade);
    unsigned flags = 0;
    if (pose.inside) flags |= hand_inside;
    if (has_camera && in_view(camera, pose.tip)) flags |= hand_in_view;
    if ((pose.buttons & button_energy) != 0 && local.energises) flags |= hand_energy;
    if ((sent.flags & safety_clamped) != 0) flags |= hand_clamped;
    if (input.hand[hand].faulty != 0) flags |= hand_faulty;
    if (touched.cutting) flags |= hand_cutting;
    if (local.mode == LocalMode::grasp) {
        flags |= hand_grasping;
        record_grasp(hand, record);
    }
    record.flags = static_cast<std::uint16_t>(flags);
}

void HapticLoop::Parts::record_grasp(int hand, HandSample& record) noexcept {
    const LocalModel& local = models[current].hand[hand];
    record.jaw_force = counts(tool[hand].grip, sample_force_unit);
    record.jaw_area = counts(local.grasp.area, sample_area_unit);
    record.tissue = local.grasp.tissue;
    record.patch = local.grasp.tissue_patch;
}

void HapticLoop::Parts::record_camera(CameraSample& record) const noexcept {
    store(camera.position, sample_length_unit, record.tip);
    const Quaternion& q = camera.orientation;
    const double components[4] = {q.w(), q.x(), q.y(), q.z()};
    for (int i = 0; i < 4; ++i) record.orientation[i] = counts(components[i], sample_axis_unit);
}

HapticLoop::HapticLoop(const Scene& scene, const World& world) : parts_(std::make_unique<Parts>()) {
    Parts& parts = *parts_;
    parts.scene = scene;
    parts.limits.force = scene.force_limit;
    parts.limits.slew = scene.slew_limit;
    parts.limits.tick_period = scene.tick_period();
    for (const InstrumentSpec& spec : scene.instruments) {
        const int hand = static_cast<int>(spec.hand);
        ToolContactModel& contact = parts.contact[hand];
        parts.has_hand[hand] = true;
        contact = make_tool_contact(scene, make_instrument(spec, scene.tick_period()));
        contact.cavity = world.wall();
        if (const int index = scene.wall_tissue(); index >= 0) {
            contact.wall.tissue = static_cast<std::int16_t>(index);
            contact.wall.most_stiffness = scene.tissues[static_cast<std::size_t>(index)].stiffness;
            contact.wall.damping = scene.tissues[static_cast<std::size_t>(index)].damping;
        }
        parts.held[hand] = start_sample(spec.trocar, spec.start_insertion);
    }
    if (scene.camera) {
        parts.has_camera = true;
        parts.scope = make_scope(*scene.camera);
    }
    parts.models[0] = world.local_models();
    parts.models[1] = parts.models[0];
}

HapticLoop::~HapticLoop() = default;

void HapticLoop::set_device_damping(Hand hand, double damping) {
    parts_->device_damping[static_cast<int>(hand)] = damping;
}

void HapticLoop::adopt(const LocalModels& models) noexcept {
    Parts& parts = *parts_;
    parts.current = 1 - parts.current;
    parts.models[parts.current] = models;
    parts.swapped = true;
    for (const LocalModel& model : models.hand) parts.model_step = std::max(parts.model_step, model.step);
}

std::uint32_t HapticLoop::model_step() const noexcept {
    return parts_->model_step;
}

unsigned HapticLoop::take_stability_limited() noexcept {
    const unsigned limited = parts_->limited;
    parts_->limited = 0;
    return limited;
}

void HapticLoop::transfer(StateArchive& archive, const World& world) {
    Parts& parts = *parts_;
    archive(parts.models, parts.current, parts.swapped, parts.model_step, parts.instrument, parts.tool,
            parts.state, parts.state_before, parts.pair, parts.camera, parts.tip_before,
            parts.velocity_before, parts.moved, parts.slope_before, parts.safety, parts.passivity, parts.held,
            parts.offset, parts.on_hold, parts.result, parts.limited, parts.output);
    if (!archive.reads()) return;
    for (LocalModels& models : parts.models) world.point_to_wall(models);
}

const RigSample& HapticLoop::last_input() const noexcept {
    return parts_->output.input;
}

void HapticLoop::clutch_in() noexcept {
    parts_->on_hold = true;
    for (SafetyState& safety : parts_->safety) safety = SafetyState();
    for (PassivityController& passivity : parts_->passivity) passivity = PassivityController();
}

const TickOutput& HapticLoop::tick(const RigSample& input) noexcept {
    Parts& parts = *parts_;
    TickOutput& output = parts.output;
    output.input = input;
    TickSample& sample = output.sample;
    sample = TickSample{};
    sample.tick = input.tick;
    sample.rig_flags = input.flags;
    sample.model_step = parts.model_step;

    parts.move_instruments(input);
    parts.find_contacts(input.tick);
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!parts.has_hand[hand]) continue;
        const SafetyOutput sent =
            step_safety(parts.limits, parts.safety_input(hand, input.tick), parts.safety[hand]);
        output.device_force[hand] = sent.force;
        if (parts.scene.passivity_control)
            output.device_force[hand] = parts.passivity[hand].step(sent.force, parts.tool[hand].tip_velocity,
                                                                   parts.limits.tick_period);

        ContactReport& contact = output.contact[hand];
        contact.tool = parts.tool[hand];
        contact.vertex = parts.result[hand].vertex;
        contact.slipping = parts.result[hand].slipping;
        parts.record_hand(hand, input, sent, sample.hand[hand]);
    }
    if (parts.has_camera) parts.record_camera(sample.camera);
    parts.swapped = false;
    return output;
}

}  // namespace fulcrum
