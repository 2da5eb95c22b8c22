// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/attempts_page.h"

#include <QComboBox>
#include <QHeaderView>
#include <map>
#include <memory>

#include "database/records/people.h"
#include "ui/dashboards/trace_import_card.h"
#include "ui/page/background_job.h"
#include "ui/page/station_note.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// "Ann Trainee: A2 (3), B1", a line a person, so many at most.
QString stale_names(const std::vector<database::StaleScore>& scores) {
    constexpr std::size_t most_people = 6;
    std::map<QString, std::map<QString, int>> people;
    for (const database::StaleScore& score : scores) ++people[text(score.person_name)][text(score.task_id)];
    QStringList lines;
    for (const auto& [person, tasks] : people) {
        if (lines.size() == static_cast<int>(most_people)) {
            lines << AttemptsPage::tr("and of %n more people", nullptr,
                                      static_cast<int>(people.size() - most_people));
            break;
        }
        QStringList of;
        for (const auto& [task, count] : tasks)
            of << (count > 1 ? QStringLiteral("%1 (%2)").arg(task).arg(count) : task);
        lines << QStringLiteral("%1: %2").arg(person, of.join(QStringLiteral(", ")));
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

AttemptsPage::AttemptsPage(Context& context) : Page(context, "attempts_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    title_ = make_label(tr("Attempts"), "title");
    layout->addWidget(title_);
    note_ = new StationNote;
    layout->addWidget(note_);
    cut_off_card_ = make_card(4);
    cut_off_card_->setObjectName(QStringLiteral("cut_off_attempts"));
    cut_off_ = card_layout(cut_off_card_);
    layout->addWidget(cut_off_card_);
    requests_card_ = make_card(4);
    requests_ = card_layout(requests_card_);
    layout->addWidget(requests_card_);
    layout->addWidget(build_stale());
    auto* row = new FlowRow;
    const auto combo = [&](const QString& label, const char* name) {
        auto* box = new QComboBox;
        box->setObjectName(QString::fromLatin1(name));
        box->setAccessibleName(label);
        // As wide now as after a change of the theme, whatever it holds.
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumWidth(with_text(190));
        row->add(box);
        connect(box, QOverload<int>::of(&QComboBox::activated), this, &AttemptsPage::load);
        return box;
    };
    cohort_ = combo(tr("Cohort"), "filter_cohort");
    person_ = combo(tr("Person"), "filter_person");
    task_ = combo(tr("Task"), "filter_task");
    count_ = make_label({}, "muted");
    count_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->add(count_, 1, with_text(120));
    layout->addLayout(row);
    table_ = make_table({tr("Person"), tr("Task"), tr("Started"), tr("Mode"), tr("Device"), tr("Ended"),
                         tr("Recorded"), tr("Result"), tr("Points"), tr("Comments")},
                        "attempts_table");
    table_->setAccessibleName(tr("Attempts"));
    table_->setMinimumHeight(360);
    // What came of an attempt is seen without scrolling; the device stands last.
    table_->horizontalHeader()->moveSection(4, table_->columnCount() - 1);
    layout->addWidget(table_, 1);
    connect(table_, &QTableWidget::itemActivated, this,
            [this](QTableWidgetItem* item) { open_row(item->row()); });
    connect(table_, &QTableWidget::cellDoubleClicked, this, [this](int clicked, int) { open_row(clicked); });
    layout->addWidget(build_buttons());
    import_ = new TraceImportCard(context);
    layout->addWidget(import_);
    import_->hide();
    connect(import_, &TraceImportCard::imported, this, [this](const QString& id) {
        if (!id.isEmpty()) {
            import_->hide();
            this->context().say(tr("The recording was imported as an external attempt."));
        }
        load();
    });
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
}

void AttemptsPage::enter() {
    note_->look(context());
    const bool own = context().session().role() == database::Role::trainee;
    title_->setText(own ? tr("My attempts") : tr("Attempts"));
    fill_filters();
    cohort_->setVisible(!own);
    person_->setVisible(!own);
    table_->setColumnHidden(0, own);  // a trainee sees their own
    hide_columns();
    fill_requests();
    look_for_cut_off();
    load();
    count_stale();
    const bool may_import = !own && context().allowed(database::Operation::import_attempt);
    show_import_->setVisible(may_import);
    import_->setVisible(import_->isVisible() && may_import);
    if (import_->isVisible()) import_->enter();
    table_->setFocus();
}

QWidget* AttemptsPage::build_buttons() {
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    QPushButton* open = make_button(tr("Open attempt"), "open_attempt", "primary");
    connect(open, &QPushButton::clicked, this, [this] { open_row(table_->currentRow()); });
    row->add(open);
    show_import_ = make_button(tr("Import a recording …"), "show_trace_import");
    connect(show_import_, &QPushButton::clicked, this, [this] {
        import_->setVisible(!import_->isVisible());
        if (!import_->isVisible()) {
            import_->stop();
            return;
        }
        import_->enter();
        import_->bring(import_);
    });
    row->add(show_import_);
    return holder;
}

void AttemptsPage::leave() {
    import_->stop();
    for (BackgroundJob** job : {&job_, &cut_off_job_}) {
        if (*job != nullptr) (*job)->cancel();
        *job = nullptr;
    }
}

QFrame* AttemptsPage::build_stale() {
    stale_card_ = make_card(6);
    stale_ = make_label({});
    stale_->setObjectName(QStringLiteral("stale_scores"));
    card_layout(stale_card_)->addWidget(stale_);
    stale_names_ = make_label({}, "muted");
    stale_names_->setObjectName(QStringLiteral("stale_names"));
    card_layout(stale_card_)->addWidget(stale_names_);
    recompute_ = make_button(tr("Recompute"), "recompute_scores");
    connect(recompute_, &QPushButton::clicked, this, &AttemptsPage::recompute);
    card_layout(stale_card_)->addWidget(recompute_, 0, Qt::AlignLeft);
    bar_ = new JobBar;
    connect(bar_, &JobBar::cancelled, this, [this] {
        job_ = nullptr;
        count_stale();
    });
    card_layout(stale_card_)->addWidget(bar_);
    stale_card_->hide();
    return stale_card_;
}

void AttemptsPage::count_stale() {
    stale_card_->hide();
    if (job_ != nullptr || !context().allowed(database::Operation::recompute_score)) return;
    auto found = std::make_shared<std::vector<database::StaleScore>>();
    job_ = BackgroundJob::run(
        this,
        [found, session = context().session(),
         services = static_cast<ScoringService*>(&context().services())](const Progress&) {
            *found = services->stale_scores(session);
        },
        [this, found] {
            job_ = nullptr;
            stale_->setText(
                tr("%n scores were computed with older metrics or limits. Recomputing adds a second score to "
                   "each attempt; the score in force does not change.",
                   nullptr, static_cast<int>(found->size())));
            stale_names_->setText(stale_names(*found));
            recompute_->setEnabled(true);
            stale_card_->setVisible(!found->empty());
        },
        [this](const QString& why) {
            job_ = nullptr;
            context().complain(why);
        });
}

void AttemptsPage::recompute() {
    if (job_ != nullptr) return;
    recompute_->setEnabled(false);
    auto scores = std::make_shared<std::vector<RecomputedScore>>();
    job_ = BackgroundJob::run(
        this,
        [scores, session = context().session(),
         services = static_cast<ScoringService*>(&context().services())](const Progress& progress) {
            *scores = services->recompute_scores(session, progress);
        },
        [this, scores] {
            job_ = nullptr;
            int made = 0, other = 0;
            QString problem;
            for (const RecomputedScore& score : *scores) {
                made += score.problem.empty() ? 1 : 0;
                other += score.problem.empty() && score.passed != score.passed_in_force ? 1 : 0;
                if (!score.problem.empty()) problem = sentence_text(score.problem);
            }
            const QString line =
                tr("Recomputed: %1. The result differs from the score in force in %2 of them.")
                    .arg(made)
                    .arg(other);
            if (problem.isEmpty()) {
                context().say(line);
            } else {
                context().complain(line + QLatin1Char(' ') +
                                   tr("Some could not be recomputed: %1").arg(problem));
            }
            count_stale();
        },
        [this](const QString& why) {
            job_ = nullptr;
            context().complain(why);
            count_stale();
        });
    bar_->watch(job_, tr("Recomputing …"));
}

void AttemptsPage::fill_filters() {
    const auto refill = [](QComboBox* box, const QString& all,
                           const std::vector<std::pair<QString, QString>>& rows) {
        const QString before = box->currentData().toString();
        box->clear();
        box->addItem(all, QString());
        for (const auto& [shown, id] : rows) box->addItem(shown, id);
        box->setCurrentIndex(std::max(0, box->findData(before)));
    };
    std::vector<std::pair<QString, QString>> cohorts, people, tasks;
    context().guarded([&] {
        const database::People all(context().store());
        if (context().session().role() != database::Role::trainee) {
            for (const database::Cohort& cohort : all.cohorts(context().session())) {
                cohorts.emplace_back(text(cohort.name), text(cohort.id));
            }
            for (const database::Person& person : all.list(context().session())) {
                people.emplace_back(text(person.display_name), text(person.id));
            }
        }
    });
    for (const TaskDefinition& task : context().services().tasks()) {
        tasks.emplace_back(context().task_title(task.id), text(task.id));
    }
    refill(cohort_, tr("All cohorts"), cohorts);
    refill(person_, tr("Everyone"), people);
    refill(task_, tr("All tasks"), tasks);
}

void AttemptsPage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    hide_columns();
}

// In a narrow window the figures that decide stay: the debrief has the others. How an attempt ended is seen
// in its result as well, where the names of people need the room.
void AttemptsPage::hide_columns() {
    const bool people = !table_->isColumnHidden(0);
    const bool narrow = width() < (people ? 165 : 130) * fontMetrics().averageCharWidth();
    for (const int column : {4, 6}) table_->setColumnHidden(column, narrow);
    table_->setColumnHidden(5, narrow && people);
}

void AttemptsPage::fill_requests() {
    clear_layout(requests_);
    std::vector<database::CorrectionRequest> open;
    if (context().allowed(database::Operation::read_requests) ||
        context().session().role() == database::Role::educator) {
        context().guarded([&] {
            for (database::CorrectionRequest& request :
                 database::Attempts(context().store()).correction_requests(context().session())) {
                if (!request.settled) open.push_back(std::move(request));
            }
        });
    }
    requests_card_->setVisible(!open.empty());
    requests_->addWidget(make_label(tr("Requested corrections: %1").arg(open.size()), "heading"));
    for (const database::CorrectionRequest& request : open) {
        QPushButton* button =
            make_button(join_with_dots({text(request.person_name), local_time(request.asked)}),
                        "correction_request", "link");
        connect(button, &QPushButton::clicked, this,
                [this, id = text(request.attempt_id)] { emit context().debrief_wanted(id, -1); });
        requests_->addWidget(button);
        requests_->addWidget(make_label(text(request.text).simplified().left(200)));
    }
}

void AttemptsPage::look_for_cut_off() {
    if (cut_off_job_ != nullptr) cut_off_job_->cancel();
    cut_off_job_ = nullptr;
    show_cut_off({});
    if (context().session().role() == database::Role::trainee) return;
    auto series = std::make_shared<std::vector<database::CutOffSeries>>();
    cut_off_job_ = BackgroundJob::run(
        this,
        [series, session = context().session(), path = context().store().path()](const Progress&) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(path, options);
            *series = database::Attempts(store).cut_off_series(session);
        },
        [this, series] {
            cut_off_job_ = nullptr;
            show_cut_off(*series);
        },
        [this](const QString& why) {
            cut_off_job_ = nullptr;
            context().complain(why);
        });
}

