// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/progress_page.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <algorithm>
#include <memory>
#include <set>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "ui/charts/attempt_chart.h"
#include "ui/charts/chart_frame.h"
#include "ui/page/background_job.h"
#include "ui/page/store_reading.h"
#include "ui/reports/export_row.h"
#include "ui/reports/report_export.h"
#include "ui/style/flow_row.h"
#include "ui/style/kept_places.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/trainee/certificate_card.h"
#include "ui/trainee/curriculum_card.h"
#include "ui/trainee/curve_words.h"
#include "ui/trainee/goals_card.h"
#include "ui/trainee/standing_card.h"
#include "ui/trainee/task_header.h"

namespace fulcrum::ui {
namespace {

QString plain_key(const database::MetricRow& metric) {
    return text(metric.id + "/" + metric.hand + "/" + metric.tissue);
}

/// By plain key, of the versions that occur.
std::map<QString, int> newest_versions(const database::PersonProgress& progress) {
    std::map<QString, int> newest;
    for (const database::ProgressSeries& series : progress.series)
        for (const database::ProgressPoint& point : series.points)
            for (const database::MetricRow& metric : point.metrics) {
                int& known = newest[plain_key(metric)];
                known = std::max(known, metric.version);
            }
    return newest;
}

/// What the chart draws of it, as limits and experts are given: the size where only that counts.
std::optional<double> charted(const database::MetricRow& metric) {
    const MetricDescriptor* known = find_metric(metric.id);
    if (!metric.value || known == nullptr) return metric.value;
    return gated_value(*known, *metric.value);
}

}  // namespace

ProgressPage::ProgressPage(Context& context) : Page(context, "progress_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    title_ = make_label(tr("Progress"), "title");
    layout->addWidget(title_);
    layout->addLayout(make_choices());
    export_ = new ExportRow("export_person");
    connect(export_, &ExportRow::save_wanted, this,
            [this](const QString& path) { export_to(path, report_format_of(path)); });
    layout->addWidget(export_);
    job_ = new JobBar;
    layout->addWidget(job_);
    header_ = new TaskHeader(context);
    layout->addWidget(header_);
    certificates_ = new CertificateCard(context);
    standing_ = new StandingCard(context);
    layout->addWidget(standing_);
    layout->addWidget(goals_ = new GoalsCard(context, false));
    curriculum_ = new CurriculumCard(context);
    connect(curriculum_, &CurriculumCard::moved, this, [this] {
        standing_->show_task(person_id_, task_id_);
        show_certificates();
    });
    // The first decision settles which version is followed.
    connect(standing_, &StandingCard::decided, this, [this] {
        curriculum_->refresh();
        show_certificates();
    });
    layout->addWidget(certificates_);
    QFrame* card = make_card(8);
    summary_ = make_label({}, "muted");
    summary_->setObjectName(QStringLiteral("progress_summary"));
    card_layout(card)->addWidget(summary_);
    curve_ = make_label({});
    curve_->setObjectName(QStringLiteral("learning_curve"));
    card_layout(card)->addWidget(curve_);
    chart_ = new AttemptChart;
    chart_->setMinimumHeight(280);
    frame_ = new ChartFrame(chart_, tr("Attempts"), "progress_chart");
    card_layout(card)->addWidget(frame_);
    card_layout(card)->addWidget(
        make_label(tr("● passed   ✕ failed   ○ not scored   Small: does not count. Each type of device has "
                      "its own line. Thick line: fitted learning curve. Band: the level it approaches (95 % "
                      "interval). Select a point to open the attempt: click it, or choose it with the arrow "
                      "keys and press Enter."),
                   "muted"));
    layout->addWidget(card);
    table_ = make_table({tr("No."), tr("Started"), tr("Device"), tr("Mode"), tr("Ended"), tr("Time"),
                         tr("Result"), tr("Points")},
                        "progress_table");
    table_->setAccessibleName(tr("Attempts"));
    table_->setMinimumHeight(220);
    // What came of an attempt is seen without scrolling; the device stands last.
    table_->horizontalHeader()->moveSection(2, table_->columnCount() - 1);
    layout->addWidget(table_);
    layout->addWidget(curriculum_);
    layout->addStretch(1);
    connect(frame_, &ChartFrame::row_chosen, chart_, &AttemptChart::attempt_chosen);
    connect(chart_, &AttemptChart::attempt_chosen, this,
            [this](const QString& id) { emit this->context().debrief_wanted(id, -1); });
    connect(table_, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) {
        emit this->context().debrief_wanted(table_->item(item->row(), 0)->data(Qt::UserRole).toString(), -1);
    });
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1100));
    reading_ = new StoreReading(context, this);
    show_begun_reports(context, this, job_);
}

