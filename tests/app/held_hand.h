// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the instruments to given targets by a device of fulcrum-hapticd, as its fake has it: its places or
// deflections, its jaws, its buttons. What it does not have is done as the window says: by the keys of jaws,
// pedal and exchange, by the arrow keys (the scope), by the mouse (the other hand).
#pragma once

#include <QElapsedTimer>

#include "tests/app/held_devices.h"
#include "tests/app/posed_hand.h"

namespace fulcrum::app::program_test {

class HeldHand : public PosedHand {
  public:
    HeldHand(ui::TheatrePage& theatre, ObservingRig& mind, HeldDevice& device);
    /// Lets go, and is where it begins: an attempt begins where the device is.
    void let_go() override;

  private:
    void push(int hand) override;
    /// After a loss of the device, when it is back and in place: continues.
    void come_back() override;
    void scope() override { WorkingHand::scope(); }
    Vector3 handle(int hand) const override;
    /// Of an instrument in this pose.
    Vector3 handle_in(int hand, const ToolPose& pose) const;
    /// Brings each device onto its instrument, so that it works with the same offset as before; false once
    /// all are there.
    bool brings_back(const ui::Realignment& now);
    void use(int hand, const HeldParts& wanted);
    /// Of the device itself.
    void hold(int hand, const HeldParts& parts);
    void hold_key(bool& held, int key, bool wanted);
    bool has(int hand, ui::HandDeed deed) const;
    bool exchanges(int hand);
    double opening(int hand, bool closed);
    HeldDevice& device_;
    HeldParts held_[hand_count];
    bool pedal_key_ = false, exchange_key_ = false;
    double open_[hand_count] = {1, 1};
    QElapsedTimer since_shift_, since_jaws_[hand_count], exchange_asked_[hand_count];
};

}  // namespace fulcrum::app::program_test
