// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the instruments to given targets by devices whose positions a test sets: trackers, haptic devices.
#pragma once

#include <functional>

#include "assessment/operators/operator.h"
#include "tests/app/hand_wishes.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::app::program_test {

class PosedHand {
  public:
    /// Position of a hand's device, m, in the frame of docs/DEVICES.md.
    using Put = std::function<void(int hand, const Vector3& position)>;
    /// Presses or releases the button that closes a hand's jaws.
    using Press = std::function<void(int hand, bool closed)>;
    /// `mind`: reads the screen and returns the wanted poses of the handles, tick by tick. `begin`: where the
    /// devices are before. Without `press` the jaws stay as they are.
    PosedHand(ui::TheatrePage& theatre, ObservingRig& mind, Put put, const Vector3& begin = Vector3::Zero(),
              Press press = {})
        : theatre_(theatre), mind_(mind), put_(std::move(put)), press_(std::move(press)), begin_(begin) {}
    /// Runs until `done`, the end of the attempt, or the timeout; true if done or ended.
    bool work_until(const std::function<bool()>& done, int milliseconds);
    /// Positions that differ from the one before, and uses of the button.
    int events() const { return events_; }

  private:
    ui::TheatrePage& theatre_;
    ObservingRig& mind_;
    Put put_;
    Press press_;
    bool closed_[hand_count] = {false, false};
    Vector3 begin_, start_[hand_count], at_[hand_count];
    RigSample wish_;
    std::uint32_t tick_ = 0;
    int events_ = 0;
};

}  // namespace fulcrum::app::program_test
