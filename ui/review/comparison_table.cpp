// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/comparison_table.h"

#include <QCoreApplication>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

enum ComparedColumn {
    metric_column,
    of_hand_column,
    own_column,
    other_column,
    difference_column,
    verdict_column
};

struct CompareWords {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::ComparisonTable)
};

QString signed_figure(double value) {
    return (value > 0 ? QStringLiteral("+") : QString()) + figure(value);
}

/// The difference, and its share of the other value where that is one.
QString difference_text(double own, double other, const std::string& unit) {
    const double difference = own - other;
    QString words = signed_figure(difference);
    if (const QString of = unit_text(unit); !of.isEmpty()) words += QLatin1Char(' ') + of;
    if (std::abs(other) > 1e-9 && own * other > 0)
        words += QStringLiteral(" (%1 %)").arg(signed_figure(100 * difference / std::abs(other)));
    return words;
}

/// As a gate would judge them: of some metrics with a sign the size alone counts.
void set_verdict(QTableWidget* table, int row, const ComparedMetric& metric, double own, double other) {
    double precision = 0;
    if (const MetricDescriptor* known = find_metric(metric.id)) {
        own = gated_value(*known, own);
        other = gated_value(*known, other);
        precision = known->precision;
    }
    if (metric.direction == Direction::context || std::abs(own - other) < precision) {
        table->setItem(row, verdict_column, make_cell(CompareWords::tr("–")));
        return;
    }
    const bool better = (own < other) == (metric.direction == Direction::lower);
    auto* cell = make_cell(better ? CompareWords::tr("✓ better") : CompareWords::tr("✕ worse"));
    set_tint(cell, better ? Tint::good : Tint::bad);
    table->setItem(row, verdict_column, cell);
}

QTableWidgetItem* value_cell(const ComparedMetric& metric) {
    auto* cell = make_cell(figure_with_unit(metric.value, metric.unit), Qt::AlignRight | Qt::AlignVCenter);
    if (!metric.value) cell->setToolTip(statement_text(metric.why_absent));
    return cell;
}

QString other_version_text() {
    return CompareWords::tr("measured by another version of the metric");
}

const ComparedMetric* find_compared(const std::vector<ComparedMetric>& rows, const ComparedMetric& like) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const ComparedMetric& one) {
        return one.id == like.id && one.hand == like.hand;
    });
    return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::vector<ComparedMetric> compared_metrics(const std::vector<database::MetricRow>& rows,
                                             const std::vector<std::string>& wanted) {
    std::vector<ComparedMetric> shown;
    for (const database::MetricRow& row : rows) {
        const bool asked = wanted.empty() || std::find(wanted.begin(), wanted.end(), row.id) != wanted.end();
        if (asked && row.tissue.empty())
            shown.push_back(
                {row.id, row.version, row.hand, row.unit, row.direction, row.value, row.absent_because});
    }
    return shown;
}

std::vector<ComparedMetric> compared_metrics(const std::vector<MetricResult>& rows) {
    std::vector<ComparedMetric> shown;
    for (const MetricResult& row : rows)
        if (row.tissue.empty())
            shown.push_back(
                {row.id, row.version, row.hand, row.unit, row.direction, row.value, row.absent_because});
    return shown;
}

ComparisonTable::ComparisonTable(const char* name, QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    table_ = make_table({CompareWords::tr("Metric"), CompareWords::tr("Hand"),
                         CompareWords::tr("This attempt"), CompareWords::tr("Other attempt"),
                         CompareWords::tr("Difference"), CompareWords::tr("This attempt is")},
                        name);
    table_->setAccessibleName(CompareWords::tr("Differences of the metrics"));
    table_->setMinimumHeight(12 * fontMetrics().height());
    layout->addWidget(table_);
}

void ComparisonTable::clear() {
    table_->setRowCount(0);
}

