// SPDX-License-Identifier: Apache-2.0
// The room in which a device can be moved, and what of a scene can be reached from it. Device frame
// (docs/DEVICES.md, Frames), m.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

struct WorkspaceBox {
    Vector3 least = Vector3::Zero(), most = Vector3::Zero();
    Vector3 size() const { return most - least; }
    Vector3 centre() const { return 0.5 * (least + most); }
    /// Grown to hold this place.
    void add(const Vector3& place) {
        least = least.cwiseMin(place);
        most = most.cwiseMax(place);
    }
};

/// Finite, each edge from 1 cm to 4 m, within 10 m of the origin.
bool is_usable(const WorkspaceBox& box);

/// The next three: `scene` is where the handle has to go, from where the instrument begins, with movements of
/// the instrument as large as those of the device. `motion`: movement of the instrument over that of the
/// device.
///
/// Smallest scale with which the device can reach all of it.
double scale_to_fit(const WorkspaceBox& workspace, const WorkspaceBox& scene);
/// Where the device has to be when the instrument begins so that the scene is in the middle of its workspace.
Vector3 place_to_begin(const WorkspaceBox& workspace, const WorkspaceBox& scene, double motion);
/// What the device has to reach if the instrument begins with it at `begun`.
WorkspaceBox needed(const WorkspaceBox& scene, double motion, const Vector3& begun);
/// Share of that which is in the workspace: 0 to 1.
double reached_share(const WorkspaceBox& workspace, const WorkspaceBox& scene, double motion,
                     const Vector3& begun);

}  // namespace fulcrum
