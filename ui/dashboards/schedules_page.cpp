// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/schedules_page.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QTableWidget>
#include <QTimer>
#include <algorithm>

#include "database/research/research_export.h"
#include "ui/page/background_job.h"
#include "ui/page/station_note.h"
#include "ui/reports/scheduled_reports.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

enum ScheduleColumn { cohort_column, format_column, every_column, folder_column, last_column, state_column };

constexpr int look_again_ms = 3000;  // for what another run writes

QString every_words(database::ScheduleEvery every) {
    return every == database::ScheduleEvery::day ? SchedulesPage::tr("every day")
                                                 : SchedulesPage::tr("every week");
}

}  // namespace

SchedulesPage::SchedulesPage(Context& context) : Page(context, "schedules_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addWidget(make_label(tr("Reports"), "title"));
    note_ = new StationNote;
    layout->addWidget(note_);
    layout->addWidget(build_list());
    layout->addWidget(build_research());
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
    look();
}

QWidget* SchedulesPage::build_list() {
    QFrame* card = make_card(8);
    QVBoxLayout* layout = card_layout(card);
    layout->addWidget(make_label(tr("Scheduled reports"), "heading"));
    layout->addWidget(make_label(
        tr("This station writes a report of a cohort to a folder every day or week (UTC). It does so while a "
           "director is signed in, or when the command \"fulcrum schedule run\" is run."),
        "muted"));
    none_ = make_label(tr("No report is scheduled yet. Add one below."));
    none_->setObjectName(QStringLiteral("schedules_none"));
    layout->addWidget(none_);
    table_ =
        make_table({tr("Cohort"), tr("File"), tr("How often"), tr("Folder"), tr("Last written"), tr("State")},
                   "schedules_table");
    table_->setAccessibleName(tr("Scheduled reports"));
    table_->setMinimumHeight(8 * fontMetrics().height());
    layout->addWidget(table_);
    auto* row = new FlowRow;
    write_due_ = make_button(tr("Write reports that are due"), "schedules_write_due", "primary");
    write_one_ = make_button(tr("Write selected report now"), "schedules_write_one");
    remove_ = make_button(tr("Remove schedule"), "schedules_remove");
    remove_sure_ = make_button(tr("Remove this schedule for good"), "schedules_remove_sure", "primary");
    for (QPushButton* button : {write_due_, write_one_, remove_, remove_sure_}) row->add(button);
    layout->addLayout(row);
    bar_ = new JobBar;
    layout->addWidget(bar_);
    layout->addWidget(make_label(tr("Add a scheduled report"), "heading"));
    layout->addLayout(build_adding());
    no_cohort_ = make_label(tr("Make a cohort first, on the page Assign cohorts."), "muted");
    no_cohort_->setObjectName(QStringLiteral("schedules_no_cohort"));
    layout->addWidget(no_cohort_);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &SchedulesPage::look);
    connect(write_due_, &QPushButton::clicked, this, [this] { write({}); });
    connect(write_one_, &QPushButton::clicked, this, [this] { write(chosen()); });
    ask_twice(remove_, remove_sure_);
    connect(remove_sure_, &QPushButton::clicked, this, &SchedulesPage::remove);
    connect(bar_, &JobBar::cancelled, this, [this] {
        job_ = nullptr;
        fill();
    });
    return card;
}

QLayout* SchedulesPage::build_adding() {
    auto* row = new FlowRow;
    cohort_ = make_narrow_choice("schedule_cohort", tr("Cohort"), 12);
    format_ = make_narrow_choice("schedule_format", tr("File"), 5);
    for (const char* format : {"pdf", "csv", "xlsx", "json"})
        format_->addItem(QString::fromLatin1(format).toUpper(), QString::fromLatin1(format));
    every_ = make_narrow_choice("schedule_every", tr("How often"), 10);
    for (const auto every : {database::ScheduleEvery::week, database::ScheduleEvery::day})
        every_->addItem(every_words(every), static_cast<int>(every));
    folder_ = new QLineEdit;
    folder_->setObjectName(QStringLiteral("schedule_folder"));
    folder_->setAccessibleName(tr("Folder of the reports"));
    folder_->setPlaceholderText(tr("Folder, such as /srv/reports"));
    mark_begun(folder_, tr("a scheduled report that is not added yet"));
    QPushButton* choose = make_button(tr("Folder …"), "schedule_choose");
    add_ = make_button(tr("Add report"), "schedule_add");
    row->add(cohort_, 1, with_text(150));
    for (QWidget* one : std::initializer_list<QWidget*>{format_, every_}) row->add(one);
    row->add(folder_, 2, with_text(220));
    row->add(choose);
    row->add(add_);
    connect(choose, &QPushButton::clicked, this,
            [this] { choose_folder(folder_, tr("Folder of the reports")); });
    connect(folder_, &QLineEdit::textChanged, this, &SchedulesPage::look);
    connect(add_, &QPushButton::clicked, this, &SchedulesPage::add);
    return row;
}