void AttemptsPage::show_cut_off(const std::vector<database::CutOffSeries>& series) {
    clear_layout(cut_off_);
    cut_off_card_->setVisible(!series.empty());
    if (series.empty()) return;
    cut_off_->addWidget(make_label(
        tr("People with three or more interrupted attempts in a row: %1").arg(series.size()), "heading"));
    for (const database::CutOffSeries& one : series) {
        const database::AttemptSummary& last = one.attempts.front();
        QStringList recorded;
        for (const database::AttemptSummary& attempt : one.attempts)
            recorded +=
                tr("%1 %2").arg(clock_text(attempt.duration_s), verdict(attempt.passed, attempt.provisional));
        QPushButton* button = make_button(
            join_with_dots({person_text(last.person_name, last.synthetic), text(last.meta.task_id)}),
            "cut_off_series", "link");
        connect(button, &QPushButton::clicked, this,
                [this, id = text(last.meta.id)] { emit context().debrief_wanted(id, -1); });
        cut_off_->addWidget(button);
        cut_off_->addWidget(
            make_label(tr("%1 interrupted attempts, the last on %2. Recorded: %3")
                           .arg(QString::number(one.attempts.size()), local_time(last.meta.started),
                                recorded.mid(0, 5).join(QStringLiteral(", ")))));
    }
}

