// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort as six pictures, each with its table one click away; a click on a part of a picture lists the
// people behind it, and a click on a person opens their progress. Of the same query as the cohort page, the
// exports and the first page of the cohort PDF.
#pragma once

#include <optional>

#include "database/records/report_data.h"
#include "ui/page/context.h"
#include "ui/reports/dashboard_pictures.h"
#include "ui/reports/report.h"

class QComboBox;
class QLabel;
class QSpinBox;

namespace fulcrum::ui {

class ChartFrame;
class ExportRow;
class FigureChart;
class JobBar;
class StationNote;
class StoreReading;

class DashboardPage : public Page {
    Q_OBJECT
  public:
    explicit DashboardPage(Context& context);
    void enter() override;
    void leave() override;
    /// Gathers and writes on a worker thread, with progress and a way to stop.
    void export_to(const QString& path, ReportFormat format);

  signals:
    void exported(const QString& path);

  private:
    /// One of the pictures.
    struct Picture {
        DashboardPart part = DashboardPart::plan;
        ChartFrame* frame = nullptr;
        FigureChart* chart = nullptr;
        QLabel* words = nullptr;
    };
    QLayout* make_choices();
    QWidget* make_picture(Picture& picture);
    /// Reads the chosen cohort in the background; what is shown of it stays until then.
    void load();
    void show_table(database::CohortTable table, const Curriculum& curriculum);
    void show_pictures();
    void show_picture(const Picture& picture);
    void choose_part(const Picture& picture, const QString& key);
    /// `key`: a person's id, a blank and a task's.
    void open_person(const QString& key);

    std::optional<database::CohortTable> data_;
    database::CohortDashboard dashboard_;
    Curriculum curriculum_;  ///< `data_` was read with it
    DashboardNames names_;
    QComboBox *cohort_, *task_ = nullptr;
    QSpinBox* plan_;
    QLabel* summary_;
    QWidget* pictures_holder_;
    ExportRow* export_;
    JobBar* job_;
    StationNote* note_;
    StoreReading* reading_;
    std::vector<Picture> pictures_;
};

}  // namespace fulcrum::ui