/// Whose progress in which task, and what of it the chart shows.
QLayout* ProgressPage::make_choices() {
    auto* row = new FlowRow;
    const auto combo = [&](const QString& label, const char* name) {
        auto* box = new QComboBox;
        box->setObjectName(QString::fromLatin1(name));
        box->setAccessibleName(label);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(20);
        auto* named = new QWidget;
        auto* in_named = new QVBoxLayout(named);
        in_named->setContentsMargins(0, 0, 0, 0);
        in_named->setSpacing(2);
        QLabel* name_of = make_label(label, "muted");
        name_of->setBuddy(box);
        in_named->addWidget(name_of);
        in_named->addWidget(box);
        row->add(named, 1, with_text(230));
        connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box] {
            if (box == metric_) {
                wanted_metric_ = metric_->currentData().toString();
                draw();
            } else {
                load();
            }
        });
        return box;
    };
    person_ = combo(tr("Person"), "progress_person");
    task_ = combo(tr("Task"), "progress_task");
    metric_ = combo(tr("Metric"), "progress_metric");
    explain_ = make_button(tr("Explain"), "explain_progress", "link");
    row->add(explain_);
    connect(explain_, &QPushButton::clicked, this, [this] {
        const QString id = metric_->currentData().toString().section(QLatin1Char('/'), 0, 0);
        emit this->context().metric_wanted(id, {}, -1);
    });
    return row;
}

void ProgressPage::show_person(const std::string& person_id, const std::string& task_id) {
    person_id_ = person_id;
    task_id_ = task_id;
}

void ProgressPage::enter() {
    fill_choices();
    load();
    task_->setFocus();
}

void ProgressPage::leave() {
    reading_->stop();
}

void ProgressPage::fill_choices() {
    const database::Session& session = context().session();
    person_->clear();
    context().guarded([&] {
        for (const database::Person& person : database::People(context().store()).list(session)) {
            if (!context().allowed(database::Operation::read_progress, database::Subject::person(person.id)))
                continue;
            person_->addItem(text(person.display_name), text(person.id));
        }
    });
    if (person_->findData(text(session.person_id())) < 0 &&
        context().allowed(database::Operation::read_progress,
                          database::Subject::person(session.person_id()))) {
        person_->addItem(text(session.display_name()), text(session.person_id()));
    }
    if (person_id_.empty()) {
        // Whoever looks at others begins with one of them.
        person_id_ = session.person_id();
        for (int i = 0; session.role() != database::Role::trainee && i < person_->count(); ++i) {
            person_id_ = plain(person_->itemData(i).toString());
            if (person_id_ != session.person_id()) break;
        }
    }
    person_->setCurrentIndex(std::max(0, person_->findData(text(person_id_))));
    person_->parentWidget()->setVisible(person_->count() > 1);
    task_->clear();
    for (const TaskDefinition& task : context().services().tasks()) {
        task_->addItem(context().task_title(task.id), text(task.id));
    }
    if (task_id_.empty()) task_id_ = newest_task();
    task_->setCurrentIndex(std::max(0, task_->findData(text(task_id_))));
}

std::string ProgressPage::newest_task() const {
    if (!context().allowed(database::Operation::read_attempt, database::Subject::person(person_id_)))
        return {};
    database::AttemptFilter newest;
    newest.person_id = person_id_;
    newest.limit = 1;
    std::vector<database::AttemptSummary> attempts;
    context().guarded(
        [&] { attempts = database::Attempts(context().store()).list(context().session(), newest); });
    return attempts.empty() ? std::string() : attempts.front().meta.task_id;
}

QString ProgressPage::key_of(const database::MetricRow& metric) const {
    const QString key = plain_key(metric);
    return metric.version == newest_.at(key) ? key : key + QStringLiteral("@%1").arg(metric.version);
}

const database::MetricRow* ProgressPage::find_row(const database::ProgressPoint& point,
                                                  const QString& key) const {
    for (const database::MetricRow& metric : point.metrics)
        if (key_of(metric) == key) return &metric;
    return nullptr;
}

