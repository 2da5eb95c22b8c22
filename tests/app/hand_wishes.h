// SPDX-License-Identifier: GPL-3.0-or-later
// What the drivers of the devices share: from the poses that a synthetic operator wants to the movements that
// bring the instruments there.
#pragma once

#include "sim_core/instrument/device.h"
#include "ui/services/attempt_session.h"
#include "ui/theatre/mouse_keyboard_input.h"

namespace fulcrum::app::program_test {

/// The jaws of this hand, or the button of its blade, are to be closed: the window uses one button for both.
bool wants_closed(const ui::AttemptSession& session, const RigSample& wish, int hand);
/// It holds a blade: scissors or a hook.
bool holds_blade(const ui::AttemptSession& session, int hand);

/// m to the right and up, as seen through the scope, that bring a handle across its shaft towards `wanted`.
Eigen::Vector2d movement_on_screen(const ui::AttemptSession& session, const TrocarSpec& trocar,
                                   const Vector3& is, const Vector3& wanted);

enum class Look { none, left, right, up, down };
/// How the scope is to be turned; `turning`: it is being turned.
Look wanted_look(const ui::AttemptSession& session, const ui::HandTargets& now, const RigSample& wish,
                 bool turning);

/// The button for another instrument goes down.
bool begins_exchange(const RigSample& before, const RigSample& now, int hand);

Vector3 handle_of(const DeviceSample& sample);

}  // namespace fulcrum::app::program_test
