// SPDX-License-Identifier: GPL-3.0-or-later
// The hands of a live attempt where fulcrum-hapticd drives their device: reads the newest pose from shared
// memory and writes the newest force there. What the device does not have (a scope, one of the hands) another
// rig moves; its turning, closed jaws and buttons are added to those of the device.
//
// Mapping: where the device is when it is read first is where the instrument begins; from there the handle
// follows the device, 1:1 unless a person chose another scale. Seen by the person the device's frame is that
// of the handle: to the right is -x of the trocar's frame, up is +y, away from the person is +z, into the
// body. With another scale of the movement m the device gets m times the force, so that the work is the same
// on both sides; seen from the instrument its damping and stiffness are those of the device over m^2, its
// forces over m, and so is the slew limit where m is above 1. While the clutch of a slot is pressed its
// instrument stays, without force, and the device is moved to a better place; the clutch is a button of the
// sample, so a replay has it too.
//
// While the overseer of the device gives no sign of itself, the force is 0 and the device counts as absent:
// an attempt does not continue without force. A fault of the device, also of a hand that nothing uses, takes
// the force from both hands: those that have force are absent until it has ended.
//
// Real-time loop: no lock, allocation, system call (but the clock) or exception.
#pragma once

#include <memory>

#include "app/live/loop_statistics.h"
#include "sim_core/devices/device_facts.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum::app {

/// What a device's slot moves.
struct SlotUse {
    int left = 0, right = 1, scope = scope_slot;  ///< slot of the device, or -1: the other rig moves it
    double motion = 1;                            ///< movement of an instrument over that of its device
    /// Slot whose button is the pedal for both hands; -1: the other rig's keys alone; -2: each hand has the
    /// button of its own slot.
    int pedal = -2;
};

class DeviceRig : public Rig {
  public:
    /// `owner` keeps `state` and `command` mapped. Slots that the device does not have are moved by `others`.
    /// `scale`: force sent over the model's, 0 < scale <= 1 per hand of the device.
    DeviceRig(std::shared_ptr<const void> owner, const StatePage& state, CommandPage& command,
              const DeviceFacts& facts, const Scene& scene, std::shared_ptr<Rig> others,
              const SlotUse& use = {}, double scale = 1);

    void read(std::uint32_t tick, RigSample& sample) override;
    void write_force(Hand hand, const Vector3& force) override;
    void write_torque(Hand hand, double torque) override;
    bool has_force(Hand hand) const override { return force_output(hand).has_value(); }
    double damping(Hand hand) const override;
    std::optional<ForceOutput> force_output(Hand hand) const override;
    std::optional<RigUse> use() const override;
    /// Since this rig was made. Any thread.
    DeviceTiming timing() const;
    /// The trocar's frame from the device's: a half turn about y.
    static Vector3 turned(const Vector3& v) { return {-v.x(), v.y(), -v.z()}; }

  private:
    struct Driven {
        int slot = -1;
        bool exists = false, begun = false, has_force = false;
        Trocar trocar;
        DeviceReading start;  // where the instrument begins
        double opening = 1, grip = 0;
        Vector3 origin = Vector3::Zero();  // device position that is the start
        double roll_origin = 0;
        DevicePose newest;
        RateMeter meter;
        int same = 0;            // ticks since a new reading
        std::uint32_t away = 0;  // ticks since it gave a place
        DeviceSample last;
        /// While its clutch is pressed the instrument stays where it was.
        bool clutched = false;
        Vector3 stays = Vector3::Zero();
        double stays_roll = 0;
        bool keys_begun = false;
        std::int32_t keys_roll = 0, keys_head = 0;  ///< of the other rig at its first tick
        /// Its jaws are closed since then: jaws that held where the attempt began.
        bool keys_hold = false;
        bool took_over = false;  ///< the device closed its own jaws while they held
    };
    void see_daemon() noexcept;
    void read_slot(Driven& driven, bool is_scope, std::int64_t now, DeviceSample& sample) noexcept;
    void see_force(int hand) noexcept;
    void clutch(Driven& driven, bool pressed, DeviceReading& reading) const noexcept;
    /// The keys of turning, jaws, pedal and exchange work with every device: for what it cannot do.
    static void add_keys(Driven& driven, bool is_scope, const DeviceSample& keys,
                         DeviceSample& sample) noexcept;

    std::shared_ptr<const void> owner_;
    const StatePage& state_;
    CommandPage& command_;
    std::shared_ptr<Rig> others_;
    /// Of a slot whose newest reading is `pose`, for `same` ticks.
    bool answers(const DevicePose& pose, int same) const noexcept;
    /// One that does not answer is not pressed.
    void read_pedal(RigSample& sample) noexcept;
    double motion_, stated_rate_;
    int pedal_;
    bool has_pedal_;
    DevicePose pedal_newest_;
    int pedal_same_ = 0;           // ticks since a new reading
    Driven driven_[device_slots];  // left, right, scope
    std::int64_t overseer_time_ = -1;
    int overseer_same_ = 0;  // ticks since it last said that it runs
    FaultReport fault_;
    std::optional<ForceOutput> force_[hand_count];
    ForceCommand sent_[hand_count];
    std::int64_t rendered_[hand_count] = {0, 0};  ///< ns, time of the command that was rendered last
    std::int64_t device_period_;                  ///< ns
    LoopReport loop_at_begin_;
    DurationHistogram pose_age_, force_delay_, jitter_;
};

}  // namespace fulcrum::app
