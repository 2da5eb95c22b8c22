// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the instruments to given targets by two mice of the X server, one for each hand.
#pragma once

#include <QElapsedTimer>

#include "tests/app/virtual_mice.h"
#include "tests/app/working_hand.h"

namespace fulcrum::app::program_test {

class TwoMiceHand : public WorkingHand {
  public:
    TwoMiceHand(ui::TheatrePage& theatre, ObservingRig& mind, VirtualMice& mice)
        : WorkingHand(theatre, mind, 20e-3), mice_(mice) {}
    void let_go() override;

  private:
    void push(int hand) override;
    void hold(int hand, int button, bool held);
    VirtualMice& mice_;
    QElapsedTimer sent_[hand_count];  // the window takes movements once a picture
    Vector3 was_[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    bool held_[hand_count][10] = {};
};

}  // namespace fulcrum::app::program_test
