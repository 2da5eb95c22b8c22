// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/working_hand.h"

#include <QElapsedTimer>
#include <QtTest>

namespace fulcrum::app::program_test {

bool WorkingHand::work_until(const std::function<bool()>& done, int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds) {
        QTest::qWait(8);
        if (theatre_.session() == nullptr || done()) {
            let_go();
            return true;
        }
        if (theatre_.session()->phase() != ui::AttemptPhase::running) continue;
        think();
        for (int h = 0; h < hand_count; ++h)
            if (theatre_.session()->scene().instrument(static_cast<Hand>(h)) != nullptr) push(h);
        scope();
    }
    let_go();
    return false;
}

double WorkingHand::error(int hand) const {
    if (theatre_.session()->scene().instrument(static_cast<Hand>(hand)) == nullptr || tick_ == 0) return 0;
    return (handle_of(wish_.hand[hand]) - theatre_.input()->targets().hand[hand].handle).norm();
}

void WorkingHand::think() {
    const ui::AttemptSession& session = *theatre_.session();
    mind_.observe(session.snapshot(), session.display());
    const std::uint32_t now = session.health().ticks;
    if (tick_ != 0 && std::max(error(0), error(1)) > planned_ahead_) {
        tick_ = now;
        return;
    }
    while (tick_ < now) mind_.read(++tick_, wish_);
}

}  // namespace fulcrum::app::program_test
