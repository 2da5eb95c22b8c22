// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/working_hand.h"

#include <QElapsedTimer>
#include <QtTest>
#include <utility>

#include "ui/theatre/theatre_view.h"

namespace fulcrum::app::program_test {

bool WorkingHand::work_until(const std::function<bool()>& done, int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds) {
        QTest::qWait(pause_ms_);
        if (theatre_.session() == nullptr || done()) {
            let_go();
            return true;
        }
        if (const ui::AttemptPhase phase = theatre_.session()->phase(); phase != ui::AttemptPhase::running) {
            if (!waited_ && phase == ui::AttemptPhase::device_lost) ++losses_;
            waited_ = true;
            come_back();
            continue;
        }
        think();
        if (tick_ == 0) continue;  // it wants nothing yet
        // A mouse that is moved lets the window work: the attempt can end there.
        for (int h = 0; h < hand_count && theatre_.session() != nullptr; ++h)
            if (theatre_.session()->scene().instrument(static_cast<Hand>(h)) != nullptr) push(h);
        if (theatre_.session() != nullptr) scope();
    }
    let_go();
    return false;
}

double WorkingHand::error(int hand) const {
    if (theatre_.session()->scene().instrument(static_cast<Hand>(hand)) == nullptr || tick_ == 0) return 0;
    return (handle_of(wish_.hand[hand]) - handle(hand)).norm();
}

Vector3 WorkingHand::handle(int hand) const {
    return theatre_.input()->targets().hand[hand].handle;
}

void WorkingHand::think() {
    const ui::AttemptSession& session = *theatre_.session();
    mind_.observe(session.snapshot(), session.display());
    const std::uint32_t now = session.health().ticks;
    const bool waited = std::exchange(waited_, false);
    if (tick_ != 0 && (waited || std::max(error(0), error(1)) > planned_ahead_)) {
        tick_ = now;
        return;
    }
    while (tick_ < now) {
        const RigSample before = wish_;
        mind_.read(++tick_, wish_);
        if (tick_ == 1) first_wish_ = wish_;
        for (int h = 0; h < hand_count; ++h)
            asks_exchange_[h] = asks_exchange_[h] || begins_exchange(before, wish_, h);
    }
}

void WorkingHand::scope() {
    constexpr int keys[] = {0, Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
    const Look look =
        wanted_look(*theatre_.session(), theatre_.input()->targets(), wish_, look_ != Look::none);
    if (look == look_) return;
    ui::TheatreView* const view = theatre_.view();
    if (look_ != Look::none) QTest::keyRelease(view, static_cast<Qt::Key>(keys[static_cast<int>(look_)]));
    if (look != Look::none) QTest::keyPress(view, static_cast<Qt::Key>(keys[static_cast<int>(look)]));
    look_ = look;
    ++events_;
}

}  // namespace fulcrum::app::program_test
