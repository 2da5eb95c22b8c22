// SPDX-License-Identifier: GPL-3.0-or-later
// From a scene and the world's snapshots to what the renderer draws: the one place that both the theatre and
// the replay use.
#pragma once

#include <memory>

#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"
#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

/// Geometry of one scene, ready to be drawn. Construction is heavy (about a second with a bowel): build it on
/// any thread, then use it from one.
class SceneAssembler {
  public:
    /// `first`: any snapshot of that scene (its ring arc lengths place the cage). Throws InputError.
    SceneAssembler(const Scene& scene, const WorldSnapshot& first);
    ~SceneAssembler();

    /// Hands geometry and textures to a renderer.
    void install(SceneRenderer& renderer) const;
    /// Deforms the surfaces to the snapshot. The frame points into this object and is valid until the next
    /// call. Target looks are `waiting`, tool strains 0: the caller sets what the task knows.
    SceneFrame& assemble(const WorldSnapshot& snapshot);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fulcrum::ui
