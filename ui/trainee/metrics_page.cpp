// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/metrics_page.h"

#include <QHeaderView>
#include <QLineEdit>

#include "assessment/metrics/registry.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

enum Column { name_column, better_column, unit_column, gate_column, columns };

QString better(Direction direction) {
    switch (direction) {
        case Direction::lower:
            return MetricsPage::tr("lower is better");
        case Direction::higher:
            return MetricsPage::tr("higher is better");
        case Direction::context:
            break;
    }
    return MetricsPage::tr("for information only");
}

QString evidence(EvidenceGrade grade) {
    switch (grade) {
        case EvidenceGrade::strong:
            return MetricsPage::tr("strong (several studies separate experts from novices with it)");
        case EvidenceGrade::moderate:
            return MetricsPage::tr("moderate (one study, or several with small groups)");
        case EvidenceGrade::expert:
            break;
    }
    return MetricsPage::tr("expert opinion (no published study separates experts from novices with it)");
}

}  // namespace

MetricsPage::MetricsPage(Context& context) : Page(context, "metrics_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    back_ = make_button(tr("← Back to the attempt"), "metrics_back", "link");
    back_->hide();
    connect(back_, &QPushButton::clicked, this,
            [this] { emit this->context().debrief_wanted(attempt_, time_); });
    layout->addWidget(back_, 0, Qt::AlignLeft);
    layout->addWidget(make_label(tr("Metrics"), "title"));
    layout->addWidget(make_label(tr("What the simulator measures. A gate is a pass criterion of a task; to "
                                    "pass, every gate of the task must be met."),
                                 "muted"));
    search_ = new QLineEdit;
    search_->setObjectName(QStringLiteral("metric_search"));
    search_->setAccessibleName(tr("Search"));
    search_->setPlaceholderText(tr("Search names and explanations"));
    search_->setClearButtonEnabled(true);
    layout->addWidget(search_);
    table_ = make_table({tr("Metric"), tr("Direction"), tr("Unit"), tr("Gate in")}, "metric_table");
    table_->setAccessibleName(tr("Metrics"));
    table_->setMinimumHeight(260);
    layout->addWidget(table_, 1);
    QFrame* card = make_card(6);
    name_ = make_label({}, "heading");
    explanation_ = make_label({});
    explanation_->setObjectName(QStringLiteral("metric_explanation"));
    details_ = make_label({}, "muted");
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    for (QLabel* label : {name_, explanation_, details_}) card_layout(card)->addWidget(label);
    layout->addWidget(card);
    connect(search_, &QLineEdit::textChanged, this, &MetricsPage::filter);
    connect(table_, &QTableWidget::currentCellChanged, this, &MetricsPage::show_chosen);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000));
}

void MetricsPage::enter() {
    if (table_->rowCount() == 0) fill();
    search_->setFocus();
    if (wanted_.empty()) return;
    const std::vector<Metric>& metrics = metric_registry();
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        if (metrics[i].descriptor.id != wanted_) continue;
        table_->setCurrentCell(static_cast<int>(i), 0);
        table_->scrollToItem(table_->item(static_cast<int>(i), 0));
        table_->setFocus();
    }
    wanted_.clear();
}

void MetricsPage::leave() {
    back_->hide();
}

void MetricsPage::show_metric(const std::string& id, const QString& attempt_id, double time_s) {
    search_->clear();
    wanted_ = id;
    attempt_ = attempt_id;
    time_ = time_s;
    back_->setVisible(!attempt_.isEmpty());
}

QString MetricsPage::gate_of(const std::string& metric) const {
    QStringList tasks;
    for (const TaskDefinition& task : context().services().tasks()) {
        for (const GateSpec& gate : task.gates) {
            if (gate.metric == metric) tasks << text(task.id);
        }
    }
    tasks.removeDuplicates();
    return tasks.join(QStringLiteral(", "));
}

void MetricsPage::fill() {
    const std::vector<Metric>& metrics = metric_registry();
    table_->setRowCount(static_cast<int>(metrics.size()));
    for (std::size_t i = 0; i < metrics.size(); ++i) {
        const MetricDescriptor& metric = metrics[i].descriptor;
        const QString cells[columns] = {metric_words(metric.name), better(metric.direction),
                                        unit_text(metric.unit), gate_of(metric.id)};
        for (int column = 0; column < columns; ++column)
            table_->setItem(static_cast<int>(i), column, make_cell(cells[column]));
    }
    fit_columns(table_);
    table_->setCurrentCell(0, 0);
}

void MetricsPage::filter() {
    const QString wanted = search_->text().trimmed();
    int first = -1;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const MetricDescriptor& metric = metric_registry()[static_cast<std::size_t>(row)].descriptor;
        const bool shown = metric_words(metric.name).contains(wanted, Qt::CaseInsensitive) ||
                           metric_words(metric.explanation).contains(wanted, Qt::CaseInsensitive);
        table_->setRowHidden(row, !shown);
        if (shown && first < 0) first = row;
    }
    if (first >= 0) table_->setCurrentCell(first, 0);
    if (first < 0) {
        name_->setText(tr("No metric matches."));
        explanation_->clear();
        details_->clear();
    } else {
        show_chosen();
    }
}

void MetricsPage::show_chosen() {
    const int row = table_->currentRow();
    if (row < 0) return;
    const MetricDescriptor& metric = metric_registry()[static_cast<std::size_t>(row)].descriptor;
    name_->setText(metric_words(metric.name));
    explanation_->setText(metric_words(metric.explanation));
    QStringList lines;
    if (!metric.advice_remedy.empty()) lines << tr("To improve: %1").arg(metric_words(metric.advice_remedy));
    lines << tr("Evidence: %1").arg(evidence(metric.grade));
    lines << tr("Source: %1").arg(text(metric.source));
    lines << tr("Name in exports: %1, version %2").arg(text(metric.id)).arg(metric.version);
    details_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace fulcrum::ui

#include "moc_metrics_page.cpp"
