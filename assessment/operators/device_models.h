// SPDX-License-Identifier: Apache-2.0
// The models behind through_device(), and what they share: poses as SI values, movements as a screen shows
// them. Private to this room.
#pragma once

#include <memory>
#include <optional>

#include "assessment/operators/operator.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

/// m, trocar frame.
inline Vector3 handle_of(const DeviceSample& sample) {
    return device_length_unit * Vector3(sample.handle[0], sample.handle[1], sample.handle[2]);
}

/// A movement of the handle as it is seen on the screen, m.
struct ScreenStep {
    double right = 0, up = 0;
};

/// From the picture (x right, y up) to the patient frame. The patient frame itself without a scope.
Quaternion view_of(const ScopeModel& scope, bool exists, const DeviceSample& sample);
/// The movement on the screen whose part across the shaft takes the handle to where it is wanted (m, trocar
/// frame); absent where the screen is seen along the shaft's plane.
std::optional<ScreenStep> screen_step(const DeviceReading& from, const Trocar& trocar, const Vector3& wanted,
                                      const Quaternion& view);

std::unique_ptr<ObservingRig> make_mouse_model(std::unique_ptr<ObservingRig> hands, const Scene& scene);
/// `attempt` seeds the noise of the poses.
std::unique_ptr<ObservingRig> make_tracked_model(std::unique_ptr<ObservingRig> hands, const Scene& scene,
                                                 std::uint64_t attempt);
/// `attempt` seeds the unsteadiness of the thumbs.
std::unique_ptr<ObservingRig> make_controller_model(std::unique_ptr<ObservingRig> hands, const Scene& scene,
                                                    std::uint64_t attempt);

}  // namespace fulcrum
