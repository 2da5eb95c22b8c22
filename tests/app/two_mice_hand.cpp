// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/two_mice_hand.h"

#include <algorithm>
#include <cmath>

#include "sim_core/instrument/mouse_mapping.h"

namespace fulcrum::app::program_test {
namespace {

constexpr int jaws_button = 1, pedal_button = 2, turning_button = 3, exchange_button = 8;
constexpr int taken_within_ms = 250;  // a movement that had no effect by then is not waited for
constexpr int furthest_counts = 220;  // in one go

}  // namespace

void TwoMiceHand::let_go() {
    for (int h = 0; h < hand_count; ++h)
        for (const int button : {jaws_button, pedal_button, turning_button, exchange_button})
            hold(h, button, false);
}

void TwoMiceHand::hold(int hand, int button, bool held) {
    if (held_[hand][button] == held) return;
    held_[hand][button] = held;
    note_hold(10 * hand + button, held);
    mice_.button(hand, button, held);
    ++events_;
}

void TwoMiceHand::push(int h) {
    const ui::AttemptSession& session = *theatre_.session();
    hold(h, jaws_button, wants_closed(session, wish_, h));
    hold(h, pedal_button, (wish_.hand[h].buttons & button_energy) != 0);
    const Vector3 is = theatre_.input()->targets().hand[h].handle, wanted = handle_of(wish_.hand[h]);
    if (sent_[h].isValid() && is == was_[h] && sent_[h].elapsed() < taken_within_ms) return;
    was_[h] = is;
    sent_[h].invalidate();
    const double deeper = is.norm() - wanted.norm();
    const auto notches = static_cast<int>(deeper / metres_per_notch);
    const auto little =
        static_cast<int>(std::lround((deeper - notches * metres_per_notch) / metres_per_pixel));
    if (notches != 0) {
        mice_.wheel(h, notches);
        events_ += std::abs(notches);
        sent_[h].start();
    }
    if (std::abs(little) > 1) {
        hold(h, turning_button, true);
        mice_.move(h, 0, -little);
        hold(h, turning_button, false);
        ++events_;
        sent_[h].start();
    }
    const Eigen::Vector2d across =
        movement_on_screen(session, session.scene().instrument(static_cast<Hand>(h))->trocar, is, wanted);
    const auto counts = [](double metres) {
        return std::clamp(static_cast<int>(std::lround(metres / metres_per_pixel)), -furthest_counts,
                          furthest_counts);
    };
    const int right = counts(across.x()), down = -counts(across.y());
    if (right == 0 && down == 0) return;
    mice_.move(h, right, down);
    ++events_;
    sent_[h].start();
}

}  // namespace fulcrum::app::program_test
