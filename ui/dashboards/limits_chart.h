// SPDX-License-Identifier: GPL-3.0-or-later
// The limits of benchmark sets next to each other: for each gate an axis with the values of attempts as dots
// and the limit of each set as a line with the set's letter. And the two groups of a pass mark as curves.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "assessment/learning/contrasting_groups.h"
#include "ui/charts/chart_table.h"

namespace fulcrum::ui {

/// "A", "B", … of the sets that are compared.
QString set_letter(std::size_t set);

struct GateLimits {
    QString name;  ///< of the metric, with hand and tissue
    QString unit;
    bool higher_is_better = false;
    std::vector<std::optional<double>> limits;  ///< by set
    std::vector<double> values;                 ///< of attempts
};

class LimitsChart : public QWidget, public TabledChart {
  public:
    explicit LimitsChart(QWidget* parent = nullptr);
    void show_gates(std::vector<GateLimits> gates);
    const std::vector<GateLimits>& gates() const { return gates_; }
    /// A row for each limit and for each value.
    ChartTable table() const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {280, sizeHint().height()}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    double row_height() const;
    void paint_gate(QPainter& painter, const GateLimits& gate, const QRectF& room) const;
    std::vector<GateLimits> gates_;
};

/// Two groups on the scale of a metric.
struct GroupCurves {
    QString unit;
    bool logarithmic = false;  ///< the groups are spread on the logarithm of the value
    GroupSpread experts, others;
    std::optional<PassMark> mark;
};

class GroupsChart : public QWidget, public TabledChart {
  public:
    explicit GroupsChart(QWidget* parent = nullptr);
    void show_groups(std::optional<GroupCurves> groups);
    ChartTable table() const override;
    QSize sizeHint() const override { return {360, 200}; }
    QSize minimumSizeHint() const override { return {260, 160}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::optional<GroupCurves> groups_;
};

}  // namespace fulcrum::ui
