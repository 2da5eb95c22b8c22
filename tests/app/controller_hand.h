// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the instruments to given targets by the sticks, triggers and buttons of a game controller.
#pragma once

#include <QElapsedTimer>
#include <functional>

#include "assessment/operators/operator.h"
#include "tests/app/hand_wishes.h"
#include "tests/app/virtual_pad.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::app::program_test {

class ControllerHand {
  public:
    /// `mind`: reads the screen and returns the wanted poses of the handles, tick by tick.
    ControllerHand(ui::TheatrePage& theatre, ObservingRig& mind, VirtualPad& pad)
        : theatre_(theatre), mind_(mind), pad_(pad) {}
    /// Runs until `done`, the end of the attempt, or the timeout; true if done or ended.
    bool work_until(const std::function<bool()>& done, int milliseconds);
    /// Changes of sticks, triggers and buttons.
    int events() const { return changes_; }
    /// Lets go of everything.
    void let_go();

  private:
    void think();
    void push(int hand);
    void scope();
    void set_axis(int axis, double share);
    void set_button(int button, bool held);
    double error(int hand) const;
    ui::TheatrePage& theatre_;
    ObservingRig& mind_;
    VirtualPad& pad_;
    std::int32_t axis_[6] = {};
    std::uint32_t buttons_ = 0;
    RigSample wish_;
    std::uint32_t tick_ = 0;
    bool along_[hand_count] = {false, false};
    QElapsedTimer busy_[hand_count];  // a thumb finds the shoulder button
    int pad_button_ = -1, changes_ = 0;
};

}  // namespace fulcrum::app::program_test
