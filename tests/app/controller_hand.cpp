// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/controller_hand.h"

#include <QtTest>
#include <cmath>

#include "sim_core/controllers/sdl_library.h"
#include "sim_core/controllers/stick_response.h"
#include "sim_core/instrument/mouse_mapping.h"
#include "ui/theatre/mouse_keyboard_input.h"

namespace fulcrum::app::program_test {
namespace {

constexpr double near_goal = 0.6e-3;  // m of the handle
constexpr double closing_s = 0.15;
constexpr int button_ms = 120;
constexpr std::int32_t trigger_pulled = 32767 / 10;  // of a trigger: a finger is on it
constexpr int first_axis_number = 32;                // as a number of a button

/// How far a stick has to be pushed for a share of the fastest speed.
double push_for(double speed) {
    double low = 0, high = 1;
    for (int i = 0; i < 30; ++i) {
        const double middle = (low + high) / 2;
        (stick_speed(middle) < speed ? low : high) = middle;
    }
    return high;
}

}  // namespace

void ControllerHand::let_go() {
    for (int axis = 0; axis < 6; ++axis) set_axis(axis, 0);
    for (int button = 0; button < controllers::button_count; ++button) set_button(button, false);
    pad_button_ = -1;
    along_[0] = along_[1] = false;
}

void ControllerHand::set_axis(int axis, double share) {
    const auto value = static_cast<std::int32_t>(std::lround(32767 * std::clamp(share, -1.0, 1.0)));
    if (axis_[axis] == value) return;
    axis_[axis] = value;
    if (axis >= controllers::axis_left_trigger) note_hold(first_axis_number + axis, value > trigger_pulled);
    pad_.set_axis(axis, value);
    ++events_;
}

void ControllerHand::set_button(int button, bool held) {
    const std::uint32_t bit = 1U << static_cast<unsigned>(button), before = buttons_;
    buttons_ = held ? before | bit : before & ~bit;
    if (buttons_ == before) return;
    note_hold(button, held);
    pad_.set_buttons(buttons_);
    ++events_;
}

void ControllerHand::push(int h) {
    const InstrumentSpec& spec = *theatre_.session()->scene().instrument(static_cast<Hand>(h));
    const DeviceSample& wish = wish_.hand[h];
    const double opening = spec.jaw_opening;
    const int trigger = controllers::axis_left_trigger + h;
    if (holds_blade(*theatre_.session(), h)) {
        set_axis(trigger, wants_closed(*theatre_.session(), wish_, h) ? 1 : 0);
    } else if (opening > 0) {
        const double grip = device_force_unit * wish.grip, open = device_angle_unit * wish.jaw / opening;
        set_axis(trigger, grip > 0 ? trigger_closed + 0.01 + (0.99 - trigger_closed) * grip / spec.grip_force
                                   : 0.95 * trigger_closed * (1 - open));
    }
    set_button(h == 0 ? controllers::button_west : controllers::button_east,
               (wish.buttons & button_energy) != 0);
    const Vector3 is = theatre_.input()->targets().hand[h].handle, wanted = handle_of(wish);
    const double deeper = is.norm() - wanted.norm();
    const Vector3 step = wanted * (is.norm() / wanted.norm()) - is;
    const double here = along_[h] ? std::abs(deeper) : step.norm(),
                 there = along_[h] ? step.norm() : std::abs(deeper);
    const int x = h == 0 ? controllers::axis_left_x : controllers::axis_right_x, y = x + 1;
    if (there > near_goal && there > 1.5 * here) {
        along_[h] = !along_[h];
        busy_[h].start();
        set_axis(x, 0);
        set_axis(y, 0);
    }
    if (busy_[h].isValid() && busy_[h].elapsed() < button_ms) return;
    set_button(h == 0 ? controllers::button_left_shoulder : controllers::button_right_shoulder, along_[h]);
    const auto speed = [](double distance) {
        return std::min(1.0, distance / closing_s / stick_handle_speed);
    };
    if (along_[h]) {
        const bool moves = std::abs(deeper) > 0.5 * near_goal;
        set_axis(x, 0);
        set_axis(y, moves ? -std::copysign(push_for(speed(std::abs(deeper))), deeper) : 0);
        return;
    }
    const Eigen::Vector2d across = movement_on_screen(*theatre_.session(), spec.trocar, is, wanted);
    const double size = across.norm();
    const double pushed = size > 0.5 * near_goal ? push_for(speed(size)) / size : 0;
    set_axis(x, pushed * across.x());
    set_axis(y, -pushed * across.y());
}

/// The direction pad turns the scope.
void ControllerHand::scope() {
    constexpr int pad_buttons[] = {-1, controllers::button_pad_left, controllers::button_pad_right,
                                   controllers::button_pad_up, controllers::button_pad_down};
    const int wanted = pad_buttons[static_cast<int>(
        wanted_look(*theatre_.session(), theatre_.input()->targets(), wish_, pad_button_ >= 0))];
    if (wanted == pad_button_) return;
    if (pad_button_ >= 0) set_button(pad_button_, false);
    if (wanted >= 0) set_button(wanted, true);
    pad_button_ = wanted;
}

}  // namespace fulcrum::app::program_test
