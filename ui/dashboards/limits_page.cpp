// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/limits_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QHeaderView>
#include <QLineEdit>
#include <algorithm>
#include <cmath>
#include <set>

#include "assessment/learning/statistics.h"
#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "sim_core/scene/fidelity.h"
#include "sim_core/scene/standard_names.h"
#include "ui/charts/chart_frame.h"
#include "ui/dashboards/limit_rows.h"
#include "ui/page/station_note.h"
#include "ui/page/store_reading.h"
#include "ui/style/flow_row.h"
#include "ui/style/kept_places.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr std::size_t most_sets = 4;
constexpr std::size_t least_values = 8;  // for a spread that means something

bool same_key(const BenchmarkKey& a, const BenchmarkKey& b) {
    return benchmark_name(a) == benchmark_name(b);
}

QString fidelity_title(const std::string& name) {
    const NameRow<FidelityLevel>* row = find_row(fidelity_levels, name);
    return row == nullptr ? text(name) : QCoreApplication::translate("fulcrum::fidelity", row->title);
}

}  // namespace

LimitsPage::LimitsPage(Context& context) : Page(context, "limits_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    layout->addWidget(make_label(tr("Limits"), "title"));
    note_ = new StationNote;
    layout->addWidget(note_);
    layout->addWidget(make_label(tr("The limits that attempts are compared with, and how many people would "
                                    "pass with other limits. This page changes nothing."),
                                 "muted"));
    layout->addWidget(make_choice());
    QFrame* card = make_card(8);
    count_ = make_label({}, "muted");
    count_->setObjectName(QStringLiteral("limits_count"));
    chart_ = new LimitsChart;
    auto* frame = new ChartFrame(chart_, tr("Limits of each benchmark set"), "set_limits");
    frame->set_below_title(count_);
    card_layout(card)->addWidget(frame);
    layout->addWidget(card);
    QFrame* passes = make_card(8);
    card_layout(passes)->addWidget(make_label(tr("Who would pass with each set"), "heading"));
    table_ = make_table(pass_columns(), "limits_table");
    table_->setAccessibleName(tr("Who would pass with each set"));
    card_layout(passes)->addWidget(table_);
    site_ = make_label({}, "muted");
    site_->setObjectName(QStringLiteral("limits_of_site"));
    card_layout(passes)->addWidget(site_);
    card_layout(passes)->addWidget(make_adding());
    layout->addWidget(passes);
    layout->addWidget(make_groups());
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
    reading_ = new StoreReading(context, this);
}

QWidget* LimitsPage::make_choice() {
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    tasks_ = new QComboBox;
    tasks_->setObjectName(QStringLiteral("limits_task"));
    tasks_->setAccessibleName(tr("Task"));
    row->add(tasks_, 2, 200);
    keys_ = new QComboBox;
    keys_->setObjectName(QStringLiteral("limits_key"));
    keys_->setAccessibleName(tr("Set in force"));
    row->add(keys_, 1, 200);
    // Their least width does not depend on their entries, so that it is the same however often it is asked.
    for (QComboBox* choice : {tasks_, keys_}) {
        choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice->setMinimumContentsLength(12);
    }
    connect(tasks_, qOverload<int>(&QComboBox::activated), this, &LimitsPage::choose_task);
    connect(keys_, qOverload<int>(&QComboBox::activated), this, &LimitsPage::choose_set);
    return holder;
}

QWidget* LimitsPage::make_adding() {
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    row->add(make_label(tr("Compare with a set in a file")));
    path_ = new QLineEdit;
    path_->setObjectName(QStringLiteral("limits_file"));
    path_->setAccessibleName(tr("File of a benchmark set"));
    path_->setPlaceholderText(tr("A file made by the command \"fulcrum benchmark build\""));
    row->add(path_, 1, 240);
    add_ = make_button(tr("Compare"), "limits_add", "primary");
    row->add(add_);
    const auto look = [this] { add_->setEnabled(!path_->text().trimmed().isEmpty()); };
    connect(path_, &QLineEdit::textChanged, this, look);
    connect(path_, &QLineEdit::returnPressed, add_, &QPushButton::click);
    connect(add_, &QPushButton::clicked, this, &LimitsPage::add_file);
    look();
    return holder;
}

