// SPDX-License-Identifier: GPL-3.0-or-later
// What the scene is drawn with on this machine, how finely, and why.
#pragma once

#include <QFrame>

class QLabel;

namespace fulcrum::ui {

struct PictureQuality;

class PictureCard : public QFrame {
    Q_OBJECT
  public:
    explicit PictureCard(QWidget* parent = nullptr);
    static QString picture_text(const PictureQuality& quality);

  protected:
    /// Looks when it is shown for the first time: it takes an OpenGL context.
    void showEvent(QShowEvent* event) override;

  private:
    QLabel* picture_;
};

}  // namespace fulcrum::ui
