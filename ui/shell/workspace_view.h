// SPDX-License-Identifier: GPL-3.0-or-later
// Where a device can be moved and what of a task's scene is reached from there: a view from above and one
// from the side, with the box that the scene needs and where the hand is.
#pragma once

#include <QWidget>
#include <optional>

#include "sim_core/instrument/workspace.h"

namespace fulcrum::ui {

/// Of one hand; device frame, m.
struct WorkspacePicture {
    WorkspaceBox workspace;
    std::optional<WorkspaceBox> scene;  ///< what has to be reached if the instrument begins at `begin`
    Vector3 begin = Vector3::Zero();
    std::optional<Vector3> hand;  ///< where it is now
};

class WorkspaceView : public QWidget {
    Q_OBJECT
  public:
    explicit WorkspaceView(QWidget* parent = nullptr);
    void show_picture(const QString& hand, const WorkspacePicture& picture);
    const WorkspacePicture& picture() const { return picture_; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString hand_;
    WorkspacePicture picture_;
};

}  // namespace fulcrum::ui
