// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated pathology report of an attempt that leaves a specimen, and where to save it.
#pragma once

#include <QFrame>
#include <optional>

#include "assessment/pathology/pathology.h"

class QGridLayout;
class QLabel;
class QTableWidget;

namespace fulcrum::ui {

class ExportRow;

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
    QGridLayout* lines_;
    QTableWidget* table_;
    QLabel* legend_;
    ExportRow* export_;
};

}  // namespace fulcrum::ui
