// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/device_rig.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "app/live/device_watch.h"
#include "sim_core/instrument/mouse_mapping.h"

namespace fulcrum::app {
namespace {

// Two clocks of 1 kHz meet with a few ticks of delay; a device that is silent for longer did not answer.
constexpr int late_ticks = 5;
// The overseer says that it runs every 5 ms.
constexpr int overseer_ticks = 100;
constexpr double us_in_ns = 1e-3;

/// us. Another process wrote the times: their difference may not fit into an integer.
double us_between(std::int64_t earlier, std::int64_t later) {
    return us_in_ns * (static_cast<double>(later) - static_cast<double>(earlier));
}

}  // namespace

DeviceRig::DeviceRig(std::shared_ptr<const void> owner, const StatePage& state, CommandPage& command,
                     const DeviceFacts& facts, const Scene& scene, std::shared_ptr<Rig> others,
                     const SlotUse& use, double scale)
    : owner_(std::move(owner)),
      state_(state),
      command_(command),
      others_(std::move(others)),
      motion_(use.motion),
      stated_rate_(facts.rate),
      pedal_(use.pedal),
      has_pedal_(use.pedal >= 0 && use.pedal < device_slots && facts.slot[use.pedal]),
      device_period_(static_cast<std::int64_t>(1e9 / facts.rate)) {
    state_.loop.read(loop_at_begin_);
    const int slots[device_slots] = {use.left, use.right, use.scope};
    for (int i = 0; i < device_slots; ++i) {
        Driven& driven = driven_[i];
        // Commands of an attempt before are older.
        if (i < hand_count) sent_[i].sequence = static_cast<std::uint64_t>(rendered_[i] = monotonic_ns());
        driven.slot = slots[i] >= 0 && slots[i] < device_slots && facts.slot[slots[i]] ? slots[i] : -1;
        if (i == scope_slot) {
            driven.exists = scene.camera.has_value();
            if (driven.exists) {
                driven.trocar = make_trocar(scene.camera->trocar);
                driven.start =
                    start_reading(scene.camera->trocar.shaft_length, scene.camera->start_insertion, 0);
            }
            continue;
        }
        const InstrumentSpec* const spec = scene.instrument(static_cast<Hand>(i));
        driven.exists = spec != nullptr;
        if (!driven.exists) continue;
        driven.trocar = make_trocar(spec->trocar);
        driven.opening = spec->jaw_opening;
        driven.grip = spec->grip_force;
        driven.start = start_reading(spec->trocar.shaft_length, spec->start_insertion,
                                     spec->jaw_opening * open_jaw_share);
        if (driven.slot < 0 || driven.slot >= hand_count) continue;
        if (const auto& force = facts.force[driven.slot]) {
            driven.has_force = true;
            force_[i] = *force;
            force_[i]->scale = scale;
            force_[i]->damping /= motion_ * motion_;
            force_[i]->stiffness /= motion_ * motion_;
            force_[i]->peak /= motion_;
            force_[i]->continuous /= motion_;
            if (motion_ > 1) force_[i]->slew = scene.slew_limit / motion_;
        }
    }
    for (Driven& driven : driven_) {  // until it answers its instrument is where it begins
        driven.last = quantise(driven.start, {});
        driven.last.present = 0;
    }
}

std::optional<ForceOutput> DeviceRig::force_output(Hand hand) const {
    return force_[static_cast<std::size_t>(hand)];
}

std::optional<RigUse> DeviceRig::use() const {
    RigUse use;
    const bool moves = std::any_of(std::begin(driven_), std::end(driven_),
                                   [](const Driven& driven) { return driven.exists && driven.slot >= 0; });
    if (!moves) {
        use = others_->use().value_or(use);
        if (has_pedal_) use.pedal = pedal_;
        return use;
    }
    use.stated = stated_rate_;
    use.motion = motion_;
    use.pedal = pedal_;
    for (std::size_t i = 0; i < use.part.size(); ++i) {
        if (driven_[i].exists) use.part[i] = driven_[i].slot;
        use.measured = std::max(use.measured, driven_[i].meter.rate());
    }
    return use;
}

double DeviceRig::damping(Hand hand) const {
    const auto& force = force_[static_cast<std::size_t>(hand)];
    return force ? force->damping : -1;
}

void DeviceRig::see_daemon() noexcept {
    const std::int64_t time = state_.overseer_time.load(std::memory_order_relaxed);
    overseer_same_ = time != overseer_time_ ? 0 : std::min(overseer_same_ + 1, overseer_ticks + 1);
    overseer_time_ = time;
    state_.fault.read(fault_);
}

DeviceTiming DeviceRig::timing() const {
    DeviceTiming timing;
    timing.pose_age = pose_age_.read();
    timing.force_delay = force_delay_.read();
    timing.jitter = jitter_.read();
    LoopReport loop = loop_at_begin_;
    state_.loop.read(loop);
    timing.device_ticks = loop.ticks - loop_at_begin_.ticks;
    timing.device_late = loop.late - loop_at_begin_.late;
    timing.device_late_own = loop.late_own - loop_at_begin_.late_own;
    timing.real_time_priority = loop.real_time != 0;
    return timing;
}

void DeviceRig::see_force(int hand) noexcept {
    ForceReport report;
    if (!force_[hand] || !state_.report[driven_[hand].slot].read(report) ||
        report.command_time <= rendered_[hand])
        return;
    rendered_[hand] = report.command_time;
    force_delay_.add(us_between(report.command_time, report.time));
}

void DeviceRig::read_slot(Driven& driven, bool is_scope, std::int64_t now, DeviceSample& sample) noexcept {
    DevicePose pose = driven.newest;
    const bool got = state_.pose[driven.slot].read(pose);
    driven.same =
        got && pose.sequence != driven.newest.sequence ? 0 : std::min(driven.same + 1, late_ticks + 1);
    if (got && pose.sequence > driven.newest.sequence) {
        const std::uint64_t more = pose.sequence - driven.newest.sequence;
        driven.meter.add(static_cast<int>(std::min<std::uint64_t>(more, 1000)),
                         1e-9 * static_cast<double>(pose.time));
        pose_age_.add(us_between(pose.time, now));
        if (more == 1 && driven.newest.sequence != 0)
            jitter_.add(std::abs(us_between(driven.newest.time, pose.time) -
                                 us_in_ns * static_cast<double>(device_period_)));
    }
    driven.newest = pose;
    DeviceReading reading = driven.start;
    const Vector3 position(pose.position[0], pose.position[1], pose.position[2]);
    const bool present = answers(pose, driven.same) && !(driven.has_force && fault_.fault != 0);
    if (!driven.begun && present && position.allFinite() && std::isfinite(pose.roll)) {
        driven.begun = true;
        driven.origin = position;
        driven.roll_origin = pose.roll;
    }
    if (driven.begun) {
        reading.handle += motion_ * turned(position - driven.origin);
        reading.roll += pose.roll - driven.roll_origin;
        // The button for energy that is not the pedal is free for the clutch.
        if (pedal_ != -2 && driven.slot != pedal_ && (pose.buttons & button_energy) != 0)
            pose.buttons |= button_clutch;
        // Without an answer the clutch stays as it was; a place that is not a number changes nothing.
        if (reading.handle.allFinite() && std::isfinite(reading.roll))
            clutch(driven, present ? (pose.buttons & button_clutch) != 0 : driven.clutched, reading);
        const bool closed = !is_scope && (pose.jaw <= 0.05 || (pose.buttons & button_primary) != 0);
        reading.jaw = is_scope || closed ? 0 : std::min(pose.jaw, 1.0) * driven.opening;
        if (std::isnan(pose.jaw)) reading.jaw = pose.jaw;  // a faulty reading, as for the position
        reading.grip = closed ? driven.grip : 0;
        const unsigned jaws = closed ? unsigned{button_primary} : 0U;
        reading.buttons = static_cast<std::uint16_t>((pose.buttons & 0xfU) | jaws);
    }
    reading.present = present;
    // Away for longer the device is lost and the attempt on hold: it may be taken up anywhere. Between
    // readings that follow one another it cannot jump.
    const bool gives_a_place =
        present && reading.handle.allFinite() && std::isfinite(reading.roll) && std::isfinite(reading.jaw);
    if (gives_a_place && driven.away > DeviceWatchLimits().silent_ticks)
        std::fill(std::begin(driven.last.handle), std::end(driven.last.handle), 0);
    driven.away = gives_a_place ? 0 : std::min(driven.away + 1, DeviceWatchLimits().silent_ticks + 1);
    driven.last = quantise(reading, driven.last);
    sample = driven.last;
}

void DeviceRig::clutch(Driven& driven, bool pressed, DeviceReading& reading) const noexcept {
    if (pressed && !driven.clutched) {
        driven.stays = reading.handle;
        driven.stays_roll = reading.roll;
    }
    if (!pressed && driven.clutched) {
        // turned() is its own inverse.
        driven.origin += turned(reading.handle - driven.stays) / motion_;
        driven.roll_origin += reading.roll - driven.stays_roll;
    }
    if (pressed || driven.clutched) {
        reading.handle = driven.stays;
        reading.roll = driven.stays_roll;
    }
    driven.clutched = pressed;
}

void DeviceRig::add_keys(Driven& driven, bool is_scope, const DeviceSample& keys,
                         DeviceSample& sample) noexcept {
    if (!driven.keys_begun) {
        driven.keys_begun = true;
        driven.keys_roll = keys.roll;
        driven.keys_head = keys.jaw;
        driven.keys_hold = (keys.buttons & button_primary) != 0;
    }
    const auto add = [](std::int32_t& to, std::int32_t from, std::int32_t begun) {
        constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
        to = static_cast<std::int32_t>(std::clamp(std::int64_t{to} + from - begun, -most, most));
    };
    add(sample.roll, keys.roll, driven.keys_roll);
    if (is_scope) {
        add(sample.jaw, keys.jaw, driven.keys_head);
        return;
    }
    unsigned pressed = keys.buttons & unsigned{button_energy | button_exchange | button_primary};
    driven.keys_hold = driven.keys_hold && (pressed & button_primary) != 0;
    driven.took_over = driven.keys_hold && (driven.took_over || (sample.buttons & button_primary) != 0);
    if (driven.took_over) pressed &= ~unsigned{button_primary};
    sample.buttons = static_cast<std::uint16_t>(sample.buttons | pressed);
    if ((pressed & button_primary) == 0 || sample.faulty != 0) return;
    sample.jaw = 0;
    sample.grip = static_cast<std::int32_t>(std::lround(driven.grip / device_force_unit));
}

void DeviceRig::read(std::uint32_t tick, RigSample& sample) {
    others_->read(tick, sample);
    sample.tick = tick;
    see_daemon();
    const std::int64_t now = monotonic_ns();
    for (int h = 0; h < hand_count; ++h) see_force(h);
    DeviceSample* const samples[device_slots] = {&sample.hand[0], &sample.hand[1], &sample.camera};
    for (int i = 0; i < device_slots; ++i) {
        if (driven_[i].slot < 0 || !driven_[i].exists) continue;
        const DeviceSample keys = *samples[i];
        read_slot(driven_[i], i == scope_slot, now, *samples[i]);
        const unsigned own = samples[i]->buttons & (pedal_ == -2 ? ~0U : ~unsigned{button_energy});
        samples[i]->buttons = static_cast<std::uint16_t>(own);
        add_keys(driven_[i], i == scope_slot, keys, *samples[i]);
    }
    if (has_pedal_) read_pedal(sample);
}

bool DeviceRig::answers(const DevicePose& pose, int same) const noexcept {
    return pose.present != 0 && same <= late_ticks && overseer_same_ <= overseer_ticks;
}

void DeviceRig::read_pedal(RigSample& sample) noexcept {
    DevicePose pose = pedal_newest_;
    const bool got = state_.pose[pedal_].read(pose);
    pedal_same_ =
        got && pose.sequence != pedal_newest_.sequence ? 0 : std::min(pedal_same_ + 1, late_ticks + 1);
    pedal_newest_ = pose;
    const bool pressed = answers(pose, pedal_same_) && (pose.buttons & button_energy) != 0;
    for (int h = 0; h < hand_count && pressed; ++h)
        if (driven_[h].exists)
            sample.hand[h].buttons = static_cast<std::uint16_t>(sample.hand[h].buttons | button_energy);
}

void DeviceRig::write_force(Hand hand, const Vector3& force) {
    const auto h = static_cast<std::size_t>(hand);
    if (!force_[h]) return;
    const Vector3 on_device = motion_ * turned(driven_[h].trocar.rotation.transpose() * force);
    ForceCommand& command = sent_[h];
    ++command.sequence;
    command.time = monotonic_ns();
    for (int axis = 0; axis < 3; ++axis) command.force[axis] = on_device[axis];
    command_.command[driven_[h].slot].write(command);
}

void DeviceRig::write_torque(Hand hand, double torque) {
    sent_[static_cast<std::size_t>(hand)].torque = torque;  // goes with the next force
}

}  // namespace fulcrum::app
