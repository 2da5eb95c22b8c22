// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of an attempt is looked at: one of its steps, or from one moment to another; and the metrics of
// parts, measured in the background. Used wherever a part can be chosen.
#pragma once

#include <QWidget>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "assessment/task/task.h"
#include "assessment/trace/phase_alignment.h"
#include "database/rows/trace_codec.h"
#include "sim_core/scene/scene.h"
#include "ui/review/comparison_table.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace fulcrum::ui {

class BackgroundJob;

class PartChoice : public QWidget {
    Q_OBJECT
  public:
    /// Object names begin with `prefix`.
    explicit PartChoice(const QString& prefix, QWidget* parent = nullptr);
    /// The steps that were completed. `first`, `last`: of the record, s; `usable`: there is one; `task`: null
    /// where the program lacks it.
    void open(const PhaseMoments& moments, const TaskDefinition* task, double first, double last,
              bool usable);
    /// s; to <= from, or too short a part: the whole attempt. Emits part_changed.
    void choose(double from, double to);
    /// Where a part begins or ends that the buttons choose.
    void set_moment(double time) { moment_ = time; }
    bool is_part() const { return to_ > from_; }
    double from() const { return from_; }
    double to() const { return to_; }
    /// Next to the times of the part; nothing without a part.
    void set_note(const QString& note);

  signals:
    void part_changed();
    /// A step was chosen, which begins there.
    void step_begins(double time);

  private:
    void choose_step(int index);
    void show_words();
    double from_ = 0, to_ = 0, moment_ = 0, first_ = 0, last_ = 0;
    bool usable_ = false;
    QString note_;
    QComboBox* step_;
    QPushButton *begin_, *end_, *whole_;
    QLabel* words_;
};

/// A part of a record.
struct MeasuredPart {
    std::shared_ptr<const database::Trace> trace;
    std::optional<Scene> scene;  ///< none: it cannot be measured
    std::uint64_t seed = 0;
    double from = 0, to = 0;  ///< s
};

/// Only the newest wish is measured.
class PartMeasure : public QObject {
    Q_OBJECT
  public:
    explicit PartMeasure(QObject* parent) : QObject(parent) {}
    void measure(std::vector<MeasuredPart> parts, const TaskDefinition& task);
    void cancel();
    bool is_running() const { return job_ != nullptr; }

  signals:
    /// In the order of the parts; empty where one cannot be measured.
    void measured(const std::vector<std::vector<ComparedMetric>>& metrics);
    void failed(const QString& why);

  private:
    BackgroundJob* job_ = nullptr;
    const std::shared_ptr<std::mutex> one_at_a_time_ = std::make_shared<std::mutex>();
};

}  // namespace fulcrum::ui
