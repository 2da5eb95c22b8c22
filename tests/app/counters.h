// SPDX-License-Identifier: GPL-3.0-or-later
// What a program that will be killed tells whoever kills it: shared memory outlives a kill.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "sim_core/instrument/device.h"

namespace fulcrum::app::test {

struct Counters {
    std::atomic<std::uint32_t> ticks{0};     ///< of the attempt that runs
    std::atomic<std::uint32_t> begun{0};     ///< attempts whose first tick was read
    std::atomic<std::uint32_t> finished{0};  ///< attempts whose score was acknowledged as stored
};

/// Null when the file cannot be made.
Counters* map_counters(const char* path);

/// Somebody's hands, a person's device or an operator; counts the ticks that were read.
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

  protected:
    std::shared_ptr<OwnRig> rig_;

  private:
    Counters& counters_;
};

/// One short attempt after the other, each abandoned and scored, until the kill: an operator's hands on the
/// attempt's threads, without a window.
int perform_until_killed(const char* folder, const char* counters, unsigned long seed);
/// The same by a person at the window: signs in, starts, moves, abandons by mouse and key events.
int use_window_until_killed(const char* folder, const char* counters, unsigned long seed);

inline constexpr const char* trainee_login = "tara";
inline constexpr const char* trainee_password = "tara's password";

}  // namespace fulcrum::app::test
