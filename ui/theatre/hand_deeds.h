// SPDX-License-Identifier: GPL-3.0-or-later
// What the hands did in an attempt, by the readings of their devices: every kind of device alike. From it the
// theatre marks which of its first steps a person has done.
#pragma once

#include <array>
#include <atomic>
#include <bitset>
#include <memory>

#include "sim_core/instrument/device.h"
#include "sim_core/scene/scene.h"

namespace fulcrum::ui {

/// In the order in which they are taught. Of a scene whose only instrument is the scope: scope_moved,
/// inserted, post_turned, head_turned.
enum class HandDeed : std::uint8_t {
    moved,        ///< a hand across its shaft; where each hand has a handle of its own, both
    other_hand,   ///< both hands moved, where one mouse moves the one or the other
    inserted,     ///< in or out
    rolled,       ///< turned about the shaft
    jaws_closed,  ///< after they were open
    pedal,        ///< of a hand whose instrument has one
    exchanged,    ///< of a hand that has several instruments
    scope_moved,
    post_turned,
    head_turned,
    clutched  ///< of a device whose clutch is a button
};
inline constexpr std::size_t hand_deed_count = 11;
using HandDeeds = std::bitset<hand_deed_count>;
constexpr std::size_t bit_of(HandDeed deed) {
    return static_cast<std::size_t>(deed);
}

/// What can be done in a scene and changes something there. `one_mouse`: it moves the one hand or the other.
/// What only the device has (clutched) is not among it.
HandDeeds needed_deeds(const Scene& scene, bool one_mouse);
/// An instrument of this hand has a pedal (energy, suction).
bool uses_pedal(const Scene& scene, Hand hand);
/// It is one of several that this hand takes.
bool uses_exchange(const Scene& scene, Hand hand);

/// Sees the readings on the haptic thread: no lock, allocation or exception. The rest is for any thread.
class HandWatch {
  public:
    explicit HandWatch(const Scene& scene);
    void see(const RigSample& sample) noexcept;
    /// Done since it was made or restart() was called.
    HandDeeds done(bool one_mouse) const;
    /// Rises when a hand moves by more than one that rests, or uses a button: somebody is there. Any thread.
    std::uint32_t uses() const { return uses_.load(std::memory_order_relaxed); }
    /// Forgets what was done, from the next reading on.
    void restart() { restarts_.fetch_add(1, std::memory_order_relaxed); }

  private:
    struct Part {
        bool exists = false, has_jaws = false, has_pedal = false, has_exchange = false;
        double opening = 1;
        bool begun = false, was_open = false;
        DeviceSample first;
        std::uint32_t mask = 0;
        bool marked = false;
        DeviceSample mark;  ///< at the last use
    };
    bool is_use(Part& part, const DeviceSample& sample) noexcept;
    void see_part(Part& part, const DeviceSample& sample) noexcept;

    std::array<Part, hand_count + 1> part_;  ///< left, right, scope
    std::array<std::atomic<std::uint32_t>, hand_count + 1> done_;
    std::atomic<std::uint32_t> restarts_{0}, seen_restarts_{0}, uses_{0};
    bool scope_alone_ = false;
};

/// Passes on another rig, whose readings `watch` sees.
class WatchedRig : public Rig {
  public:
    WatchedRig(std::shared_ptr<Rig> rig, std::shared_ptr<HandWatch> watch)
        : rig_(std::move(rig)), watch_(std::move(watch)) {}
    void read(std::uint32_t tick, RigSample& sample) override {
        rig_->read(tick, sample);
        watch_->see(sample);
    }
    void write_force(Hand hand, const Vector3& force) override { rig_->write_force(hand, force); }
    void write_torque(Hand hand, double torque) override { rig_->write_torque(hand, torque); }
    bool has_force(Hand hand) const override { return rig_->has_force(hand); }
    double damping(Hand hand) const override { return rig_->damping(hand); }
    std::optional<ForceOutput> force_output(Hand hand) const override { return rig_->force_output(hand); }
    std::optional<RigUse> use() const override { return rig_->use(); }

  private:
    std::shared_ptr<Rig> rig_;
    std::shared_ptr<HandWatch> watch_;
};

}  // namespace fulcrum::ui
