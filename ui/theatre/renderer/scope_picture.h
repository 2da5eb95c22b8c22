// SPDX-License-Identifier: GPL-3.0-or-later
// The renderer's pixels as a scope shows them: a round image, darker towards its rim, in a black frame with a
// small notch that marks up. Painted in software, so that a window need not be composed by OpenGL.
#pragma once

#include <QImage>
#include <QPainter>
#include <QRect>

namespace fulcrum::ui {

class ScopePicture {
  public:
    /// Fills `area` (device-independent pixels): the square picture in its middle, as large as fits, black
    /// around it.
    void paint(QPainter& painter, const QRect& area, const QImage& picture);

  private:
    QImage frame_;  // black, as opaque as the frame and the lens's own vignette hide the picture
};

}  // namespace fulcrum::ui
