// SPDX-License-Identifier: GPL-3.0-or-later
// What the drivers of the window's own devices share: a mind wants poses, the device moves the hands there
// step by step, and nobody plans further ahead than the hands follow.
#pragma once

#include <functional>

#include "assessment/operators/operator.h"
#include "tests/app/hand_wishes.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::app::program_test {

class WorkingHand {
  public:
    virtual ~WorkingHand() = default;
    /// Runs until `done`, the end of the attempt, or the timeout; true if done or ended.
    bool work_until(const std::function<bool()>& done, int milliseconds);
    /// Input that was made.
    int events() const { return events_; }
    /// Lets go of everything.
    virtual void let_go() = 0;
    /// Called where a button of the device goes down or up, if it is set: `number` tells them apart.
    std::function<void(int number, bool held)> on_hold;

  protected:
    void note_hold(int number, bool held) const {
        if (on_hold) on_hold(number, held);
    }
    /// `mind`: reads the screen and returns the wanted poses of the handles, tick by tick. `planned_ahead`: m
    /// of the handle.
    WorkingHand(ui::TheatrePage& theatre, ObservingRig& mind, double planned_ahead)
        : theatre_(theatre), mind_(mind), planned_ahead_(planned_ahead) {}
    WorkingHand(const WorkingHand&) = default;
    WorkingHand& operator=(const WorkingHand&) = delete;
    /// Moves this hand towards `wish_`.
    virtual void push(int hand) = 0;
    virtual void scope() = 0;
    ui::TheatrePage& theatre_;
    RigSample wish_;
    int events_ = 0;

  private:
    void think();
    double error(int hand) const;
    ObservingRig& mind_;
    double planned_ahead_;
    std::uint32_t tick_ = 0;
};

}  // namespace fulcrum::app::program_test
