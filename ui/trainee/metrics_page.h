// SPDX-License-Identifier: GPL-3.0-or-later
// Every metric in plain words: what it measures, which way is better, in which tasks it is a gate, what to
// try when it is the worst. Straight from the registry, so that it cannot differ from what is computed.
#pragma once

#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class MetricsPage : public Page {
    Q_OBJECT
  public:
    explicit MetricsPage(Context& context);
    void enter() override;
    void leave() override;
    /// Selects a metric (an unknown id leaves the page as it is) and offers the way back to an attempt ("":
    /// none).
    void show_metric(const std::string& id, const QString& attempt_id, double time_s);

  private:
    void fill();
    void filter();
    void show_chosen();
    /// Tasks whose gates use the metric, with their hands and tissues left out: "A2, B1".
    QString gate_of(const std::string& metric) const;

    std::string wanted_;
    QString attempt_;
    double time_ = 0;
    QPushButton* back_;
    QLineEdit* search_;
    QTableWidget* table_;
    QLabel *name_, *explanation_, *details_;
};

}  // namespace fulcrum::ui
