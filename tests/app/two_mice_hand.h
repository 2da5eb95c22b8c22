// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the instruments to given targets by two mice of the X server, one for each hand; the arrow keys turn
// the scope.
#pragma once

#include <QElapsedTimer>
#include <functional>

#include "assessment/operators/operator.h"
#include "tests/app/hand_wishes.h"
#include "tests/app/virtual_mice.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::app::program_test {

class TwoMiceHand {
  public:
    /// `mind`: reads the screen and returns the wanted poses of the handles, tick by tick.
    TwoMiceHand(ui::TheatrePage& theatre, ObservingRig& mind, VirtualMice& mice)
        : theatre_(theatre), mind_(mind), mice_(mice) {}
    /// Runs until `done`, the end of the attempt, or the timeout; true if done or ended.
    bool work_until(const std::function<bool()>& done, int milliseconds);
    int events() const { return events_; }

  private:
    void think();
    void push(int hand);
    void scope();
    void hold(int hand, int button, bool held);
    void let_go();
    double error(int hand) const;
    ui::TheatrePage& theatre_;
    ObservingRig& mind_;
    VirtualMice& mice_;
    RigSample wish_;
    std::uint32_t tick_ = 0;
    QElapsedTimer sent_[hand_count];  // the window takes movements once a picture
    Vector3 was_[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    bool held_[hand_count][10] = {};
    Look look_ = Look::none;
    int events_ = 0;
};

}  // namespace fulcrum::app::program_test