QFrame* LimitsPage::make_groups() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Pass mark between two groups"), "heading"));
    card_layout(card)->addWidget(make_label(
        tr("The contrasting-groups method: the value at which an attempt is equally likely to come from the "
           "set's experts and from the attempts stored here, if both are normally distributed."),
        "muted"));
    metrics_ = new QComboBox;
    metrics_->setObjectName(QStringLiteral("limits_metric"));
    metrics_->setAccessibleName(tr("Metric"));
    card_layout(card)->addWidget(metrics_, 0, Qt::AlignLeft);
    groups_ = new GroupsChart;
    groups_frame_ = new ChartFrame(groups_, tr("Experts and attempts here"), "groups");
    card_layout(card)->addWidget(groups_frame_);
    mark_ = make_label({});
    mark_->setObjectName(QStringLiteral("limits_mark"));
    card_layout(card)->addWidget(mark_);
    connect(metrics_, qOverload<int>(&QComboBox::activated), this, &LimitsPage::show_group);
    return card;
}

const TaskDefinition* LimitsPage::task() {
    return context().task(tasks_->currentData().toString().toStdString());
}

void LimitsPage::enter() {
    note_->look(context());
    if (tasks_->count() == 0) {
        for (const TaskDefinition& one : context().services().tasks())
            tasks_->addItem(context().task_title(one.id), text(one.id));
    }
    choose_task();
    tasks_->setFocus();
}

void LimitsPage::leave() {
    reading_->stop();
}

void LimitsPage::choose_task() {
    in_force_.clear();
    keys_->clear();
    if (task() != nullptr) context().guarded([&] { in_force_ = sets_in_force(task()->id); });
    for (const BenchmarkSet& set : in_force_) {
        QStringList parts{device_class_text(set.device_class)};
        if (set.variant_family != standard_variant) parts << variant_title(task(), set.variant_family);
        if (set.fidelity != standard_fidelity) parts << fidelity_title(set.fidelity);
        keys_->addItem(parts.join(QStringLiteral(" · ")));
    }
    for (int row = 0; row < keys_->count(); ++row)
        if (in_force_[static_cast<std::size_t>(row)].device_class == DeviceClass::haptic)
            keys_->setCurrentIndex(row);
    keys_->setEnabled(keys_->count() > 1);
    choose_set();
}

void LimitsPage::choose_set() {
    sets_.clear();
    attempts_.clear();
    const int row = keys_->currentIndex();
    if (row >= 0) sets_.push_back({in_force_[static_cast<std::size_t>(row)], {}});
    metrics_->clear();
    if (task() != nullptr && !sets_.empty()) {
        for (std::size_t k = 0; k < task()->gates.size(); ++k) {
            const GateSpec& gate = task()->gates[k];
            const BenchmarkLevel* level = sets_.front().set.find(gate.metric, gate.hand, gate.tissue);
            if (level != nullptr && !level->absolute_limit)
                metrics_->addItem(gate_name(gate), static_cast<int>(k));
        }
    }
    read_attempts();
}

void LimitsPage::read_attempts() {
    reading_->stop();
    if (!sets_.empty())
        reading_->begin(
            [of = *task(), key = sets_.front().set.key()](const database::Store& store,
                                                          const database::Session& session) {
                return tried_attempts(store, session, of, key);
            },
            [this](std::vector<TriedAttempt> found) {
                const KeptPlaces places(this);
                attempts_ = std::move(found);
                fill();
            },
            [this](const QString& why) {
                fill();
                count_->setText(why);
            });
    fill();
}

void LimitsPage::add_file() {
    const QString file = path_->text().trimmed();
    context().guarded([&] {
        if (sets_.empty()) return;
        BenchmarkSet set = load_benchmark(QDir::fromNativeSeparators(file).toStdString());
        if (!same_key(set.key(), sets_.front().set.key())) {
            context().complain(tr("%1 holds the set %2; this page compares sets of %3. Choose its task and "
                                  "devices above first.")
                                   .arg(file, text(benchmark_name(set.key())),
                                        text(benchmark_name(sets_.front().set.key()))));
            return;
        }
        if (sets_.size() == most_sets) sets_.erase(sets_.begin() + 1);
        sets_.push_back({std::move(set), file});
        path_->clear();
    });
    fill();
}

void LimitsPage::fill() {
    std::vector<GateLimits> gates;
    if (task() != nullptr && !sets_.empty()) {
        std::vector<const BenchmarkSet*> compared;
        for (const Compared& one : sets_) compared.push_back(&one.set);
        gates = gate_limits(*task(), compared, attempts_);
    }
    std::set<std::string> people;
    for (const TriedAttempt& attempt : attempts_) people.insert(attempt.person_id);
    if (sets_.empty()) {
        count_->setText(tr("There is no set of limits for this task."));
    } else if (reading_->reads()) {
        count_->setText(tr("Reading the attempts …"));
    } else if (attempts_.empty()) {
        count_->setText(tr("No attempt stored here counts under these limits yet."));
    } else {
        count_->setText(tr("Each dot is an attempt that counts. Attempts: %1, people: %2; at most the newest "
                           "%3 attempts.")
                            .arg(attempts_.size())
                            .arg(people.size())
                            .arg(most_tried_attempts));
    }
    chart_->show_gates(std::move(gates));
    fill_table();
    show_limits_of_site();
    show_group();
}

