// SPDX-License-Identifier: Apache-2.0
// A synthetic operator driven through a model of a device: what it wants its hands to do goes through the
// steps that the device allows. Provisional limits of a device class are made this way.
#pragma once

#include <cstdint>
#include <memory>

#include "assessment/operators/operator.h"
#include "assessment/task/attempt_words.h"

namespace fulcrum {

/// Whether there is a model of this class: of all but `external`, a trace of an unknown device.
bool has_device_model(DeviceClass device_class);

/// `hands` through the device; `attempt` seeds the noise of the device. Throws InputError for `external`.
///
/// Haptic and synthetic: the handle itself, with force. All others render none.
///
/// Mouse and keyboard: events at 60 Hz; one hand at a time, which changes in 0.25 s; the mouse in whole
/// pixels of the screen's plane, the wheel in whole notches, finer depth by the insertion keys; jaws open or
/// closed; the scope at the speed of its keys (where it is the only instrument, the mouse moves it and keys
/// turn light post and camera head).
///
/// Tracked: poses at 120 Hz that arrive two frames late, with noise of 0.05 mm and 0.2 degrees (standard
/// deviation of an axis); jaws report their angle, not the force of the fingers; smoothed as the window
/// smooths the mouse.
///
/// Controller: a stick for each hand, read at 60 Hz, sets the speed of the handle across its shaft on the
/// screen, or along it while a shoulder button is held; dead zone, whole steps, unsteady thumbs; a trigger
/// closes the jaws and then presses; the left thumb leaves its stick for the pad that moves the scope.
std::unique_ptr<ObservingRig> through_device(std::unique_ptr<ObservingRig> hands, DeviceClass device_class,
                                             const Scene& scene, std::uint64_t attempt);

}  // namespace fulcrum
