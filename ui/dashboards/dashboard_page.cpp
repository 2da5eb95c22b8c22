// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/dashboard_page.h"

#include <QComboBox>
#include <QDateTime>
#include <QSettings>
#include <QSpinBox>
#include <algorithm>
#include <memory>

#include "database/records/people.h"
#include "ui/charts/chart_frame.h"
#include "ui/charts/figure_chart.h"
#include "ui/page/background_job.h"
#include "ui/page/station_note.h"
#include "ui/page/store_reading.h"
#include "ui/reports/export_row.h"
#include "ui/reports/report_export.h"
#include "ui/style/flow_row.h"
#include "ui/style/kept_places.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

const QString plan_setting = QStringLiteral("dashboard/plan_weeks");

}  // namespace

DashboardPage::DashboardPage(Context& context) : Page(context, "dashboard_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    layout->addWidget(make_label(tr("Dashboard"), "title"));
    note_ = new StationNote;
    layout->addWidget(note_);
    layout->addLayout(make_choices());
    job_ = new JobBar;
    layout->addWidget(job_);
    summary_ = make_label({}, "muted");
    summary_->setObjectName(QStringLiteral("dashboard_summary"));
    layout->addWidget(summary_);
    pictures_holder_ = new QWidget;
    auto* row = new FlowRow(pictures_holder_);
    row->setSpacing(12);
    for (const auto& part : dashboard_parts) pictures_.push_back({part.kind});
    for (Picture& picture : pictures_) row->add(make_picture(picture), 1, with_text(370));
    layout->addWidget(pictures_holder_);
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
    reading_ = new StoreReading(context, this);
    show_begun_reports(context, this, job_);
}

QLayout* DashboardPage::make_choices() {
    auto* row = new FlowRow;
    row->setSpacing(24);
    cohort_ = make_narrow_choice("dashboard_cohort", tr("Cohort"), 18);
    row->add(cohort_, 1, with_text(220));
    plan_ = new QSpinBox;
    plan_->setObjectName(QStringLiteral("dashboard_plan"));
    plan_->setAccessibleName(tr("Weeks that the plan gives for all tasks"));
    plan_->setToolTip(
        tr("The plan: all tasks of the curriculum at an even pace, in so many weeks from a "
           "person's first day of practice on."));
    plan_->setRange(1, database::longest_plan_weeks);
    plan_->setPrefix(tr("Plan: "));
    plan_->setSuffix(tr(" weeks"));
    plan_->setValue(QSettings().value(plan_setting, database::usual_plan_weeks).toInt());
    row->add(plan_);
    export_ = new ExportRow("export_dashboard");
    // Not in proportion to the text: a row's least width is also the page's.
    row->add(export_, 1, 640);
    connect(cohort_, QOverload<int>::of(&QComboBox::activated), this, &DashboardPage::load);
    connect(plan_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int weeks) {
        QSettings().setValue(plan_setting, weeks);
        for (const Picture& picture : pictures_) picture.frame->show_chart();
        show_pictures();
    });
    connect(export_, &ExportRow::save_wanted, this,
            [this](const QString& path) { export_to(path, report_format_of(path)); });
    return row;
}

QWidget* DashboardPage::make_picture(Picture& picture) {
    const QByteArray name = QByteArray("dashboard_") + row_of(dashboard_parts, picture.part).name;
    const QString title = dashboard_title(picture.part);
    picture.chart = new FigureChart(name + "_chart");
    picture.chart->setAccessibleName(title);
    picture.frame = new ChartFrame(picture.chart, title, name);
    if (picture.part == DashboardPart::times) {
        task_ = make_narrow_choice("dashboard_task", tr("Task"), 18);
        picture.frame->set_below_title(task_);
    }
    QFrame* card = make_card(6);
    card_layout(card)->addWidget(picture.frame, 1);
    picture.words = make_label({}, "muted");
    card_layout(card)->addWidget(picture.words);
    connect(picture.chart, &FigureChart::part_chosen, this,
            [this, &picture](const QString& key) { choose_part(picture, key); });
    connect(picture.frame, &ChartFrame::row_chosen, this, [this, &picture](const QString& key) {
        if (key.contains(QLatin1Char(' ')))
            open_person(key);
        else
            choose_part(picture, key);
    });
    if (picture.part == DashboardPart::times)
        connect(task_, QOverload<int>::of(&QComboBox::activated), this, [this, &picture] {
            picture.frame->show_chart();
            show_picture(picture);
        });
    return card;
}

void DashboardPage::enter() {
    note_->look(context());
    const QString before = cohort_->currentData().toString();
    cohort_->clear();
    context().guarded([&] {
        for (const database::Cohort& cohort :
             database::People(context().store()).cohorts(context().session()))
            cohort_->addItem(text(cohort.name), text(cohort.id));
    });
    cohort_->setCurrentIndex(std::max(0, cohort_->findData(before)));
    load();
    cohort_->setFocus();
}

