// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haptics/loop.h"

#include <algorithm>
#include <cmath>

#include "sim_core/haptics/clutch.h"
#include "sim_core/haptics/hand_output.h"
#include "sim_core/numerics/state_archive.h"
#include "sim_core/world/world.h"

namespace fulcrum {
namespace {

constexpr double limited_again = 1.0;  // s without a reduction after which the next one is an event again

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
    Vector3 tip_before[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    double moved[hand_count] = {0, 0};  // m, displacement of a tip since the tick before
    HandOutput sends[hand_count];
    std::uint32_t free_ticks[hand_count] = {0, 0};  // since Eq. 8 last reduced the model
    DeviceSample held[hand_count];    // what the instruments follow: the devices except in pauses and losses
    DeviceSample offset[hand_count];  // clutch: added to the device after a resume
    bool on_hold = false;             // in a pause or while a device is lost
    ToolContactScratch scratch[hand_count];
    ToolContactResult result[hand_count], old_result;
    TickOutput output;

    void follow_device(int hand, const DeviceSample& device, bool was_on_hold) noexcept;
    void move_instruments(const RigSample& input) noexcept;
    void find_contacts(std::uint32_t tick) noexcept;
    HandForce force_for_hand(int hand, const RigSample& input) noexcept;
    void report_limit(int hand, const HandForce& sent) noexcept;
    void record_hand(int hand, const RigSample& input, const HandForce& sent, HandSample& record) noexcept;
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

/// Contact of each instrument with tissue, then of the instruments with each other. On hold nothing moves,
/// and time does not pass for a contact either: otherwise depth that a hold left in would become contact
/// depth in a pause, and the first tick after it would push with all of it.
void HapticLoop::Parts::find_contacts(std::uint32_t tick) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        state_before[hand] = state[hand];
        if (has_hand[hand])
            step_tool_contact(contact[hand], models[current].hand[hand], tool[hand], tick, state[hand],
                              scratch[hand], result[hand]);
        if (on_hold) state[hand] = state_before[hand];
    }
    if (has_hand[0] && has_hand[1])
        collide_tools(contact[0], tool[0], contact[1], tool[1], pair, result[0], result[1]);
}

HandForce HapticLoop::Parts::force_for_hand(int hand, const RigSample& input) noexcept {
    if (!sends[hand].has_device()) return {};
    const ToolKinematics& pose = tool[hand];
    const InstrumentModel& held_tool = contact[hand].instrument;
    HandTick now;
    now.handle = handle_of(held_tool, pose);
    const std::int32_t* device = input.hand[hand].handle;
    now.device = held_tool.trocar.rotation * (device_length_unit * Vector3(device[0], device[1], device[2]));
    now.load = result[hand].tissue_load;
    now.load.add(result[hand].tool_load);
    now.model_changed = swapped;
    if (swapped) {
        // What the old model gives at this pose, from its own state: the current state is the new model's.
        ToolContactState old_state = state_before[hand];
        step_tool_contact(contact[hand], models[1 - current].hand[hand], pose, input.tick, old_state,
                          scratch[hand], old_result);
        now.old_load = old_result.tissue_load;
        now.old_load.add(result[hand].tool_load);
    }
    now.model_age = result[hand].age;
    // A hand that moves its device elsewhere with the clutch feels nothing; the force comes back slowly.
    now.connected = !on_hold && pose.present && (input.hand[hand].buttons & button_clutch) == 0;
    if (result[hand].touching_tool) now.carried = moved[1 - hand];
    return sends[hand].step(now);
}

/// The first tick of a reduction by Eq. 8 is reported, so that one contact makes one event.
void HapticLoop::Parts::report_limit(int hand, const HandForce& sent) noexcept {
    const auto pause = static_cast<std::uint32_t>(limited_again / scene.tick_period());
    StabilityLimit& report = output.limited[hand];
    report.limited = sent.limited && free_ticks[hand] >= pause;
    report.stiffness = static_cast<float>(sent.stiffness);
    free_ticks[hand] = sent.limited ? 0 : std::min(free_ticks[hand] + 1, pause);
}

void HapticLoop::Parts::record_hand(int hand, const RigSample& input, const HandForce& sent,
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
    SafetyLimits limits;
    limits.force = scene.force_limit;
    limits.slew = scene.slew_limit;
    limits.tick_period = scene.tick_period();
    for (HandOutput& sends : parts.sends) sends = HandOutput(limits, scene.passivity_control);
    for (std::uint32_t& ticks : parts.free_ticks)
        ticks = static_cast<std::uint32_t>(limited_again / scene.tick_period());
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

void HapticLoop::set_device(Hand hand, const std::optional<ForceOutput>& device) {
    parts_->sends[static_cast<int>(hand)].set_device(device);
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

void HapticLoop::transfer(StateArchive& archive, const World& world) {
    Parts& parts = *parts_;
    archive(parts.models, parts.current, parts.swapped, parts.model_step, parts.instrument, parts.tool,
            parts.state, parts.state_before, parts.pair, parts.camera, parts.tip_before, parts.moved,
            parts.sends, parts.free_ticks, parts.held, parts.offset, parts.on_hold, parts.result,
            parts.output);
    if (!archive.reads()) return;
    for (LocalModels& models : parts.models) world.point_to_wall(models);
}

const RigSample& HapticLoop::last_input() const noexcept {
    return parts_->output.input;
}

const DeviceSample& HapticLoop::held(Hand hand) const noexcept {
    return parts_->held[static_cast<int>(hand)];
}

void HapticLoop::clutch_in() noexcept {
    parts_->on_hold = true;
    for (HandOutput& sends : parts_->sends) sends.restart();
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
        const HandForce sent = parts.force_for_hand(hand, input);
        output.device_force[hand] = sent.force;
        output.device_torque[hand] = sent.torque;
        parts.report_limit(hand, sent);

        ContactReport& contact = output.contact[hand];
        contact.tool = parts.tool[hand];
        contact.vertex = parts.result[hand].vertex;
        contact.slipping = parts.result[hand].slipping;
        contact.touches = parts.result[hand].touches;
        parts.record_hand(hand, input, sent, sample.hand[hand]);
    }
    if (parts.has_camera) parts.record_camera(sample.camera);
    parts.swapped = false;
    return output;
}

}  // namespace fulcrum
