// SPDX-License-Identifier: GPL-3.0-or-later
// The metrics of two attempts, or of an attempt and a cohort, line by line with their difference.
#pragma once

#include <QWidget>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/trace/phase_alignment.h"
#include "database/rows/attempt_records.h"

class QTableWidget;

namespace fulcrum::ui {

/// A metric of one attempt, of all tissues together.
struct ComparedMetric {
    std::string id;
    int version = 1;  ///< of the definition that measured it
    std::string hand, unit;
    Direction direction = Direction::context;
    std::optional<double> value;
    Statement why_absent;
};
/// Those of `wanted` (ids; empty: all).
std::vector<ComparedMetric> compared_metrics(const std::vector<database::MetricRow>& rows,
                                             const std::vector<std::string>& wanted);
std::vector<ComparedMetric> compared_metrics(const std::vector<MetricResult>& rows);

using MetricSpreads = std::map<std::pair<std::string, std::string>, Spread>;

class ComparisonTable : public QWidget {
  public:
    explicit ComparisonTable(const char* name = "comparison_table", QWidget* parent = nullptr);
    /// Rows that both lack are left out. Values of two versions of a metric have no difference, and neither
    /// is better.
    void show_pair(const std::vector<ComparedMetric>& own, const std::vector<ComparedMetric>& other);
    /// `cohort`: of the versions of `own`.
    void show_cohort(const std::vector<ComparedMetric>& own, const MetricSpreads& cohort);
    /// A part next to the whole of one attempt; neither is better than the other. A whole that another
    /// version of the metric measured is left out.
    void show_part(const std::vector<ComparedMetric>& part, const std::vector<ComparedMetric>& whole);
    void clear();

  private:
    int add_row(const ComparedMetric& metric);
    QTableWidget* table_;
};

}  // namespace fulcrum::ui
