// SPDX-License-Identifier: GPL-3.0-or-later
// Below the replay and its charts: the part of the attempt that was chosen, there or here, and its metrics
// next to those of the whole.
#pragma once

#include <QFrame>
#include <memory>

#include "ui/review/part_choice.h"

class QPushButton;

namespace fulcrum::ui {

struct AttemptModel;

class PartCard : public QFrame {
    Q_OBJECT
  public:
    explicit PartCard(QWidget* parent = nullptr);
    /// Nothing is chosen, and nothing can be until the record is there. `task`: null where the program lacks
    /// it.
    void open(std::shared_ptr<const AttemptModel> model, const TaskDefinition* task);
    /// `model` has the whole record. `scene`: that of the attempt; none: a part has no metrics.
    void set_record(std::shared_ptr<const AttemptModel> model, const std::optional<Scene>& scene);
    void close();
    void choose(double from, double to) { part_->choose(from, to); }
    void set_moment(double time) { part_->set_moment(time); }
    bool is_ready() const { return !measure_->is_running(); }

  signals:
    /// To be shaded; to <= from: none.
    void part_changed(double from, double to);
    void zoom_wanted(double from, double to);
    void time_chosen(double time);
    void failed(const QString& why);

  private:
    void show_part();
    std::shared_ptr<const AttemptModel> model_;
    std::optional<TaskDefinition> task_;
    std::optional<Scene> scene_;
    PartChoice* part_;
    PartMeasure* measure_;
    QPushButton* zoom_;
    ComparisonTable* table_;
};

}  // namespace fulcrum::ui
