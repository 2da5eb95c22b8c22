// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/gates_card.h"

#include <QEvent>
#include <QHeaderView>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QTableWidget>

#include "assessment/metrics/registry.h"
#include "ui/review/attempt_model.h"
#include "ui/review/metrics_table.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// Qt reckons a wrapped cell's height from the whole column's width, the style sheet's padding included,
/// where no word can stand; the last line was then cut off.
class WrappedCell : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyleOptionViewItem cell = option;
        initStyleOption(&cell, index);
        const QWidget* table = option.widget;
        const QStyle* style = table->style();
        constexpr int height = 1000;
        cell.rect = QRect(0, 0, option.rect.width(), height);
        const QRect room = style->subElementRect(QStyle::SE_ItemViewItemText, &cell, table);
        const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, table) + 1;
        // A pixel at either side for rounding.
        const QRect words(0, 0, std::max(1, room.width() - 2 * margin - 2), height);
        const int lines = cell.fontMetrics.boundingRect(words, Qt::TextWordWrap, cell.text).height();
        return {option.rect.width(), lines + height - room.height() + 4};
    }
};

}  // namespace

GatesCard::GatesCard(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Gates"), "heading"));
    table_ = make_table({tr("Gate"), tr("Hand"), tr("Value"), tr("Limit"), tr("z"), tr("Result"),
                         tr("Meaning"), tr("Source of the limit")},
                        "gates_table");
    // As high as its rows and as wide as the page: the last column's words take the lines they need.
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setWordWrap(true);
    table_->setItemDelegateForColumn(table_->columnCount() - 1, new WrappedCell(table_));
    table_->viewport()->installEventFilter(this);
    layout->addWidget(table_);
    layout->addWidget(make_label(tr("Every gate must be met. Select a row to jump to the moment that decided "
                                    "it, Explain to read what is "
                                    "measured."),
                                 "muted"));
    const auto jump = [this](QTableWidgetItem* item) {
        const QString metric = explained_metric(table_, item->row(), item->column());
        if (!metric.isEmpty()) return emit metric_chosen(metric);
        const QVariant time = table_->item(item->row(), 0)->data(Qt::UserRole);
        if (time.isValid()) emit time_chosen(time.toDouble());
    };
    connect(table_, &QTableWidget::itemActivated, this, jump);
    connect(table_, &QTableWidget::itemClicked, this, jump);
}

void GatesCard::open(const AttemptModel& model) {
    table_->setRowCount(0);
    setVisible(model.score.has_value() && !model.score->gates.empty());
    if (!model.score) return;
    for (const database::GateRow& gate : model.score->gates) {
        const MetricDescriptor* metric = find_metric(gate.metric);
        const int row = table_->rowCount();
        table_->insertRow(row);
        QString name = metric_text(gate.metric);
        if (!gate.tissue.empty()) name += QStringLiteral(", ") + asset_text(gate.tissue);
        auto* first = make_cell(name);
        if (metric != nullptr) first->setToolTip(text(metric->explanation));
        const database::MetricRow* values =
            find_metric_row(*model.score, gate.metric, gate.hand, gate.tissue);
        if (values != nullptr && !values->evidence.empty()) {
            first->setData(Qt::UserRole, values->evidence.front().first);
        }
        const bool higher = metric != nullptr && metric->direction == Direction::higher;
        QString limit = tr("none");  // no set has a level for it
        if (gate.limit) {
            limit = (higher ? QStringLiteral("≥ ") : QStringLiteral("≤ ")) +
                    figure_with_unit(gate.limit, gate.unit);
        }
        QString result = tr("– not assessed");
        if (gate.passed) result = *gate.passed ? tr("✓ met") : tr("✕ not met");
        auto* verdict_cell = make_cell(result);
        set_tint(verdict_cell, !gate.passed ? Tint::muted : *gate.passed ? Tint::good : Tint::bad);
        verdict_cell->setToolTip(statement_text(gate.not_passed_because));
        const Qt::Alignment right = Qt::AlignRight | Qt::AlignVCenter;
        table_->setItem(row, 0, first);
        table_->setItem(row, 1,
                        make_cell(gate.hand == "left"    ? tr("left")
                                  : gate.hand == "right" ? tr("right")
                                                         : QString()));
        table_->setItem(row, 2, make_cell(figure_with_unit(gate.value, gate.unit), right));
        table_->setItem(row, 3, make_cell(limit, right));
        table_->setItem(row, 4, make_cell(z_text(gate.z), right));
        table_->setItem(row, 5, verdict_cell);
        const bool judged = gate.value && gate.limit;
        QString source = judged ? asset_text(gate.limit_source) : statement_text(gate.not_passed_because);
        if (gate.provisional)
            source = judged ? tr("provisional: %1").arg(source) : tr("%1 (limit provisional)").arg(source);
        auto* source_cell = make_cell(source);
        source_cell->setToolTip(source);
        set_explain_cell(table_, row, 6, gate.metric);
        table_->setItem(row, 7, source_cell);
    }
    size_columns(table_, 2);  // words need the room more than figures
    fit();
}

bool GatesCard::eventFilter(QObject* watched, QEvent* event) {
    if (watched == table_->viewport() && event->type() == QEvent::Resize) fit();
    return QFrame::eventFilter(watched, event);
}

void GatesCard::fit() {
    QHeaderView* header = table_->horizontalHeader();
    header->setStretchLastSection(false);
    const int last = table_->columnCount() - 1;
    int others = 0;
    for (int column = 0; column < last; ++column) others += header->sectionSize(column);
    header->resizeSection(last, std::max(120, table_->viewport()->width() - others));
    fit_rows(table_);
    table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                           table_->verticalHeader()->length() + 2 * table_->frameWidth());
}

}  // namespace fulcrum::ui

#include "moc_gates_card.cpp"
