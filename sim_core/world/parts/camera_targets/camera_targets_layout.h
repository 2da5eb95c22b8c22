// SPDX-License-Identifier: Apache-2.0
// Where the cups of a scene are and how its tip moves, drawn from the attempt's seed.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/scene/scene.h"
#include "sim_core/world/part/camera_targets_view.h"

namespace fulcrum {

/// The scene has camera targets and a camera. Throws InputError where the cups do not fit.
std::vector<CameraTarget> place_camera_targets(const Scene& scene, std::uint64_t seed);

/// One sine along each axis: smooth, never faster than the scene allows.
struct TipPath {
    Vector3 centre = Vector3::Zero(), extent = Vector3::Zero();  ///< m
    Vector3 rate = Vector3::Zero(), phase = Vector3::Zero();     ///< rad/s; rad
    Vector3 at(double time) const noexcept;
    Vector3 velocity(double time) const noexcept;
};
TipPath draw_tip_path(const CameraTargetsSpec& spec, std::uint64_t seed);

}  // namespace fulcrum