void AttemptsPage::load() {
    database::AttemptFilter filter;
    filter.cohort_id = plain(cohort_->currentData().toString());
    filter.person_id = plain(person_->currentData().toString());
    filter.task_id = plain(task_->currentData().toString());
    filter.limit = 500;
    attempts_.clear();
    context().guarded(
        [&] { attempts_ = database::Attempts(context().store()).list(context().session(), filter); });
    table_->setUpdatesEnabled(false);
    table_->setRowCount(static_cast<int>(attempts_.size()));
    for (std::size_t i = 0; i < attempts_.size(); ++i) {
        const database::AttemptSummary& attempt = attempts_[i];
        const bool voided = attempt.state == AttemptState::voided;
        const QString who = person_text(attempt.person_name, attempt.synthetic);
        QString comments = attempt.comments == 0 ? QString() : QString::number(attempt.comments);
        if (attempt.unread_comments > 0) comments += tr(" (%1 unread)").arg(attempt.unread_comments);
        const QString cells[] = {who,
                                 database::is_external_task(attempt.meta.task_id)
                                     ? context().task_title(attempt.meta.task_id)
                                     : text(attempt.meta.task_id),
                                 local_time(attempt.meta.started),
                                 mode_text(attempt.meta.mode),
                                 device_class_text(attempt.meta.device_class),
                                 attempt_state(attempt.state),
                                 clock_text(attempt.duration_s),
                                 verdict(attempt.passed, attempt.provisional),
                                 points_figure(attempt.points),
                                 comments};
        for (int column = 0; column < 10; ++column) {
            const bool numeric = column == 6 || column == 8;
            auto* item =
                make_cell(cells[column], (numeric ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
            if (voided) {
                QFont font = item->font();
                font.setStrikeOut(true);
                item->setFont(font);
                item->setToolTip(
                    tr("Voided by %1: %2").arg(text(attempt.voided_by), text(attempt.void_reason)));
            }
            table_->setItem(static_cast<int>(i), column, item);
        }
    }
    table_->setUpdatesEnabled(true);
    fit_columns(table_, {2, 6, 8});
    if (!attempts_.empty()) table_->setCurrentCell(0, 0);
    count_->setText(attempts_.size() >= 500 ? tr("newest 500 attempts")
                                            : tr("%n attempts", nullptr, static_cast<int>(attempts_.size())));
}

void AttemptsPage::open_row(int row) {
    if (row < 0 || row >= static_cast<int>(attempts_.size())) return;
    emit context().debrief_wanted(text(attempts_[static_cast<std::size_t>(row)].meta.id), -1);
}

}  // namespace fulcrum::ui

#include "moc_attempts_page.cpp"