void ProgressPage::load() {
    person_id_ = plain(person_->currentData().toString());
    task_id_ = plain(task_->currentData().toString());
    reading_->stop();
    if (progress_ && (progress_->person_id != person_id_ || progress_->task_id != task_id_ ||
                      !reading_->read_in_this_role()))
        progress_.reset();
    export_->setVisible(
        context().allowed(database::Operation::export_person, database::Subject::person(person_id_)));
    export_->propose(person_->currentText());
    show_certificates();
    header_->show_task(person_id_, task_id_);
    standing_->show_task(person_id_, task_id_);
    // Trainees have theirs on the home page.
    const bool trainee = context().session().role() == database::Role::trainee;
    goals_->show_person(trainee ? std::string() : person_id_);
    curriculum_->show_person(person_id_);
    title_->setText(person_id_ == context().session().person_id()
                        ? tr("My progress")
                        : tr("Progress of %1").arg(person_->currentText()));
    if (!person_id_.empty() && !task_id_.empty())
        reading_->begin(
            [person = person_id_, task = task_id_,
             curriculum = std::make_shared<const Curriculum>(context().services().curriculum())](
                const database::Store& store, const database::Session& session) {
                return database::Reports(store).person_progress(
                    session, person, task, database::ReportPurpose::screen, curriculum.get());
            },
            [this](database::PersonProgress progress) {
                const KeptPlaces places(this);
                progress_ = std::move(progress);
                show_progress();
            },
            [this](const QString& why) {
                progress_.reset();
                show_progress();
                summary_->setText(why);
            });
    if (progress_)
        summary_->setText(tr("Reading the attempts …"));
    else
        show_progress();
}

void ProgressPage::show_certificates() {
    certificates_->show_person(person_id_, QFileInfo(export_->path()).absolutePath());
}

void ProgressPage::show_progress() {
    metric_->clear();
    metric_->addItem(tr("Points"), QStringLiteral("points"));
    std::set<QString> seen;
    newest_ = progress_ ? newest_versions(*progress_) : std::map<QString, int>();
    if (progress_) {
        for (const database::ProgressSeries& series : progress_->series) {
            // Older versions of metrics come last.
            for (auto point = series.points.rbegin(); point != series.points.rend(); ++point) {
                for (const database::MetricRow& metric : point->metrics) {
                    const QString key = key_of(metric);
                    if (!metric.value || !seen.insert(key).second) continue;
                    QString shown = metric_text(metric.id);
                    if (!metric.hand.empty()) shown += QStringLiteral(", ") + hand_text(metric.hand);
                    if (!metric.tissue.empty()) shown += QStringLiteral(", ") + asset_text(metric.tissue);
                    if (metric.version != newest_.at(plain_key(metric)))
                        shown = tr("%1, version %2").arg(shown, QString::number(metric.version));
                    metric_->addItem(shown, key);
                }
            }
        }
    }
    metric_->setCurrentIndex(std::max(0, metric_->findData(wanted_metric_)));
    draw();
    fill_table();
}

void ProgressPage::draw() {
    AttemptChartData drawn;
    const QString key = metric_->currentData().toString();
    drawn.y_title = metric_->currentText();
    if (key == QLatin1String("points")) drawn.y_maximum = 100;
    int counting = 0, passed = 0;
    QStringList said;
    if (progress_) {
        for (const database::ProgressSeries& series : progress_->series) {
            AttemptSeries shown;
            shown.name = device_class_text(series.device_class);
            for (const database::ProgressPoint& point : series.points) {
                AttemptPoint mark{point.attempt_id, point.number, {}, point.passed, point.counting, {}};
                std::string unit;
                std::optional<double> value;  // with its sign
                if (key == QLatin1String("points")) {
                    mark.value = value = point.points;
                } else if (const database::MetricRow* metric = find_row(point, key)) {
                    value = metric->value;
                    mark.value = charted(*metric);
                    unit = metric->unit;
                }
                if (!unit.empty() && !unit_text(unit).isEmpty()) {
                    drawn.y_title = metric_->currentText() + QStringLiteral(" (%1)").arg(unit_text(unit));
                    drawn.unit = unit_text(unit);
                }
                mark.tip = tr("attempt %1, %2: %3, %4")
                               .arg(point.number)
                               .arg(local_time(point.started), figure_with_unit(value, unit),
                                    verdict(point.passed, point.provisional));
                counting += point.counting ? 1 : 0;
                passed += point.counting && point.passed.value_or(false) ? 1 : 0;
                shown.points.push_back(std::move(mark));
            }
            const QString words = add_curve(series, shown, key, drawn.limit);
            if (!words.isEmpty())
                said << (progress_->series.size() > 1 ? shown.name + QStringLiteral(": ") + words : words);
            drawn.series.push_back(std::move(shown));
        }
    }
    summary_->setText(reading_->reads() ? tr("Reading the attempts …")
                                        : tr("%1 · %3 of %2 counting attempts passed")
                                              .arg(task_->currentText())
                                              .arg(counting)
                                              .arg(passed));
    add_experts(drawn, key);
    explain_->setVisible(key != QLatin1String("points"));
    if (drawn.limit) drawn.limit_name = tr("limit");
    curve_->setText(said.join(QStringLiteral("\n")));
    curve_->setVisible(!said.isEmpty());
    chart_->set_data(std::move(drawn));
}

