// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated pathology report of an attempt that leaves a specimen: the map first; a sector's numbers, and
// the whole report in words and as a table, one click behind it; and where to save it.
#pragma once

#include <QFrame>
#include <optional>

#include "assessment/pathology/pathology.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QRadioButton;
class QTableWidget;

namespace fulcrum::ui {

class ExportRow;

class SpecimenView;

class PathologyCard : public QFrame {
    Q_OBJECT
  public:
    explicit PathologyCard(QWidget* parent = nullptr);
    /// Hidden where there is no report; `file` is what a saved report would be called, none: it may not be.
    void open(const std::optional<PathologyReport>& report, const std::optional<QString>& file);

  signals:
    /// The moment of a defect or of the nearest margin.
    void time_chosen(double time);
    void save_wanted(const QString& path);

  private:
    void fill_numbers();
    void show_sector(int finding);
    void show_solid(bool solid);
    /// s of the attempt where the deepest defect of a sector was cut; none: it has no listed defect.
    std::optional<double> defect_time(const SectorFinding& finding) const;

    std::optional<PathologyReport> report_;
    double shown_time_ = -1;
    SpecimenView* map_;
    QLabel* sector_;
    QRadioButton *as_map_, *as_solid_;
    QPushButton *sector_show_, *numbers_button_;
    QWidget* numbers_;
    QGridLayout* lines_;
    QTableWidget* table_;
    QLabel* legend_;
    ExportRow* export_;
};

}  // namespace fulcrum::ui
