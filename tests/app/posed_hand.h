// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the instruments to given targets by devices whose positions a test sets: trackers, haptic devices.
#pragma once

#include <functional>
#include <limits>

#include "tests/app/working_hand.h"

namespace fulcrum::app::program_test {

class PosedHand : public WorkingHand {
  public:
    /// Position of a hand's device, m, in the frame of docs/DEVICES.md.
    using Put = std::function<void(int hand, const Vector3& position)>;
    /// Presses or releases the button that closes a hand's jaws.
    using Press = std::function<void(int hand, bool closed)>;
    /// `mind`: reads the screen and returns the wanted poses of the handles, tick by tick. `begin`: where the
    /// devices are before. Without `press` the jaws stay as they are.
    PosedHand(ui::TheatrePage& theatre, ObservingRig& mind, Put put, const Vector3& begin = Vector3::Zero(),
              Press press = {}, double planned_ahead = std::numeric_limits<double>::infinity())
        : WorkingHand(theatre, mind, planned_ahead, 4),
          put_(std::move(put)),
          press_(std::move(press)),
          begin_(begin) {}
    /// Stays where it is.
    void let_go() override {}

  protected:
    /// Its input: positions that differ from the one before, and uses of the button.
    void push(int hand) override;
    void scope() override {}
    /// The device itself, where a person brings it back to its instrument.
    void shift(int hand, const Vector3& of_handle);

  private:
    Put put_;
    Press press_;
    bool closed_[hand_count] = {false, false}, is_put_[hand_count] = {false, false};
    Vector3 begin_, at_[hand_count];
};

}  // namespace fulcrum::app::program_test
