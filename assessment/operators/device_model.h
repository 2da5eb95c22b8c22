// SPDX-License-Identifier: Apache-2.0
// A synthetic operator driven through a model of a device: what it wants its hands to do goes through the
// steps that the device allows. Provisional limits of a device class are made this way.
#pragma once

#include <memory>

#include "assessment/operators/operator.h"
#include "assessment/task/attempt_words.h"

namespace fulcrum {

/// Whether there is a model of this class: haptic, synthetic (the handle itself) and mouse-keyboard.
bool has_device_model(DeviceClass device_class);

/// `hands` through the device. Mouse and keyboard: events at 60 Hz; one hand at a time, which changes in
/// 0.25 s; the mouse in whole pixels of the screen's plane, the wheel in whole notches, finer depth by the
/// insertion keys; jaws open or closed; the scope at the speed of its keys (where it is the only instrument,
/// by the mouse); no force felt. The mapping is that of the window (sim_core/instrument/mouse_mapping.h).
/// Throws InputError for a class without a model.
std::unique_ptr<ObservingRig> through_device(std::unique_ptr<ObservingRig> hands, DeviceClass device_class,
                                             const Scene& scene);

}  // namespace fulcrum