QWidget* SchedulesPage::build_research() {
    QFrame* card = make_card(8);
    QVBoxLayout* layout = card_layout(card);
    layout->addWidget(make_label(tr("Files for research"), "heading"));
    layout->addWidget(make_label(
        tr("All attempts of the programme without names, dates and exact values: five CSV files with a "
           "dictionary. Devices, modes, tasks and metrics of fewer than 5 people are put together or left "
           "out, and the two tables of counts, taken alone, give no count below 5. The files attempts and "
           "metrics have rows of single people, from which smaller counts follow, and a reader who knows a "
           "person's attempts well might recognise that person: give them to researchers only and do not "
           "publish them. Give the same readers no later export without need: next to an earlier one it "
           "shows what single people did in between."),
        "muted"));
    auto* row = new FlowRow;
    research_folder_ = new QLineEdit;
    research_folder_->setObjectName(QStringLiteral("research_folder"));
    research_folder_->setAccessibleName(tr("Folder of the files for research"));
    research_folder_->setPlaceholderText(tr("Folder that exists"));
    QPushButton* choose = make_button(tr("Folder …"), "research_choose");
    export_ = make_button(tr("Write files"), "research_export");
    row->add(research_folder_, 1, with_text(240));
    row->add(choose);
    row->add(export_);
    layout->addLayout(row);
    research_bar_ = new JobBar;
    layout->addWidget(research_bar_);
    research_result_ = make_label({});
    research_result_->setObjectName(QStringLiteral("research_result"));
    layout->addWidget(research_result_);
    research_result_->hide();
    connect(choose, &QPushButton::clicked, this,
            [this] { choose_folder(research_folder_, tr("Folder of the files for research")); });
    connect(research_folder_, &QLineEdit::textChanged, this, &SchedulesPage::look);
    connect(export_, &QPushButton::clicked, this, &SchedulesPage::export_research);
    connect(research_bar_, &JobBar::cancelled, this, [this] {
        job_ = nullptr;
        look();
    });
    return card;
}

void SchedulesPage::choose_folder(QLineEdit* into, const QString& title) {
    auto* dialog = new QFileDialog(this, title, into->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, into, &QLineEdit::setText);
    dialog->open();
}

void SchedulesPage::enter() {
    note_->look(context());
    context().guarded([&] { cohorts_ = database::People(context().store()).cohorts(context().session()); });
    const QSignalBlocker quiet(cohort_);
    const QString before = cohort_->currentData().toString();
    cohort_->clear();
    for (const database::Cohort& one : cohorts_) cohort_->addItem(text(one.name), text(one.id));
    if (const int row = cohort_->findData(before); row >= 0) cohort_->setCurrentIndex(row);
    fill();
    (schedules_.empty() ? static_cast<QWidget*>(cohort_) : table_)->setFocus();
}

void SchedulesPage::leave() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
}

void SchedulesPage::fill() {
    const std::string before = chosen();
    context().guarded([&] { schedules_ = database::Schedules(context().store()).list(context().session()); });
    const database::UtcMilliseconds now = context().store().now();
    table_->setRowCount(0);
    for (const database::ReportSchedule& one : schedules_) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        table_->setItem(
            row, cohort_column,
            make_cell(one.cohort_name.empty() ? tr("(cohort no longer exists)") : text(one.cohort_name)));
        table_->setItem(row, format_column, make_cell(text(one.format).toUpper()));
        table_->setItem(row, every_column, make_cell(every_words(one.every)));
        table_->setItem(row, folder_column, make_cell(QDir::toNativeSeparators(text(one.folder))));
        table_->setItem(row, last_column,
                        make_cell(one.last_period.empty() ? tr("never") : text(one.last_period)));
        const bool due = is_due(one, now);
        auto* state =
            make_cell(!one.problem.empty() ? tr("✕ failed: %1").arg(sentence_text(one.problem).simplified())
                      : due                ? tr("● due")
                                           : tr("✓ written"));
        set_tint(state, !one.problem.empty() ? Tint::bad : due ? Tint::none : Tint::good);
        state->setToolTip(state->text());
        table_->setItem(row, state_column, state);
        if (one.id == before) table_->selectRow(row);
    }
    if (table_->rowCount() > 0 && table_->currentRow() < 0) table_->selectRow(0);
    fit_columns(table_, {last_column});
    none_->setVisible(schedules_.empty());
    table_->setVisible(!schedules_.empty());
    look();
}