void ProgressPage::add_experts(AttemptChartData& drawn, const QString& key) {
    const TaskDefinition* task = context().task(task_id_);
    if (!progress_ || progress_->series.size() != 1 || task == nullptr) return;
    const database::ProgressSeries& series = progress_->series.front();
    // Those of the variant family that the curve is of. A variant that the task no longer has has none.
    std::string variant;
    if (task->variants.size() > 1 && !series.points.empty()) {
        variant = series.points.back().variant;
        if (std::none_of(task->variants.begin(), task->variants.end(),
                         [&](const TaskVariant& one) { return one.id == variant; }))
            return;
    }
    std::vector<JudgedLimit> limits;
    context().guarded([&] {
        limits =
            context().services().judged_limits(context().session(), task_id_, series.device_class, variant);
    });
    for (const JudgedLimit& one : limits) {
        if (text(one.metric + "/" + one.hand + "/" + one.tissue) != key) continue;
        // They are of the metric as it is defined now.
        const MetricDescriptor* known = find_metric(one.metric);
        const auto newest = newest_.find(key);
        if (known == nullptr || newest == newest_.end() || newest->second != known->version) continue;
        drawn.band_low = one.experts_low;
        drawn.band_high = one.experts_high;
        drawn.band_name = tr("experts (mean ± one standard deviation)");
        if (!drawn.limit) drawn.limit = one.limit;
    }
}

QString ProgressPage::add_curve(const database::ProgressSeries& series, AttemptSeries& shown,
                                const QString& key, std::optional<double>& limit) const {
    const bool points = key == QLatin1String("points");
    std::vector<CurveValue> values;
    std::optional<double> here;
    std::string unit;
    bool lower = false;
    const TaskDefinition* task = context().task(task_id_);
    const auto family = [task](const std::string& variant) {
        return task == nullptr ? variant : variant_family(*task, variant);
    };
    for (const database::ProgressPoint& point : series.points) {
        // One family of variants only: that of the latest attempt.
        if (family(point.variant) != family(series.points.back().variant) ||
            point.state != AttemptState::completed || !point.passed)
            continue;
        const database::MetricRow* metric = points ? nullptr : find_row(point, key);
        const std::optional<double> value = points              ? point.points
                                            : metric != nullptr ? charted(*metric)
                                                                : std::nullopt;
        if (!value) continue;
        values.push_back({point.number, *value});
        if (metric == nullptr) continue;
        unit = metric->unit;
        lower = metric->direction == Direction::lower;
        if (metric->direction == Direction::context) return {};
        here.reset();
        for (const database::GateRow& gate : point.gates)
            if (gate.metric == metric->id && gate.hand == metric->hand && gate.tissue == metric->tissue)
                here = gate.limit;
    }
    const LearningCurve curve =
        learning_curve(values, here, lower, unit, points ? std::optional<double>(100) : std::nullopt);
    shown.curve = curve.line;
    shown.plateau_low = curve.plateau_low;
    shown.plateau_high = curve.plateau_high;
    // Limits differ between device classes; one line is shown where there is one class.
    if (progress_->series.size() == 1) limit = here;
    return curve.words;
}

void ProgressPage::fill_table() {
    table_->setRowCount(0);
    if (!progress_) return;
    for (const database::ProgressSeries& series : progress_->series) {
        for (const database::ProgressPoint& point : series.points) {
            const int row = table_->rowCount();
            table_->insertRow(row);
            auto* number = make_cell(QString::number(point.number), Qt::AlignRight | Qt::AlignVCenter);
            number->setData(Qt::UserRole, text(point.attempt_id));
            table_->setItem(row, 0, number);
            table_->setItem(row, 1, make_cell(local_time(point.started)));
            table_->setItem(row, 2, make_cell(device_class_text(series.device_class)));
            table_->setItem(row, 3, make_cell(mode_text(point.mode)));
            table_->setItem(row, 4, make_cell(attempt_state(point.state)));
            const auto time = std::find_if(point.metrics.begin(), point.metrics.end(),
                                           [](const database::MetricRow& metric) {
                                               return plain_key(metric) == QLatin1String("time//");
                                           });
            const bool measured = time != point.metrics.end() && time->value;
            table_->setItem(row, 5,
                            make_cell(measured ? clock_text(*time->value) : QStringLiteral("–"),
                                      Qt::AlignRight | Qt::AlignVCenter));
            table_->setItem(row, 6, make_cell(verdict(point.passed, point.provisional)));
            table_->setItem(row, 7,
                            make_cell(points_figure(point.points), Qt::AlignRight | Qt::AlignVCenter));
        }
    }
    fit_columns(table_, {0, 1, 5, 7});
}

void ProgressPage::export_to(const QString& path, ReportFormat format) {
    ReportRequest request;
    request.person_id = person_id_;
    request.path = plain(path);
    request.format = format;
    export_report(context(), this, job_, request, [this](const QString& file) {
        export_->look();
        emit exported(file);
    });
}

}  // namespace fulcrum::ui

#include "moc_progress_page.cpp"
