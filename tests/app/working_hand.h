// SPDX-License-Identifier: GPL-3.0-or-later
// What the drivers of the devices share: a mind wants poses, the device moves the hands there step by step,
// and nobody plans further ahead than the hands follow.
#pragma once

#include <functional>

#include "assessment/operators/operator.h"
#include "tests/app/hand_wishes.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::app::program_test {

/// Performs a task in the theatre with a device.
class Worker {
  public:
    virtual ~Worker() = default;
    /// Runs until `done`, the end of the attempt, or the timeout; true if done or ended.
    virtual bool work_until(const std::function<bool()>& done, int milliseconds) = 0;
    /// Input that was made.
    int events() const { return events_; }
    /// Times that a device was lost while it worked.
    int losses() const { return losses_; }
    /// Called where a button of a device that Qt does not read goes down or up, if it is set: `number` tells
    /// them apart.
    std::function<void(int number, bool held)> on_hold;

  protected:
    int events_ = 0, losses_ = 0;
};

class WorkingHand : public Worker {
  public:
    bool work_until(const std::function<bool()>& done, int milliseconds) override;
    /// Lets go of everything.
    virtual void let_go() = 0;

  protected:
    void note_hold(int number, bool held) const {
        if (on_hold) on_hold(number, held);
    }
    /// `mind`: reads the screen and returns the wanted poses of the handles, tick by tick. `planned_ahead`: m
    /// of the handle.
    WorkingHand(ui::TheatrePage& theatre, ObservingRig& mind, double planned_ahead, int pause_ms = 8)
        : theatre_(theatre), mind_(mind), planned_ahead_(planned_ahead), pause_ms_(pause_ms) {}
    WorkingHand(const WorkingHand&) = default;
    WorkingHand& operator=(const WorkingHand&) = delete;
    /// Moves this hand towards `wish_`.
    virtual void push(int hand) = 0;
    /// The attempt waits for something that a person does: called again and again.
    virtual void come_back() {}
    /// Turns the scope; with the arrow keys where the device has nothing for it.
    virtual void scope();
    /// Where the handle of this hand is, m, frame of its trocar.
    virtual Vector3 handle(int hand) const;
    ui::TheatrePage& theatre_;
    RigSample wish_, first_wish_;  ///< now, and when the work began
    /// The mind has pressed the button for another instrument. A press is short, and the screen slow: the
    /// driver ends it.
    bool asks_exchange_[hand_count] = {false, false};

  private:
    void think();
    double error(int hand) const;
    ObservingRig& mind_;
    double planned_ahead_;
    int pause_ms_;
    std::uint32_t tick_ = 0;
    bool waited_ = false;  // the attempt did not run: nothing was wanted of the ticks in between
    Look look_ = Look::none;
};

}  // namespace fulcrum::app::program_test