std::string SchedulesPage::chosen() const {
    const int row = table_->currentRow();
    return row < 0 || row >= static_cast<int>(schedules_.size())
               ? std::string()
               : schedules_[static_cast<std::size_t>(row)].id;
}

void SchedulesPage::look() {
    const bool free = job_ == nullptr;
    add_->setEnabled(cohort_->count() > 0 && !folder_->text().trimmed().isEmpty());
    no_cohort_->setVisible(cohort_->count() == 0);
    remove_->setEnabled(free && !chosen().empty());
    remove_sure_->hide();  // what was asked about may be another one by now
    write_one_->setEnabled(free && !chosen().empty());
    write_due_->setEnabled(free && !schedules_.empty());
    export_->setEnabled(free && !research_folder_->text().trimmed().isEmpty());
}

void SchedulesPage::add() {
    database::ReportSchedule added;
    added.cohort_id = plain(cohort_->currentData().toString());
    added.format = plain(format_->currentData().toString());
    added.every = static_cast<database::ScheduleEvery>(every_->currentData().toInt());
    added.folder = plain(QDir::fromNativeSeparators(folder_->text().trimmed()));
    const bool done =
        context().guarded([&] { database::Schedules(context().store()).add(context().session(), added); });
    if (!done) return;
    context().say(tr("Scheduled."));
    folder_->clear();
    fill();
}

void SchedulesPage::remove() {
    const std::string id = chosen();
    if (id.empty()) return;
    context().guarded([&] { database::Schedules(context().store()).remove(context().session(), id); });
    fill();
    // Not on the button, which would ask about the next one.
    (schedules_.empty() ? static_cast<QWidget*>(cohort_) : table_)->setFocus();
}

void SchedulesPage::write(const std::string& only) {
    auto run = std::make_shared<ScheduledRun>();
    job_ = BackgroundJob::run(
        this,
        [run, only, session = context().session(), path = context().store().path(),
         tasks = context().services().tasks(), curriculum = context().services().curriculum(),
         version = context().services().program_version()](const Progress& progress) {
            const database::Store store = database::Store::open(path);
            *run = run_schedules(store, session, {tasks, curriculum, version},
                                 ScheduleRequest{only, only.empty()}, progress);
        },
        [this, run] {
            job_ = nullptr;
            fill();
            if (run->busy) {
                QTimer::singleShot(look_again_ms, this, [this] {
                    if (context().signed_in() && isVisible()) fill();
                });
                context().say(tr("Another program is already writing the reports that are due."));
            } else if (!run->failed.empty())
                context().complain(tr("%1: %2").arg(text(run->failed[0].cohort), text(run->failed[0].words)));
            else
                context().say(tr("%n files written.", nullptr, static_cast<int>(run->written.size())));
        },
        [this](const QString& why) {
            job_ = nullptr;
            fill();
            context().complain(why);
        });
    bar_->watch(job_, tr("Writing the report …"));
    look();
}

void SchedulesPage::export_research() {
    const QString folder = QDir::fromNativeSeparators(research_folder_->text().trimmed());
    research_result_->hide();
    if (!QFileInfo(folder).isDir()) {
        context().complain(tr("%1 is not a folder. Choose an existing one.").arg(folder));
        return;
    }
    struct Written {
        int people = 0, attempts = 0, left_out = 0;
        std::size_t files = 0;
    };
    auto written = std::make_shared<Written>();
    job_ = BackgroundJob::run(
        this,
        [written, folder = plain(folder), session = context().session(),
         path = context().store().path()](const Progress& progress) {
            const database::Store store = database::Store::open(path);
            const database::ResearchExport research = database::research_export(store, session);
            if (progress && !progress(0.7, {})) return;
            const std::size_t files = database::write_research_files(research, folder).size();
            *written = {research.people, research.attempts, research.left_out, files};
        },
        [this, written] {
            job_ = nullptr;
            look();
            if (written->files == 0) return;
            research_result_->setText(
                tr("%1 files written: %2 attempts of %3 people; %4 left out, of tasks with too few people.")
                    .arg(written->files)
                    .arg(written->attempts)
                    .arg(written->people)
                    .arg(written->left_out));
            research_result_->show();
            announce(research_result_, research_result_->text());
        },
        [this](const QString& why) {
            job_ = nullptr;
            look();
            context().complain(why);
        });
    research_bar_->watch(job_, tr("Writing the files …"));
    look();
}

}  // namespace fulcrum::ui

#include "moc_schedules_page.cpp"
