// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/posed_hand.h"

#include "app/live/device_rig.h"

namespace fulcrum::app::program_test {

void PosedHand::push(int h) {
    if (press_ && closed_[h] != (wish_.hand[h].jaw == 0)) {
        closed_[h] = !closed_[h];
        press_(h, closed_[h]);
        ++events_;
    }
    const Vector3 position =
        begin_ + DeviceRig::turned(handle_of(wish_.hand[h]) - handle_of(first_wish_.hand[h]));
    if (is_put_[h] && position == at_[h]) return;
    is_put_[h] = true;
    at_[h] = position;
    put_(h, position);
    ++events_;
}

void PosedHand::shift(int h, const Vector3& of_handle) {
    at_[h] = (is_put_[h] ? at_[h] : begin_) + DeviceRig::turned(of_handle);
    is_put_[h] = true;
    put_(h, at_[h]);
    ++events_;
}

}  // namespace fulcrum::app::program_test