int ComparisonTable::add_row(const ComparedMetric& metric) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    const MetricDescriptor* known = find_metric(metric.id);
    auto* name = make_cell(metric_text(metric.id));
    if (known != nullptr) name->setToolTip(metric_words(known->explanation));
    table_->setItem(row, metric_column, name);
    table_->setItem(row, of_hand_column,
                    make_cell(metric.hand == "left"    ? CompareWords::tr("left")
                              : metric.hand == "right" ? CompareWords::tr("right")
                                                       : QString()));
    table_->setItem(row, own_column, value_cell(metric));
    for (const int column : {other_column, difference_column, verdict_column})
        table_->setItem(row, column, make_cell(QStringLiteral("–"), Qt::AlignRight | Qt::AlignVCenter));
    return row;
}

void ComparisonTable::show_pair(const std::vector<ComparedMetric>& own,
                                const std::vector<ComparedMetric>& other) {
    clear();
    for (const ComparedMetric& metric : own) {
        const ComparedMetric* against = find_compared(other, metric);
        if (!metric.value && (against == nullptr || !against->value)) continue;
        const int row = add_row(metric);
        if (against == nullptr) continue;
        table_->setItem(row, other_column, value_cell(*against));
        if (!metric.value || !against->value) continue;
        if (metric.version != against->version) {
            table_->setItem(row, verdict_column, make_cell(other_version_text()));
            continue;
        }
        table_->setItem(row, difference_column,
                        make_cell(difference_text(*metric.value, *against->value, metric.unit),
                                  Qt::AlignRight | Qt::AlignVCenter));
        set_verdict(table_, row, metric, *metric.value, *against->value);
    }
    table_->horizontalHeaderItem(other_column)->setText(CompareWords::tr("Other attempt"));
    fit_columns(table_);
}

void ComparisonTable::show_cohort(const std::vector<ComparedMetric>& own, const MetricSpreads& cohort) {
    clear();
    for (const ComparedMetric& metric : own) {
        const auto of = cohort.find({metric.id, metric.hand});
        if (!metric.value && of == cohort.end()) continue;
        const int row = add_row(metric);
        if (of == cohort.end()) continue;
        const Spread& spread = of->second;
        table_->setItem(row, other_column,
                        make_cell(CompareWords::tr("%1 (%2 to %3)")
                                      .arg(figure_with_unit(spread.middle, metric.unit), figure(spread.low),
                                           figure(spread.high)),
                                  Qt::AlignRight | Qt::AlignVCenter));
        if (!metric.value) continue;
        table_->setItem(row, difference_column,
                        make_cell(difference_text(*metric.value, spread.middle, metric.unit),
                                  Qt::AlignRight | Qt::AlignVCenter));
        if (*metric.value >= spread.low && *metric.value <= spread.high)
            table_->setItem(row, verdict_column, make_cell(CompareWords::tr("in the middle half")));
        else
            set_verdict(table_, row, metric, *metric.value, spread.middle);
    }
    table_->horizontalHeaderItem(other_column)->setText(CompareWords::tr("Cohort: median (middle half)"));
    fit_columns(table_);
}

void ComparisonTable::show_part(const std::vector<ComparedMetric>& part,
                                const std::vector<ComparedMetric>& whole) {
    clear();
    for (const int column : {difference_column, verdict_column}) table_->setColumnHidden(column, true);
    for (const ComparedMetric& metric : part) {
        const ComparedMetric* all = find_compared(whole, metric);
        if (!metric.value && (all == nullptr || !all->value)) continue;
        const int row = add_row(metric);
        if (all == nullptr) continue;
        if (metric.version == all->version)
            table_->setItem(row, other_column, value_cell(*all));
        else
            table_->item(row, other_column)->setToolTip(other_version_text());
    }
    table_->horizontalHeaderItem(own_column)->setText(CompareWords::tr("Part"));
    table_->horizontalHeaderItem(other_column)->setText(CompareWords::tr("Whole attempt"));
    table_->setAccessibleName(CompareWords::tr("Metrics of the part"));
    fit_columns(table_);
}

}  // namespace fulcrum::ui
