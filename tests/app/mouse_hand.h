// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the instruments to given targets by mouse moves, wheel turns, clicks and keys: the events that a
// person at the window causes.
#pragma once

#include <QElapsedTimer>
#include <functional>
#include <memory>

#include "assessment/operators/operator.h"
#include "tests/app/working_hand.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::app::program_test {

/// Approaches the lit sphere from the trocar's side and stays on it, using what the screen shows. `depth`: m
/// pressed in beyond contact.
std::unique_ptr<ObservingRig> make_pointing_mind(const Scene& scene, double depth = 0);

/// Turns the wheel over the view; 120 units are a notch.
void turn_wheel(ui::TheatreView& view, int units);

/// Moves the mouse over the view in ten steps, one a picture, from where the pointer is, which does not move.
/// Returns their number.
int slide_mouse(ui::TheatreView& view, const QPoint& by, Qt::KeyboardModifiers with = Qt::NoModifier);

/// Tests of other programs share the screen and its pointer: outside the view it would move nothing.
void keep_pointer_in(ui::TheatreView& view);
/// A step by mouse and wheel of the handle that the mouse moves towards a place. Returns the events.
int bring_by_mouse(ui::TheatrePage& theatre, const Vector3& handle, const Vector3& wish,
                   const TrocarSpec& trocar);

class MouseHand : public Worker {
  public:
    /// `mind`: reads the screen and returns the wanted poses of the handles, tick by tick.
    MouseHand(ui::TheatrePage& theatre, ObservingRig& mind) : theatre_(theatre), mind_(mind) {}
    bool work_until(const std::function<bool()>& done, int milliseconds) override;

  private:
    void think();
    void steer();
    void jaws();
    /// Pedal and exchange: of the active hand, by keys.
    void buttons();
    void take(int hand);
    void scope();
    /// Keys turn light post and camera head, where the scope is the only instrument.
    void turn_scope();
    void hold_key(int& held, int key);
    ui::TheatrePage& theatre_;
    ObservingRig& mind_;
    RigSample wish_;
    std::uint32_t tick_ = 0;
    QElapsedTimer since_press_;
    int scope_key_ = 0, post_key_ = 0, head_key_ = 0;
    bool pedal_ = false, asks_exchange_[hand_count] = {false, false};
};

}  // namespace fulcrum::app::program_test
