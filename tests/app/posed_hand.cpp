// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/posed_hand.h"

#include <QElapsedTimer>
#include <QtTest>

#include "app/live/device_rig.h"

namespace fulcrum::app::program_test {

bool PosedHand::work_until(const std::function<bool()>& done, int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds) {
        QTest::qWait(4);
        const ui::AttemptSession* const session = theatre_.session();
        if (session == nullptr || done()) return true;
        if (session->phase() != ui::AttemptPhase::running) continue;
        mind_.observe(session->snapshot(), session->display());
        const std::uint32_t now = session->health().ticks;
        const bool first = tick_ == 0;
        while (tick_ < now) {
            mind_.read(++tick_, wish_);
            if (first && tick_ == 1)
                for (int h = 0; h < hand_count; ++h) start_[h] = handle_of(wish_.hand[h]);
        }
        for (int h = 0; h < hand_count && tick_ > 0; ++h) {
            if (press_ && closed_[h] != (wish_.hand[h].jaw == 0)) {
                closed_[h] = !closed_[h];
                press_(h, closed_[h]);
                ++events_;
            }
            const Vector3 position = begin_ + DeviceRig::turned(handle_of(wish_.hand[h]) - start_[h]);
            if (!first && position == at_[h]) continue;
            at_[h] = position;
            put_(h, position);
            ++events_;
        }
    }
    return false;
}

}  // namespace fulcrum::app::program_test
