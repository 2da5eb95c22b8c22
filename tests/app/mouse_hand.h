// SPDX-License-Identifier: GPL-3.0-or-later
// A hand at the mouse and the keyboard: knows where it wants the instruments and gets them there by mouse
// moves, wheel turns, clicks and keys, all of them events that the window handles as it handles a person's.
#pragma once

#include <functional>
#include <memory>

#include "assessment/operators/operator.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::app::test {

/// Goes for the lit sphere, from the trocar's side, and rests on it. Sees what the screen shows.
/// `depth`: m pressed beyond the touch.
std::unique_ptr<ObservingRig> make_pointing_mind(const Scene& scene, double depth = 0);

/// Turns the wheel over the view; 120 units are a notch.
void turn_wheel(ui::TheatreView& view, int units);

class MouseHand {
  public:
    /// `mind`: is shown what is on the screen and answers, tick by tick, where it wants the handles.
    MouseHand(ui::TheatrePage& theatre, ObservingRig& mind) : theatre_(theatre), mind_(mind) {}
    /// Works until `done`, the attempt's end or the time is up; true if done or ended.
    bool work_until(const std::function<bool()>& done, int milliseconds);
    int events() const { return events_; }

  private:
    void think();
    void steer();
    void jaws();
    /// Pedal and exchange: of the active hand, by keys.
    void buttons();
    void take(int hand);
    void scope();
    ui::TheatrePage& theatre_;
    ObservingRig& mind_;
    RigSample wish_;
    std::uint32_t tick_ = 0;
    int scope_key_ = 0, events_ = 0;
    bool pedal_ = false, asks_exchange_[hand_count] = {false, false};
};

}  // namespace fulcrum::app::test
