// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/metrics_table.h"

#include <QTableWidget>

#include "assessment/metrics/registry.h"
#include "ui/review/attempt_model.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

enum Column {
    name_column,
    hand_column,
    tissue_column,
    value_column,
    better_column,
    absent_column,
    explain_column
};
constexpr int metric_role = Qt::UserRole + 20;  // of a table's item: the id of the metric it explains

}  // namespace

void set_explain_cell(QTableWidget* table, int row, int column, const std::string& metric_id) {
    const QString name = metric_text(metric_id);
    auto* cell = make_cell(MetricsTable::tr("Explain"));
    cell->setToolTip(MetricsTable::tr("What %1 measures").arg(name));
    cell->setData(Qt::AccessibleTextRole, MetricsTable::tr("Explain %1").arg(name));
    cell->setData(metric_role, text(metric_id));
    QFont font = table->font();
    font.setUnderline(true);
    cell->setFont(font);
    table->setItem(row, column, cell);
}

QString explained_metric(const QTableWidget* table, int row, int column) {
    const QTableWidgetItem* cell = table->item(row, column);
    return cell == nullptr ? QString() : cell->data(metric_role).toString();
}

MetricsTable::MetricsTable(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->addWidget(
        make_label(tr("Select a row to go to its moment, or Explain to read what is measured."), "muted"));
    table_ = make_table({tr("Metric"), tr("Hand"), tr("Tissue"), tr("Value"), tr("Direction"),
                         tr("Why absent"), tr("Meaning")},
                        "metrics_table");
    table_->setAccessibleName(tr("All metrics"));
    table_->setMinimumHeight(320);
    layout->addWidget(table_);
    const auto choose = [this](QTableWidgetItem* item) {
        const QString metric = explained_metric(table_, item->row(), item->column());
        if (!metric.isEmpty()) return emit metric_chosen(metric);
        const QVariant time = table_->item(item->row(), name_column)->data(Qt::UserRole);
        if (time.isValid()) emit time_chosen(time.toDouble());
    };
    connect(table_, &QTableWidget::itemActivated, this, choose);
    connect(table_, &QTableWidget::itemClicked, this, choose);
}

void MetricsTable::open(const AttemptModel& model) {
    table_->setRowCount(0);
    if (!model.score) return;
    for (const database::MetricRow& value : model.score->metrics) {
        const MetricDescriptor* metric = find_metric(value.id);
        const int row = table_->rowCount();
        table_->insertRow(row);
        auto* first = make_cell(metric_text(value.id));
        first->setToolTip(
            (metric == nullptr ? QString() : metric_words(metric->explanation) + QLatin1Char('\n')) +
            tr("%1, version %2").arg(text(value.id)).arg(value.version));
        if (!value.evidence.empty()) first->setData(Qt::UserRole, value.evidence.front().first);
        table_->setItem(row, name_column, first);
        table_->setItem(row, hand_column,
                        make_cell(value.hand == "left"    ? tr("left")
                                  : value.hand == "right" ? tr("right")
                                                          : QString()));
        table_->setItem(row, tissue_column, make_cell(asset_text(value.tissue)));
        table_->setItem(
            row, value_column,
            make_cell(figure_with_unit(value.value, value.unit), Qt::AlignRight | Qt::AlignVCenter));
        table_->setItem(row, better_column,
                        make_cell(value.direction == Direction::lower    ? tr("↓ lower")
                                  : value.direction == Direction::higher ? tr("↑ higher")
                                                                         : tr("context")));
        table_->setItem(row, absent_column, make_cell(statement_text(value.absent_because)));
        set_explain_cell(table_, row, explain_column, value.id);
    }
    fit_columns(table_);
}

}  // namespace fulcrum::ui

#include "moc_metrics_table.cpp"
