// SPDX-License-Identifier: GPL-3.0-or-later
// The end of the force of an attempt: what was rendered at the last tick falls to 0 within the slew limit, as
// in a pause. Cut off at once, it would let a hand that presses shoot forward. These are no ticks: nothing of
// it is recorded.
//
// Haptic thread: no lock, allocation, input, output or exception.
#pragma once

#include "sim_core/instrument/tick_output.h"
#include "sim_core/scene/scene.h"

namespace fulcrum::app {

/// Periods that the forces and torques of a tick take to fall to 0 with the rig's devices; at most a second
/// of them.
int periods_to_release(const Rig& rig, const TickOutput& last, const Scene& scene) noexcept;
/// Hands them to the rig, one each period, until they are 0; the first a period after it is called.
void release_forces(Rig& rig, const TickOutput& last, const Scene& scene) noexcept;

}  // namespace fulcrum::app
