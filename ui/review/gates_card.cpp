// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/gates_card.h"

#include <QEvent>
#include <QHeaderView>
#include <QStyle>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <algorithm>

#include "assessment/metrics/registry.h"
#include "ui/review/attempt_model.h"
#include "ui/review/metrics_table.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int least_source_width = 220;  // px: fewer break a source into more lines than can be read

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
    table_->setAccessibleName(tr("Gates"));
    layout->addWidget(table_);
    sources_ = make_label({}, "muted");
    sources_->setObjectName(QStringLiteral("gates_sources"));
    layout->addWidget(sources_);
    layout->addWidget(make_label(
        tr("A gate is a pass criterion: every gate must be met. z: standard deviations from the experts' "
           "mean. Select a row to go to the moment that decided it, or Explain to read what is measured."),
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
    std::vector<std::pair<QString, QStringList>> sources;  // each with the gates that have it
    setVisible(model.score.has_value() && !model.score->gates.empty());
    if (!model.score) return;
    for (const database::GateRow& gate : model.score->gates) {
        const MetricDescriptor* metric = find_metric(gate.metric);
        const int row = table_->rowCount();
        table_->insertRow(row);
        QString name = metric_text(gate.metric);
        if (!gate.tissue.empty()) name += QStringLiteral(", ") + asset_text(gate.tissue);
        auto* first = make_cell(name);
        if (metric != nullptr) first->setToolTip(metric_words(metric->explanation));
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
        QString source =
            judged ? limit_source_text(gate.limit_source) : statement_text(gate.not_passed_because);
        if (gate.provisional)
            source = judged ? tr("provisional: %1").arg(source) : tr("%1 (limit provisional)").arg(source);
        auto* source_cell = make_cell(source);
        source_cell->setToolTip(source);
        auto same = std::find_if(sources.begin(), sources.end(),
                                 [&](const auto& one) { return one.first == source; });
        if (same == sources.end()) same = sources.insert(sources.end(), {source, {}});
        if (!same->second.contains(name)) same->second += name;
        set_explain_cell(table_, row, 6, gate.metric);
        table_->setItem(row, 7, source_cell);
    }
    QStringList lines;
    for (const auto& [source, names] : sources)
        if (!source.isEmpty()) lines += tr("%1: %2").arg(names.join(QStringLiteral(", ")), source);
    sources_->setText(tr("Source of each limit") + QLatin1Char('\n') + lines.join(QLatin1Char('\n')));
    table_->setColumnHidden(table_->columnCount() - 1, false);
    size_columns(table_, 2);  // words need the room more than figures
    others_ = 0;
    for (int column = 0; column + 1 < table_->columnCount(); ++column) others_ += table_->columnWidth(column);
    last_but_one_ = table_->columnWidth(table_->columnCount() - 2);
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
    // Where no column is left for the sources, they follow the table.
    const int room = table_->viewport()->width() - others_;
    const bool narrow = room < with_text(least_source_width);
    table_->setColumnHidden(last, narrow);
    sources_->setVisible(narrow);
    header->resizeSection(last - 1, narrow ? last_but_one_ + std::max(0, room) : last_but_one_);
    if (!narrow) header->resizeSection(last, room);
    fit_rows(table_);
    table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                           table_->verticalHeader()->length() + 2 * table_->frameWidth());
}

}  // namespace fulcrum::ui

#include "moc_gates_card.cpp"
