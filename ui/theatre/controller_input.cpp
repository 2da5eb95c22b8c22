// SPDX-License-Identifier: GPL-3.0-or-later
// A game controller: a stick for each hand.
#include <algorithm>

#include "ui/theatre/mouse_keyboard_input.h"

namespace fulcrum::ui {

void MouseKeyboardInput::move_by_controller(const ControllerMotion& motion) {
    const double speed = sensitivity_ * stick_handle_speed;
    for (int h = 0; h < hand_count; ++h) {
        Axis& axis = hand_[h];
        axis.trigger = motion.trigger[h];
        axis.pedal = motion.pedal[h];
        if (motion.latches[h] % 2 == 1) axis.latched = !axis.latched;
        if (!axis.exists || scope_alone_) continue;
        DeviceReading& reading = targets_.hand[h];
        shift_handle(reading, axis.trocar,
                     on_screen(speed * motion.across[h][0], speed * motion.across[h][1]));
        insert_handle(reading, axis.trocar, speed * motion.along[h]);
        reading.roll += key_turn_speed * motion.turned[h];
        // The button for the next instrument is for the hand that worked last.
        const bool works = motion.across[h][0] != 0 || motion.across[h][1] != 0 || motion.along[h] != 0 ||
                           motion.turned[h] != 0 || motion.pedal[h];
        if (works) active_ = static_cast<Hand>(h);
    }
    for (int h = 0; h < hand_count; ++h)
        hand_[h].exchange = motion.exchange && static_cast<int>(active_) == h;
    if (!has_camera_) return;
    DeviceReading& scope = targets_.camera;
    if (scope_alone_) {
        // The left stick holds the scope, the right one turns the light post and, with its shoulder button,
        // the camera head.
        shift_handle(scope, camera_trocar_,
                     on_screen(speed * motion.across[0][0], speed * motion.across[0][1]));
        insert_handle(scope, camera_trocar_, speed * motion.along[0]);
        scope.roll += key_turn_speed * (motion.across[1][0] + motion.turned[0]);
        scope.jaw -= key_turn_speed * motion.turned[1];
    }
    // The pad turns the view: the handle goes the other way, as with the arrow keys.
    shift_handle(scope, camera_trocar_,
                 on_screen(-key_camera_speed * motion.scope[0], -key_camera_speed * motion.scope[1]));
    insert_handle(scope, camera_trocar_, key_insertion_speed * motion.scope_along);
    scope.roll += key_turn_speed * motion.scope_turned;
    scope.jaw -= key_turn_speed * motion.head_turned;
}

void MouseKeyboardInput::hold_jaws() {
    for (Axis& axis : hand_) {
        axis.latched = axis.latched || axis.trigger >= trigger_closed;
        axis.trigger = 0;
        axis.pedal = axis.exchange = false;
    }
}

}  // namespace fulcrum::ui
