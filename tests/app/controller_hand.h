// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the instruments to given targets by the sticks, triggers and buttons of a game controller.
#pragma once

#include <QElapsedTimer>

#include "tests/app/virtual_pad.h"
#include "tests/app/working_hand.h"

namespace fulcrum::app::program_test {

class ControllerHand : public WorkingHand {
  public:
    ControllerHand(ui::TheatrePage& theatre, ObservingRig& mind, VirtualPad& pad)
        : WorkingHand(theatre, mind, 6e-3), pad_(pad) {}
    void let_go() override;

  private:
    void push(int hand) override;
    void scope() override;
    void set_axis(int axis, double share);
    void set_button(int button, bool held);
    VirtualPad& pad_;
    std::int32_t axis_[6] = {};
    std::uint32_t buttons_ = 0;
    bool along_[hand_count] = {false, false};
    QElapsedTimer busy_[hand_count];  // a thumb finds the shoulder button
    int pad_button_ = -1;
};

}  // namespace fulcrum::app::program_test
