// SPDX-License-Identifier: GPL-3.0-or-later
// How likely trainees are to be declared proficient by a pass rule, over the number of their attempts: one
// curve for each share of attempts that a trainee passes, thick for a rule that is tried, thin and dashed for
// the one in force. Curves differ by marks as well as by colour.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "ui/charts/chart_table.h"

namespace fulcrum::ui {

/// Of three trainees, the share of attempts that each passes.
inline constexpr std::array<double, 3> designer_trainees = {0.9, 0.7, 0.5};
inline constexpr int designer_attempts = 60;

struct PassRuleCurves {
    /// By trainee: chance after 1, 2, ... attempts.
    std::array<std::vector<double>, designer_trainees.size()> tried, in_force;
    bool changed = false;  ///< the two differ; else only one is drawn
};

class PassRuleChart : public QWidget, public TabledChart {
  public:
    explicit PassRuleChart(QWidget* parent = nullptr);
    void show_curves(PassRuleCurves curves);
    const PassRuleCurves& curves() const { return curves_; }
    ChartTable table() const override;
    QSize sizeHint() const override { return {520, 300}; }
    QSize minimumSizeHint() const override { return {320, 220}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    PassRuleCurves curves_;
};

}  // namespace fulcrum::ui
