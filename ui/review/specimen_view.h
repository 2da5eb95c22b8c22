// SPDX-License-Identifier: GPL-3.0-or-later
// The specimen map on the screen. Each sector is a button with an accessible name: click, or arrow keys and
// Return, choose it. Tab reaches the map once. In its place the specimen can be shown in three dimensions
// (specimen_solid.h), with the same labels, legend and colours.
#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <vector>

#include "assessment/pathology/pathology.h"

namespace fulcrum::ui {

class SpecimenSolid;

class SpecimenCell : public QAbstractButton {
    Q_OBJECT
  public:
    SpecimenCell(const PathologyReport& report, const SectorFinding& finding, QWidget* parent);

  signals:
    /// An arrow key: by levels and sectors.
    void move_wanted(int levels, int sectors);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
};

class SpecimenView : public QWidget {
    Q_OBJECT
  public:
    explicit SpecimenView(QWidget* parent = nullptr);
    void open(const PathologyReport& report);
    /// In place of levels and sectors.
    void show_solid(bool solid);
    bool has_sectors() const { return !cells_.empty(); }
    QSize sizeHint() const override;

  signals:
    /// Index of the report's findings.
    void sector_chosen(int finding);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void arrange();
    void move(int from, int levels, int sectors);
    double least_grid() const;
    PathologyReport report_;
    std::vector<SpecimenCell*> cells_;
    SpecimenSolid* solid_;
};

}  // namespace fulcrum::ui
