// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haptics/loop.h"

#include <algorithm>
#include <cmath>

#include "sim_core/contact/jaws.h"
#include "sim_core/haptics/clutch.h"
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
    Vector3 tip_before[hand_count] = {Vector3::Zero(), Vector3::Zero()},
            velocity_before[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    double way[hand_count] = {0, 0};           // m, of a tip since the tick before
    double slope_before[hand_count] = {0, 0};  // N/m, of what a hand touched
    SafetyState safety[hand_count];
    PassivityController passivity[hand_count];
    DeviceSample held[hand_count];    // what the instruments follow: the devices but for pauses and losses
    DeviceSample offset[hand_count];  // clutch: added to the device after a resume
    bool was_held = false;
    ToolContactScratch scratch[hand_count];
    ToolContactResult result[hand_count], old_result;
    unsigned limited = 0;
    TickOutput output;

    /// N, by which a hand's force can have changed by the hands' motion since the last tick: what it touches
    /// gives at most its slope, with that of dampers that come in with the depth.
    double explained(int hand) {
        const double stiffness = result[hand].stiffness.trace(), damping = result[hand].damping;
        const Vector3& velocity = tool[hand].tip_velocity;
        const double slope = stiffness + damping * velocity.norm() / contact[hand].onset_depth;
        const double other = result[hand].touching_tool ? way[1 - hand] : 0.0;
        const double by_motion = std::max(slope, slope_before[hand]) * way[hand] + shaft_stiffness * other +
                                 damping * (velocity - velocity_before[hand]).norm();
        slope_before[hand] = slope;
        velocity_before[hand] = velocity;
        return by_motion + unexplained;
    }
};

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
        if (scene.cavity || scene.bands || scene.presacral) {
            const int index = scene.tissue_index(scene.cavity      ? scene.cavity->tissue
                                                 : scene.presacral ? scene.presacral->tissue
                                                                   : scene.bands->bed_tissue);
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

unsigned HapticLoop::take_stability_limited() noexcept {
    const unsigned limited = parts_->limited;
    parts_->limited = 0;
    return limited;
}

const TickOutput& HapticLoop::tick(const RigSample& input) noexcept {
    Parts& parts = *parts_;
    const LocalModels& models = parts.models[parts.current];
    const LocalModels& before = parts.models[1 - parts.current];
    TickOutput& output = parts.output;
    output.input = input;
    TickSample& sample = output.sample;
    sample = TickSample{};
    sample.tick = input.tick;
    sample.rig_flags = input.flags;
    sample.model_step = parts.model_step;

    // 1. Hands: during a pause or a loss the instruments stay where they are; afterwards the device is
    // clutched in where it stands.
    const bool on_hold = (input.flags & (rig_paused | rig_device_lost)) != 0U;
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!parts.has_hand[hand]) continue;
        const DeviceSample& device = input.hand[hand];
        DeviceSample& held = parts.held[hand];
        if (!on_hold) {
            if (parts.was_held) {
                for (int i = 0; i < 3; ++i)
                    parts.offset[hand].handle[i] = clutch_offset(held.handle[i], device.handle[i]);
                parts.offset[hand].roll = clutch_offset(held.roll, device.roll);
            }
            const DeviceSample& offset = parts.offset[hand];
            held = device;
            for (int i = 0; i < 3; ++i) held.handle[i] = clutched(held.handle[i], offset.handle[i]);
            held.roll = clutched(held.roll, offset.roll);
        }
        parts.tool[hand] = step_instrument(parts.contact[hand].instrument, held, parts.instrument[hand]);
        parts.way[hand] = (parts.tool[hand].tip - parts.tip_before[hand]).norm();
        parts.tip_before[hand] = parts.tool[hand].tip;
    }
    parts.was_held = on_hold;

    // 2. Contact of each hand, then of the instruments with each other.
    for (int hand = 0; hand < hand_count; ++hand) {
        parts.state_before[hand] = parts.state[hand];
        if (parts.has_hand[hand])
            step_tool_contact(parts.contact[hand], models.hand[hand], parts.tool[hand], input.tick,
                              parts.state[hand], parts.scratch[hand], parts.result[hand]);
    }
    if (parts.has_hand[0] && parts.has_hand[1]) {
        collide_tools(parts.contact[0], parts.tool[0], parts.contact[1], parts.tool[1], parts.pair,
                      parts.result[0], parts.result[1]);
    }

    CameraPose camera;
    if (parts.has_camera) camera = scope_pose(parts.scope, input.camera);

    // 3. Safety, then the record.
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!parts.has_hand[hand]) continue;
        const ToolContactResult& result = parts.result[hand];
        const ToolKinematics& tool = parts.tool[hand];
        const LocalModel& local = models.hand[hand];

        SafetyInput safety;
        safety.force = -result.force;
        safety.model_changed = parts.swapped;
        if (parts.swapped) {
            // The old model's answer at this pose, from what it remembered; what is remembered now is the new
            // one's.
            ToolContactState state = parts.state_before[hand];
            step_tool_contact(parts.contact[hand], before.hand[hand], tool, input.tick, state,
                              parts.scratch[hand], parts.old_result);
            safety.old_force = -(parts.old_result.force + result.tool_force);
        }
        safety.model_age = result.age;
        safety.connected = !on_hold && tool.present;
        safety.explained = parts.explained(hand);
        const double b = parts.device_damping[hand];
        if (b >= 0 && result.stiffness.trace() > 0) {
            const PassivityCheck check = check_passivity(result.stiffness.diagonal().maxCoeff(),
                                                         result.damping, b, parts.limits.tick_period);
            if (check.limited) {
                // The device renders the reduced model: the same direction, the size that the bound allows.
                safety.force *= check.stiffness / std::max(1e-9, result.stiffness.diagonal().maxCoeff());
                safety.old_force *= check.stiffness / std::max(1e-9, result.stiffness.diagonal().maxCoeff());
                parts.limited |= 1U << static_cast<unsigned>(hand);
            }
        }
        const SafetyOutput sent = step_safety(parts.limits, safety, parts.safety[hand]);
        Vector3 device_force = sent.force;
        if (parts.scene.passivity_control) {
            device_force =
                parts.passivity[hand].step(sent.force, tool.tip_velocity, parts.limits.tick_period);
        }
        output.device_force[hand] = device_force;

        ContactReport& contact = output.contact[hand];
        contact.tool = tool;
        contact.vertex = result.vertex;
        contact.slipping = result.slipping;

        HandSample& record = sample.hand[hand];
        store(tool.tip, sample_length_unit, record.tip);
        store(tool.axis, sample_axis_unit, record.axis);
        record.roll = counts(tool.roll, sample_angle_unit);
        record.jaw_angle = counts(tool.jaw_angle, sample_angle_unit);
        store(result.force - result.tool_force, sample_force_unit,
              record.force);  // instruments that cross hurt no tissue
        store(result.torque, sample_torque_unit, record.torque);
        store(device_force, sample_force_unit, record.device_force);
        record.tissue = result.tissue;
        record.patch = result.tissue_patch;
        record.filter_grade = static_cast<std::uint16_t>(result.grade);
        unsigned flags = 0;
        if (tool.inside) flags |= hand_inside;
        if (parts.has_camera && in_view(camera, tool.tip)) flags |= hand_in_view;
        if ((tool.buttons & button_energy) != 0 && local.energises) flags |= hand_energy;
        if ((sent.flags & safety_clamped) != 0) flags |= hand_clamped;
        if (input.hand[hand].faulty != 0) flags |= hand_faulty;
        if (result.cutting) flags |= hand_cutting;
        if (local.mode == LocalMode::grasp) {
            flags |= hand_grasping;
            record.jaw_force = counts(tool.grip, sample_force_unit);
            const JawContact jaws =
                find_jaw_contact(parts.contact[hand].instrument, tool, std::max(tool.jaw_angle, 0.25), local,
                                 input.tick, parts.scratch[hand]);
            record.jaw_area = counts(std::max({jaws.area, local.grasp.area, 1e-6}), sample_area_unit);
            record.tissue = local.grasp.tissue;
            record.patch = local.grasp.tissue_patch;
        }
        record.flags = static_cast<std::uint16_t>(flags);
    }
    if (parts.has_camera) {
        store(camera.position, sample_length_unit, sample.camera.tip);
        const Quaternion& q = camera.orientation;
        const double components[4] = {q.w(), q.x(), q.y(), q.z()};
        for (int i = 0; i < 4; ++i) sample.camera.orientation[i] = counts(components[i], sample_axis_unit);
    }
    parts.swapped = false;
    return output;
}

}  // namespace fulcrum