void DashboardPage::leave() {
    reading_->stop();
}

void DashboardPage::load() {
    reading_->stop();
    const std::string id = plain(cohort_->currentData().toString());
    if (data_ && (data_->cohort_id != id || !reading_->read_in_this_role())) data_.reset();
    for (const Picture& picture : pictures_) picture.frame->show_chart();
    export_->setVisible(!id.empty() &&
                        context().allowed(database::Operation::export_cohort, database::Subject::cohort(id)));
    pictures_holder_->setVisible(data_.has_value());
    plan_->setVisible(!id.empty());
    if (id.empty()) {
        summary_->setText(
            tr("There is no cohort yet. A director creates cohorts on the page \"Assign cohorts\"."));
        return;
    }
    export_->propose(cohort_->currentText());
    summary_->setText(tr("Reading the cohort …"));
    // Another version may be published while it is read.
    const auto curriculum = std::make_shared<const Curriculum>(context().services().curriculum());
    database::CohortTableOptions options;
    for (const TaskDefinition& task : context().services().tasks()) options.tasks.push_back(task.id);
    options.curriculum = curriculum.get();
    reading_->begin(
        [id, options, curriculum](const database::Store& store, const database::Session& session) {
            return database::Reports(store).cohort_table(session, id, options);
        },
        [this, curriculum](database::CohortTable table) { show_table(std::move(table), *curriculum); },
        [this](const QString& why) {
            data_.reset();
            pictures_holder_->hide();
            summary_->setText(why);
        });
}

void DashboardPage::show_table(database::CohortTable table, const Curriculum& curriculum) {
    const KeptPlaces places(this);
    data_ = std::move(table);
    curriculum_ = curriculum;
    std::vector<std::pair<std::string, std::string>> titles;
    for (const TaskDefinition& task : context().services().tasks()) titles.emplace_back(task.id, task.title);
    names_ = dashboard_names(curriculum_, titles);
    const int chosen = task_->count() > 0 ? task_->currentIndex() : -1;
    task_->clear();
    task_->addItems(names_.tasks);
    show_pictures();
    task_->setCurrentIndex(chosen >= 0 ? chosen : static_cast<int>(telling_task(dashboard_)));
    show_pictures();
    pictures_holder_->show();
    QString words = tr("%n people", nullptr, data_->people);
    if (data_->deactivated > 0) words += tr(" · deactivated: %1").arg(data_->deactivated);
    if (data_->left_out_synthetic > 0)
        words += tr(" · synthetic left out: %1").arg(data_->left_out_synthetic);
    words +=
        tr(" · Click on a part of a picture, or choose it with the arrow keys and press Enter, to see "
           "who is behind it.");
    summary_->setText(words);
}

void DashboardPage::show_pictures() {
    if (!data_) return;
    database::DashboardOptions options;
    options.at = data_->as_of;
    options.utc_offset_min = QDateTime::fromMSecsSinceEpoch(data_->as_of).offsetFromUtc() / 60;
    options.plan_weeks = plan_->value();
    dashboard_ = database::dashboard_of(data_->standings, curriculum_, options);
    for (const Picture& picture : pictures_) show_picture(picture);
}

void DashboardPage::show_picture(const Picture& picture) {
    DashboardPicture shown = dashboard_picture(picture.part, dashboard_, data_->standings, names_,
                                               static_cast<std::size_t>(std::max(0, task_->currentIndex())));
    picture.words->setText(shown.words);
    picture.words->setVisible(!shown.words.isEmpty());
    picture.chart->show_figure(std::move(shown.figure), std::move(shown.table), shown.words, shown.nothing);
}

void DashboardPage::choose_part(const Picture& picture, const QString& key) {
    if (!data_) return;
    if (picture.part == DashboardPart::plan) return open_person(key);
    BehindPicture behind = behind_picture(picture.part, key, dashboard_, data_->standings, names_,
                                          static_cast<std::size_t>(std::max(0, task_->currentIndex())));
    if (behind.caption.isEmpty())
        context().say(tr("There is nobody to show here."));
    else
        picture.frame->show_behind(behind.caption, std::move(behind.table));
}

void DashboardPage::open_person(const QString& key) {
    emit context().progress_wanted(key.section(QLatin1Char(' '), 0, 0), key.section(QLatin1Char(' '), 1, 1));
}

void DashboardPage::export_to(const QString& path, ReportFormat format) {
    ReportRequest request;
    request.cohort_id = plain(cohort_->currentData().toString());
    if (request.cohort_id.empty()) return;
    request.format = format;
    request.path = plain(path);
    request.plan_weeks = plan_->value();
    export_report(context(), this, job_, request, [this](const QString& file) {
        export_->look();
        emit exported(file);
    });
}

}  // namespace fulcrum::ui

#include "moc_dashboard_page.cpp"
