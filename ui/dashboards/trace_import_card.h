// SPDX-License-Identifier: GPL-3.0-or-later
// A trace that a box trainer, a robot or another simulator recorded, for a person of the educator's cohorts:
// what was understood of the file is shown before anything is stored.
#pragma once

#include <QFrame>
#include <functional>
#include <memory>

#include "database/scoring/external_import.h"
#include "ui/page/context.h"

class QComboBox;
class QFileDialog;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class BackgroundJob;
class FlowRow;
class JobBar;

class TraceImportCard : public QFrame {
    Q_OBJECT
  public:
    explicit TraceImportCard(Context& context);
    ~TraceImportCard() override;
    /// The people of today, and the delivered mappings.
    void enter();
    /// Stops what runs; what was stored stays.
    void stop();

    /// Scrolls the page to a part of it, once that has its place.
    static void bring(QWidget* part);

  signals:
    void imported(const QString& attempt_id);

  private:
    QWidget* file_row();
    QWidget* person_row();
    QWidget* preview();
    QWidget* add_field(FlowRow* row, const QString& label, QWidget* field, const char* name);
    void choose_trace();
    void choose_mapping();
    void mapping_changed(int index);
    /// Reads the trace and shows what was understood.
    void look();
    void show_preview();
    void store();
    /// What is shown belongs to the file and the mapping that were read.
    void forget();
    void show_problem(const QString& why);
    /// In the background, with both buttons out of use. `done`: it has ended by itself; `stopped`: by Cancel.
    void run(const QString& line, std::function<void(const Progress&)> work, std::function<void()> done,
             std::function<void()> stopped = {});
    void set_busy(bool busy);

    Context& context_;
    std::shared_ptr<const ExternalTrace> read_;
    QLineEdit *path_, *exercise_, *performed_;
    QComboBox *mapping_, *person_;
    QPushButton *look_, *import_;
    QLabel *problem_, *summary_, *notes_;
    QTableWidget* columns_;
    QWidget* details_;
    JobBar* bar_;
    BackgroundJob* job_ = nullptr;
    int mapping_before_ = 0;
};

}  // namespace fulcrum::ui
