// SPDX-License-Identifier: GPL-3.0-or-later
// Counters of a program that will be killed, in shared memory: readable after the kill.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "sim_core/instrument/device.h"

namespace fulcrum::app::program_test {

struct Counters {
    std::atomic<std::uint32_t> ticks{0};     ///< of the running attempt
    std::atomic<std::uint32_t> begun{0};     ///< attempts whose first tick was read
    std::atomic<std::uint32_t> finished{0};  ///< attempts whose score was acknowledged as stored
    std::atomic<std::uint32_t> paused{0};    ///< attempts that lost their device
    /// Of the running attempt, once the display shows a limit that stays broken: when (monotonic ns; 0: it
    /// does not), and the newest tick then.
    std::atomic<std::int64_t> broken{0};
    std::atomic<std::uint32_t> broken_tick{0};
};

/// Null if the file cannot be created.
Counters* map_counters(const char* path);

/// Passes on the readings of a device or an operator and counts them.
template <typename OwnRig>
class CountingRig : public OwnRig {
  public:
    CountingRig(std::shared_ptr<OwnRig> rig, Counters& counters)
        : rig_(std::move(rig)), counters_(counters) {}
    void read(std::uint32_t tick, RigSample& sample) override {
        rig_->read(tick, sample);
        counters_.ticks.store(tick);
        if (tick == 1) counters_.begun.fetch_add(1);
    }
    void write_force(Hand hand, const Vector3& force) override { rig_->write_force(hand, force); }
    bool has_force(Hand hand) const override { return rig_->has_force(hand); }
    double damping(Hand hand) const override { return rig_->damping(hand); }
    void write_torque(Hand hand, double torque) override { rig_->write_torque(hand, torque); }
    std::optional<ForceOutput> force_output(Hand hand) const override { return rig_->force_output(hand); }

  protected:
    std::shared_ptr<OwnRig> rig_;

  private:
    Counters& counters_;
};

/// Runs short attempts of an operator without a window, each abandoned and scored, until the process is
/// killed.
int perform_until_killed(const char* folder, const char* counters, unsigned long seed);
/// The same through the window: signs in, starts, moves and abandons by mouse and key events.
int use_window_until_killed(const char* folder, const char* counters, unsigned long seed);

/// The same with a haptic device (FULCRUM_DEVICE, FAKE_TOUCH_PAGE) that presses on the spheres of A2, and no
/// mouse.
int press_until_killed(const char* folder, const char* counters, unsigned long seed);

/// Breaks a limit in an assessed attempt, sets `broken` and waits (escapes_test.cpp).
int break_limit_until_killed(const char* folder, const char* counters);
/// Brings assessed attempts that break a limit, or do not, to one moment each, sets `finished` and waits
/// (escape_moments_test.cpp).
int reach_moments_until_killed(const char* folder, const char* counters, bool breaks);

inline constexpr const char* trainee_login = "tara";
inline constexpr const char* trainee_password = "tara's password";

}  // namespace fulcrum::app::program_test