/// What each set of the site makes of the task's provisional limits.
void LimitsPage::show_limits_of_site() {
    QStringList lines;
    for (std::size_t k = 0; k < sets_.size(); ++k) {
        const BenchmarkSet& set = sets_[k].set;
        const QString letter = set_letter(k) + QStringLiteral(" · ");
        const QString of_site = taken_over_words(*task(), set), left = left_provisional_words(*task(), set);
        if (!of_site.isEmpty())
            lines << letter + tr("Limits of the task that this set takes over as limits of the site: %1.")
                                  .arg(of_site);
        if (!left.isEmpty()) lines << letter + left;
    }
    site_->setText(lines.join(QLatin1Char('\n')));
    site_->setVisible(!lines.isEmpty());
}

void LimitsPage::fill_table() {
    table_->setRowCount(static_cast<int>(sets_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const Compared& one = sets_[static_cast<std::size_t>(row)];
        const QString name =
            set_letter(static_cast<std::size_t>(row)) + QStringLiteral(" · ") +
            (one.file.isEmpty() ? tr("in force (%1)") : tr("version %1")).arg(one.set.version);
        const QStringList cells = pass_cells(name, one.set, *task(), attempts_);
        for (int column = 0; column < table_->columnCount(); ++column)
            table_->setItem(row, column, make_cell(cells[column]));
        table_->item(row, 0)->setToolTip(one.file.isEmpty() ? cells[0] : one.file);
        if (!one.set.note.empty()) table_->item(row, 1)->setToolTip(text(one.set.note));
    }
    fit_columns(table_, {0, 4, 5});
    fit_rows(table_);
    int height = table_->horizontalHeader()->sizeHint().height() + table_->fontMetrics().height();
    for (int row = 0; row < table_->rowCount(); ++row) height += table_->rowHeight(row);
    table_->setMinimumHeight(height);
}

void LimitsPage::show_group() {
    groups_->show_groups(std::nullopt);
    groups_frame_->hide();
    mark_->clear();
    if (metrics_->currentIndex() < 0 || sets_.empty() || reading_->reads()) return;
    const GateSpec& gate = task()->gates[static_cast<std::size_t>(metrics_->currentData().toInt())];
    const MetricDescriptor& metric = *find_metric(gate.metric);
    const BenchmarkLevel& level = *sets_.front().set.find(gate.metric, gate.hand, gate.tissue);
    std::vector<double> scaled;
    for (const double value : values_of(attempts_, gate, {&sets_.front().set}))
        if (const std::optional<double> x = on_scale(metric, value)) scaled.push_back(*x);
    if (scaled.size() < least_values) {
        mark_->setText(tr("A pass mark needs at least %1 attempts with this value; there are %2.")
                           .arg(least_values)
                           .arg(scaled.size()));
        return;
    }
    GroupCurves curves;
    curves.unit = text(metric.unit);
    curves.logarithmic = level.scale == Scale::ln;
    curves.experts = {level.mean, level.deviation};
    curves.others = {mean_of(scaled), sample_deviation(scaled)};
    if (!(curves.others.deviation > 0)) {
        mark_->setText(tr("All attempts have the same value."));
        return;
    }
    const double ahead = curves.others.mean - curves.experts.mean;
    const bool better = metric.direction == Direction::higher ? ahead > 0 : ahead < 0;
    // The method takes the experts' side of the mark for the one that passes: here it is the worse one.
    if (!better) curves.mark = contrasting_groups(curves.experts, curves.others);
    groups_->show_groups(curves);
    groups_frame_->show();
    if (better) {
        mark_->setText(
            tr("No pass mark: the attempts here are better than those of the set's experts. The limit in "
               "force is %1.")
                .arg(figure_with_unit(limit_in(sets_.front().set, gate), metric.unit)));
        return;
    }
    if (!curves.mark) {
        mark_->setText(tr("No pass mark: the groups overlap."));
        return;
    }
    const double value = curves.logarithmic ? std::exp(curves.mark->value) : curves.mark->value;
    mark_->setText(tr("Pass mark: %1. With it, %2 % of the attempts here would pass and %3 % of the experts' "
                      "attempts would fail. The limit in force is %4.")
                       .arg(figure_with_unit(value, metric.unit))
                       .arg(figure(100 * curves.mark->false_positive))
                       .arg(figure(100 * curves.mark->false_negative))
                       .arg(figure_with_unit(limit_in(sets_.front().set, gate), metric.unit)));
}

}  // namespace fulcrum::ui

#include "moc_limits_page.cpp"
