// SPDX-License-Identifier: GPL-3.0-or-later
// What of an attempt is felt by rumble and heard: the one place that decides it, from what the window shows.
#pragma once

#include "assessment/task/monitor.h"
#include "sim_core/sound/sound_state.h"

namespace fulcrum::ui {

/// Strengths of a controller's motors, 0 to 1, for the force at a tip (N) and its limit (0: none).
struct RumbleStrength {
    double slow = 0, fast = 0;
};
RumbleStrength rumble_of(double force, double limit);

inline constexpr double felt_from = 0.05;         ///< N: a contact
inline constexpr double felt_until = 0.02;        ///< N: below this it has ended
inline constexpr double alarm_flow = 10e-6 / 60;  ///< m3/s of blood from all openings: 10 mL/min

class Feedback {
  public:
    /// One picture of a task that runs; both null while none does: nothing is felt or heard.
    void follow(const TaskDisplay* display, const WorldSnapshot* world);
    const RumbleStrength& rumble() const { return rumble_; }
    /// Without volume. Contacts are counted over all attempts.
    const SoundState& sound() const { return sound_; }

  private:
    void follow_hand(int hand, double force, double limit);
    RumbleStrength rumble_;
    SoundState sound_;
    bool touches_[hand_count] = {false, false};
};

}  // namespace fulcrum::ui
