// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/judged_card.h"

#include <algorithm>
#include <iterator>

#include "ui/charts/limit_bar.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/trainee/metric_versions.h"

namespace fulcrum::ui {
namespace {

QString name_of(const JudgedLimit& limit) {
    QString name = metric_text(limit.metric);
    if (!limit.hand.empty()) name += QStringLiteral(", ") + hand_text(limit.hand);
    if (!limit.tissue.empty()) name += QStringLiteral(", ") + asset_text(limit.tissue);
    return name;
}

QString words_of_limit(const JudgedLimit& limit) {
    if (!limit.limit) return statement_text(limit.absent_because);
    const QString shown = figure_with_unit(limit.limit, limit.unit);
    QString words = limit.exclusive ? (limit.higher_is_better ? JudgedCard::tr("more than %1")
                                                              : JudgedCard::tr("less than %1"))
                                          .arg(shown)
                    : limit.higher_is_better ? JudgedCard::tr("at least %1").arg(shown)
                    : *limit.limit == 0.0    ? JudgedCard::tr("none")
                                             : JudgedCard::tr("at most %1").arg(shown);
    return limit.provisional ? words + QStringLiteral(" *") : words;
}

}  // namespace

std::vector<database::MetricRow> last_values(const database::PersonProgress& progress,
                                             DeviceClass device_class) {
    for (const database::ProgressSeries& series : progress.series) {
        if (series.device_class != device_class) continue;
        for (auto point = series.points.rbegin(); point != series.points.rend(); ++point) {
            if (point->metrics.empty()) continue;
            std::vector<database::MetricRow> values;
            std::copy_if(point->metrics.begin(), point->metrics.end(), std::back_inserter(values),
                         is_of_present_version);
            return values;
        }
    }
    return {};
}

JudgedCard::JudgedCard(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    auto* head = new QHBoxLayout;
    head->addWidget(make_label(tr("What is assessed"), "heading"), 1);
    toggle_ = make_button(tr("Show as a list"), "judged_list_toggle");
    head->addWidget(toggle_);
    layout->addLayout(head);
    bars_ = new QWidget;
    bars_->setObjectName(QStringLiteral("judged_bars"));
    bar_grid_ = new QGridLayout(bars_);
    bar_grid_->setContentsMargins(0, 0, 0, 0);
    bar_grid_->setHorizontalSpacing(28);
    bar_grid_->setVerticalSpacing(2);
    layout->addWidget(bars_);
    legend_ = make_label(tr("Line: the limit. Green: values that meet it. Box: experts (mean ± one standard "
                            "deviation). Diamond: your last value with this device. * Provisional limit."),
                         "muted");
    layout->addWidget(legend_);
    list_ = new QWidget;
    list_->setObjectName(QStringLiteral("judged_list"));
    lines_ = new QVBoxLayout(list_);
    lines_->setContentsMargins(0, 0, 0, 0);
    list_->hide();
    layout->addWidget(list_);
    errors_ = make_label({}, "bad");
    layout->addWidget(errors_);
    connect(toggle_, &QPushButton::clicked, this, [this] { show_list(list_->isHidden()); });
}

void JudgedCard::show_list(bool shown) {
    list_->setVisible(shown);
    bars_->setVisible(!shown);
    legend_->setVisible(!shown);
    toggle_->setText(shown ? tr("Show as bars") : tr("Show as a list"));
}

void JudgedCard::open(const TaskDefinition& task, const std::vector<JudgedLimit>& limits,
                      const std::vector<database::MetricRow>& own) {
    fill_bars(limits, own);
    fill_list(task, limits);
    show_list(false);
    QStringList errors;
    for (const std::string& error : task.critical_errors) errors << event_text(error);
    errors_->setVisible(!errors.isEmpty());
    errors_->setText(tr("Critical errors (the attempt fails): %1").arg(errors.join(QStringLiteral(", "))));
}

void JudgedCard::fill_bars(const std::vector<JudgedLimit>& limits,
                           const std::vector<database::MetricRow>& own) {
    clear_layout(bar_grid_);
    const int rows = (static_cast<int>(limits.size()) + 1) / 2;
    for (int i = 0; i < static_cast<int>(limits.size()); ++i) {
        const JudgedLimit& limit = limits[static_cast<std::size_t>(i)];
        LimitBarData shown;
        shown.name = name_of(limit);
        shown.unit = unit_text(limit.unit);
        shown.limit = limit.limit;
        shown.higher_is_better = limit.higher_is_better;
        shown.experts_low = limit.experts_low;
        shown.experts_high = limit.experts_high;
        shown.limit_words = words_of_limit(limit);
        for (const database::MetricRow& row : own)
            if (row.id == limit.metric && row.hand == limit.hand && row.tissue == limit.tissue)
                shown.last = row.value;
        // A bar has room for few words: the reason why there is no limit is in its tool tip, and below.
        const QString reason = limit.limit ? QString() : statement_text(limit.absent_because);
        if (!limit.limit) shown.limit_words = tr("no limit");
        if (!limit.hand.empty())
            shown.name = metric_text(limit.metric) + QStringLiteral(", ") +
                         (limit.hand == "left" ? tr("left") : tr("right"));
        const QString whole = tr("%1: %2").arg(name_of(limit), words_of_limit(limit));
        auto* bar = new LimitBar(std::move(shown));
        if (!reason.isEmpty()) bar->setAccessibleName(whole);
        bar->setToolTip(whole);
        bar_grid_->addWidget(bar, i % rows, i / rows);
    }
    bar_grid_->setColumnStretch(0, 1);
    bar_grid_->setColumnStretch(1, 1);
}

void JudgedCard::fill_list(const TaskDefinition& task, const std::vector<JudgedLimit>& limits) {
    clear_layout(lines_);
    for (std::size_t i = 0; i < limits.size(); ++i) {
        const JudgedLimit& limit = limits[i];
        QString line = tr("%1: %2").arg(name_of(limit), words_of_limit(limit));
        if (i < task.gates.size() && task.gates[i].kind == GateKind::benchmark && limit.experts_low)
            line += tr("; experts %1 to %2")
                        .arg(figure(*limit.experts_low), figure_with_unit(limit.experts_high, limit.unit));
        if (limit.provisional) line += tr(" (provisional)");
        auto* row = new QHBoxLayout;
        row->addWidget(make_label(QStringLiteral("•  ") + line), 1);
        QPushButton* explain = make_button(tr("Explain"), "explain_gate", "link");
        explain->setAccessibleName(tr("Explain: %1").arg(name_of(limit)));
        connect(explain, &QPushButton::clicked, this,
                [this, id = text(limit.metric)] { emit metric_chosen(id); });
        row->addWidget(explain, 0, Qt::AlignTop);
        lines_->addLayout(row);
    }
}

}  // namespace fulcrum::ui

#include "moc_judged_card.cpp"
