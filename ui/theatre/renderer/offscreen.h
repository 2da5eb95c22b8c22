// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL context without a window: the theatre paints what is drawn in it, and pictures that nobody
// watches are made in it.
#pragma once

#include <memory>

#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

/// Keeps its context, so that many pictures of one renderer cost one upload. Needs a QGuiApplication whose
/// platform offers OpenGL. release() the renderer while the stage lives, with make_current().
class OffscreenStage {
  public:
    /// Throws std::runtime_error where no context can be made.
    OffscreenStage();
    ~OffscreenStage();
    void make_current();
    /// As SceneRenderer::draw. Throws std::runtime_error where the renderer cannot start.
    const QImage& draw(SceneRenderer& renderer, const SceneFrame& frame, QSize size);
    /// As a scope shows it, in its frame; of a figure the whole rectangle.
    QImage picture(SceneRenderer& renderer, const SceneFrame& frame, QSize size);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fulcrum::ui
