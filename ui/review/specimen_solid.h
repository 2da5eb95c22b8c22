// SPDX-License-Identifier: GPL-3.0-or-later
// The specimen in three dimensions, with the colours of its map: a cylinder whose back half is the cut
// surface, sector by sector, with defects as pits and undivided ground hatched. Turned with the mouse or the
// arrow keys, Home turns it back; a click on a sector chooses it. Drawn with QPainter: it needs no graphics
// card.
#pragma once

#include <QPolygonF>
#include <QWidget>
#include <vector>

#include "assessment/pathology/pathology.h"

namespace fulcrum::ui {

/// Where one looks from: 0, 0 is straight from behind.
struct SolidPose {
    double yaw = 0;    ///< rad, about the long axis
    double pitch = 0;  ///< rad, positive: from above (cranial)
};
/// A part of the surface as it is seen; `finding` of the report, -1: not judged.
struct SolidFace {
    QPolygonF outline;
    int finding = -1;
};
/// The sectors of the report that face the viewer, for a specimen drawn into `area`.
std::vector<SolidFace> facing_sectors(const PathologyReport& report, const SolidPose& pose,
                                      const QRectF& area);

class SpecimenSolid : public QWidget {
    Q_OBJECT
  public:
    explicit SpecimenSolid(QWidget* parent = nullptr);
    void open(const PathologyReport& report);
    void choose(int finding);  ///< is outlined; -1: none
    const SolidPose& pose() const { return pose_; }
    /// Into which the specimen is drawn.
    QRectF area() const;

  signals:
    /// Index of the report's findings.
    void sector_chosen(int finding);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    void turn(double yaw, double pitch);
    void turned();
    PathologyReport report_;
    SolidPose pose_;
    int chosen_ = -1;
    QPoint last_;
    bool dragged_ = false;
};

}  // namespace fulcrum::ui
