// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/home_page.h"

#include <QGridLayout>
#include <algorithm>

#include "assessment/scoring/score.h"
#include "database/records/curricula.h"
#include "database/records/report_data.h"
#include "database/records/standings.h"
#include "ui/page/store_reading.h"
#include "ui/style/kept_focus.h"
#include "ui/style/kept_places.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/trainee/goals_card.h"
#include "ui/trainee/ladder.h"

namespace fulcrum::ui {
namespace {

/// What to do about a plateau, where the curriculum names it.
void look_for_remedy(const database::Store& store, const database::Session& session,
                     const std::map<std::string, std::int64_t>& last, HomeContent& content) {
    const CurriculumTask* task = content.followed->find(content.next.task);
    if (content.next.reason != RecommendationReason::longest_ago || task == nullptr || task->remedies.empty())
        return;
    const database::PersonProgress progress =
        database::Reports(store).person_progress(session, session.person_id(), content.next.task,
                                                 database::ReportPurpose::screen, content.newest.get());
    content.next = with_remedy(content.next, *content.followed, history_of(progress), last, pass_mark);
    content.latest_attempt = latest_counting(progress);
}

/// `tasks`: that the program has. `device`: what the trainee would use now.
HomeContent read_content(const database::Store& store, const database::Session& session,
                         std::shared_ptr<const Curriculum> newest, const std::vector<std::string>& tasks,
                         DeviceClass device) {
    HomeContent content;
    content.newest = std::move(newest);
    content.summaries = summarise(database::Reports(store).person_table(
        session, session.person_id(), tasks, database::ReportPurpose::screen, content.newest.get()));
    const PersonRecord record =
        database::Standings(store).record(session, session.person_id(), *content.newest);
    content.at = store.now();  // one moment: a move may come into force at any
    content.followed = curriculum_at(record.assignments, content.at);
    if (content.followed == nullptr) content.followed = content.newest.get();
    content.missing = database::missing_in(record.assignments, content.at);
    if (content.missing.empty()) content.standings = standing_of(record, content.at);
    std::map<std::string, std::int64_t> last;
    for (const auto& [task, summary] : content.summaries) last[task] = summary.last_attempt;
    if (content.missing.empty()) {
        content.next = recommend(*content.followed, content.standings, last, device);
        look_for_remedy(store, session, last, content);
    }
    content.unread = database::Reviews(store).unread(session);
    return content;
}

}  // namespace

HomePage::HomePage(Context& context) : Page(context, "home_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(16);
    greeting_ = make_label({}, "title");
    layout->addWidget(greeting_);
    QFrame* next_card = make_card(8);
    next_ = card_layout(next_card);
    layout->addWidget(next_card);
    interrupted_card_ = make_card(4);
    interrupted_ = card_layout(interrupted_card_);
    layout->addWidget(interrupted_card_);
    comments_card_ = make_card(4);
    comments_ = card_layout(comments_card_);
    layout->addWidget(comments_card_);
    goals_ = new GoalsCard(context, true);
    layout->addWidget(goals_);
    ladder_ = new Ladder;
    layout->addWidget(ladder_);
    others_heading_ = make_label(tr("Other exercises"), "heading");
    layout->addWidget(others_heading_);
    cards_ = new QGridLayout;
    cards_->setSpacing(14);
    layout->addLayout(cards_);
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
    reading_ = new StoreReading(context, this);
}

void HomePage::enter() {
    const database::Session& session = context().session();
    greeting_->setText(tr("Hello, %1").arg(text(session.display_name())));
    goals_->show_person(session.person_id());
    fill_interrupted();
    // Behind the lock the keyboard is the lock's.
    if (go_ != nullptr && go_->isVisible()) go_->setFocus();
    load();
}

void HomePage::show_scored() {
    fill_interrupted();
    if (!goals_->is_edited()) goals_->show_person(context().session().person_id());
    // Not where it is now, which somebody may have chosen.
    const QPointer<QWidget> before = used_before_;
    load();
    used_before_ = before;
}

void HomePage::leave() {
    reading_->stop();
}

// Where nobody has used the keyboard since the reading began, it is where it would be without the lock.
void HomePage::take_keyboard(QWidget* used) {
    QWidget* next = used;
    if (used == nullptr || used == used_before_.data()) {
        if (go_ != nullptr && go_->isVisible()) next = go_;
        if (next == nullptr) next = ladder_->findChild<QPushButton*>();
    }
    Page::take_keyboard(next != nullptr && next->isVisible() ? next : nullptr);
    if (reading_->reads()) used_before_ = window()->focusWidget();
}

void HomePage::say(QLabel* words) {
    clear_layout(next_);
    go_.clear();
    next_->addWidget(words);
    comments_card_->hide();
    others_heading_->hide();
}

void HomePage::load() {
    if (content_.followed == nullptr) {
        QLabel* words = make_label(tr("Reading your attempts …"), "muted");
        words->setObjectName(QStringLiteral("home_reading"));
        say(words);
    }
    used_before_ = window()->focusWidget();
    // Another version may be published while it is read.
    const auto newest = std::make_shared<const Curriculum>(context().services().curriculum());
    std::vector<std::string> tasks;
    for (const TaskDefinition& task : context().services().tasks()) tasks.push_back(task.id);
    reading_->begin(
        [newest, tasks, device = context().services().device_in_use().device_class](
            const database::Store& store, const database::Session& session) {
            return read_content(store, session, newest, tasks, device);
        },
        [this](HomeContent content) { show_content(std::move(content)); },
        [this](const QString& why) { show_failure(why); });
}

void HomePage::show_content(HomeContent content) {
    // Who has used the keyboard since keeps it; behind the lock it is not taken.
    const bool untouched = isVisible() && window()->focusWidget() == used_before_.data();
    {
        const KeptFocus focus(this);
        const KeptPlaces places(this);
        content_ = std::move(content);
        fill_next();
        fill_comments();
        fill_tasks();
    }
    if (untouched && go_ != nullptr) go_->setFocus();
    if (isVisible()) used_before_.clear();
}

void HomePage::show_failure(const QString& why) {
    const QPointer<QWidget> used = window()->focusWidget();
    const bool untouched = used.data() == used_before_.data();
    content_ = {};
    QLabel* words = make_label(tr("Your attempts could not be read: %1").arg(why));
    words->setObjectName(QStringLiteral("home_failed"));
    set_tint(words, Tint::bad);
    say(words);
    ladder_->set_stages({});
    clear_layout(cards_);
    next_->addWidget(make_label(tr("Your tasks appear here once they are read. If trying again does not "
                                   "help, ask an administrator to check the store (page Station)."),
                                "muted"));
    QPushButton* again = make_button(tr("Try again"), "home_again", "primary");
    connect(again, &QPushButton::clicked, this, [this] {
        setFocus();  // the button is removed now, and the next control is not what was meant
        load();
    });
    next_->addWidget(again, 0, Qt::AlignLeft);
    go_ = again;
    if (isVisible() && (untouched || used == nullptr || !used->isVisible())) again->setFocus();
    if (isVisible()) used_before_.clear();
}

/// Leads to what the remedy asks for.
QPushButton* HomePage::remedy_button(const Recommendation& next, const std::string& latest_attempt) {
    const Remedy& remedy = next.remedy->remedy;
    const QString task = text(next.task);
    if (remedy.kind == RemedyKind::demonstration) {
        QPushButton* watch = make_button(tr("Watch an expert do it"), "next_remedy", "primary");
        connect(watch, &QPushButton::clicked, this,
                [this, task] { emit context().demonstration_wanted(task); });
        return watch;
    }
    if (remedy.kind == RemedyKind::replay && !latest_attempt.empty()) {
        QPushButton* look = make_button(tr("Open the replay"), "next_remedy", "primary");
        connect(look, &QPushButton::clicked, this,
                [this, id = text(latest_attempt)] { emit context().debrief_wanted(id, -1); });
        return look;
    }
    QPushButton* go = make_button(tr("Open the briefing"), "next_remedy", "primary");
    const QString of = remedy.kind == RemedyKind::other_task ? text(remedy.task) : task;
    int goal = 0;
    if (const TaskDefinition* own = context().task(next.task))
        for (std::size_t i = 0; i < own->goals.size(); ++i)
            if (own->goals[i].id == remedy.goal) goal = static_cast<int>(i);
    connect(go, &QPushButton::clicked, this,
            [this, of, variant = text(remedy.variant), goal, ghost = remedy.kind == RemedyKind::ghost] {
                emit context().briefing_wanted(of, variant, goal, ghost);
            });
    return go;
}

void HomePage::fill_next() {
    clear_layout(next_);
    go_.clear();
    if (!content_.missing.empty()) {
        QLabel* words = make_label(tr("You follow the curriculum %1, which is not at this station. Your "
                                      "standing cannot be shown here, and only practice is possible until "
                                      "an administrator exchanges with the programme server or installs it.")
                                       .arg(text(content_.missing)));
        words->setObjectName(QStringLiteral("curriculum_not_here"));
        next_->addWidget(words);
        return;
    }
    const Recommendation& next = content_.next;
    const CurriculumStage* stage = content_.followed->find_stage(next.stage);
    const bool remedy = next.reason == RecommendationReason::remedy;
    const QString why =
        remedy ? remedy_reason_text(next, context().task_title(next.task), context().services().tasks())
               : reason_text(next, stage == nullptr ? QString() : asset_text(stage->title),
                             context().services().device_in_use().device_class, content_.at);
    next_->addWidget(make_label(tr("Recommended next"), "muted"));
    if (next.reason == RecommendationReason::nothing) {
        next_->addWidget(make_label(why, "heading"));
        return;
    }
    const bool other = remedy && next.remedy->remedy.kind == RemedyKind::other_task;
    next_->addWidget(make_label(context().task_title(other ? next.remedy->remedy.task : next.task), "title"));
    QLabel* reason = make_label(why);
    reason->setObjectName(QStringLiteral("next_reason"));
    next_->addWidget(reason);
    QPushButton* go = nullptr;
    if (remedy) {
        go = remedy_button(next, content_.latest_attempt);
    } else {
        go = make_button(tr("Open the briefing"), "next_briefing", "primary");
        connect(go, &QPushButton::clicked, this,
                [this, id = text(next.task)] { emit context().briefing_wanted(id); });
    }
    next_->addWidget(go, 0, Qt::AlignLeft);
    go_ = go;
}

void HomePage::fill_interrupted() {
    clear_layout(interrupted_);
    const std::vector<InterruptedScore>& scored = context().interrupted();
    interrupted_card_->setVisible(!scored.empty());
    interrupted_->addWidget(
        make_label(tr("Attempts interrupted before you signed in: %1").arg(scored.size()), "heading"));
    for (const InterruptedScore& one : scored) {
        const QString what =
            tr("%1, %2, %3 recorded: ")
                .arg(context().task_title(one.task_id), local_time(one.started), clock_text(one.duration_s));
        // The debrief behind the link says which limit; a line has no room for it.
        const QString verdict =
            one.passed == false
                ? tr("failed: a limit was exceeded before the interruption")
                : tr("does not count (%1)")
                      .arg(one.problem.empty() ? statement_text(one.why) : sentence_text(one.problem));
        QPushButton* open = make_button(what + verdict, "interrupted_attempt", "link");
        connect(open, &QPushButton::clicked, this,
                [this, id = text(one.attempt_id)] { emit context().debrief_wanted(id, -1); });
        interrupted_->addWidget(open, 0, Qt::AlignLeft);
    }
}

void HomePage::fill_comments() {
    clear_layout(comments_);
    const std::vector<database::Comment>& unread = content_.unread;
    comments_card_->setVisible(!unread.empty());
    comments_->addWidget(make_label(tr("Unread comments: %1").arg(unread.size()), "heading"));
    for (const database::Comment& comment : unread) {
        QString line = text(comment.text).simplified();
        if (line.size() > 110) line = line.left(107) + QStringLiteral(" …");
        QPushButton* open =
            make_button(tr("%1 at %2: %3").arg(text(comment.author_name), clock_text(comment.time_s), line),
                        "unread_comment", "link");
        connect(open, &QPushButton::clicked, this,
                [this, id = text(comment.attempt_id), time = comment.time_s] {
                    emit context().debrief_wanted(id, time);
                });
        comments_->addWidget(open);
    }
}

void HomePage::fill_tasks() {
    const Curriculum& curriculum = *content_.followed;
    const auto summary_of = [this](const std::string& task) {
        const auto found = content_.summaries.find(task);
        return found == content_.summaries.end() ? TaskSummary() : found->second;
    };
    std::vector<Ladder::Stage> stages;
    for (const CurriculumStage& stage : curriculum.stages) {
        Ladder::Stage shown{tr("%1 · %2").arg(text(stage.id), asset_text(stage.title)), {}};
        for (const TaskStanding& standing : content_.standings) {
            const CurriculumTask& task = *curriculum.find(standing.task);
            if (task.stage != stage.id || context().task(task.task) == nullptr) continue;
            shown.steps.push_back({task.task, task.after, standing.standing != Standing::locked,
                                   task_card(task.task, &standing, summary_of(task.task))});
        }
        if (!shown.steps.empty()) stages.push_back(std::move(shown));
    }
    ladder_->set_stages(std::move(stages));
    clear_layout(cards_);
    int index = 0;
    for (const TaskDefinition& task : context().services().tasks()) {
        // Without standings all are offered for practice.
        if (content_.missing.empty() && curriculum.find(task.id) != nullptr) continue;
        cards_->addWidget(task_card(task.id, nullptr, summary_of(task.id)), index / 2, index % 2);
        ++index;
    }
    others_heading_->setVisible(index > 0);
}

QFrame* HomePage::task_card(const std::string& task_id, const TaskStanding* standing,
                            const TaskSummary& summary) {
    QFrame* card = make_card(6);
    auto* head = new QHBoxLayout;
    if (standing != nullptr) head->addWidget(new StandingBadge(*standing), 0, Qt::AlignTop);
    QLabel* title = make_label(context().task_title(task_id), "heading");
    head->addWidget(title, 1);
    card_layout(card)->addLayout(head);
    if (standing != nullptr) {
        card_layout(card)->addWidget(
            make_label(capital(standing_text(*standing)), standing_role(standing->standing)));
        const QString detail = standing_detail(*standing);
        if (!detail.isEmpty()) card_layout(card)->addWidget(make_label(detail, "muted"));
    }
    QString figures;
    if (summary.attempts > 0)
        figures = tr("%1 of %2 attempts passed").arg(summary.passes).arg(summary.attempts);
    if (summary.best_points)
        figures = join_with_dots({figures, tr("best %1").arg(points_text(*summary.best_points))});
    if (summary.not_counting > 0)
        figures =
            join_with_dots({figures, tr("%n do not count", nullptr, static_cast<int>(summary.not_counting))});
    if (!figures.isEmpty()) card_layout(card)->addWidget(make_label(figures, "muted"));
    auto* row = new QHBoxLayout;
    QPushButton* briefing =
        make_button(tr("Briefing"), qPrintable(QStringLiteral("briefing_") + text(task_id)));
    connect(briefing, &QPushButton::clicked, this,
            [this, id = text(task_id)] { emit context().briefing_wanted(id); });
    row->addWidget(briefing);
    QPushButton* progress =
        make_button(tr("Progress"), qPrintable(QStringLiteral("progress_") + text(task_id)));
    connect(progress, &QPushButton::clicked, this, [this, id = text(task_id)] {
        emit context().progress_wanted(text(context().session().person_id()), id);
    });
    row->addWidget(progress);
    row->addStretch();
    card_layout(card)->addLayout(row);
    card_layout(card)->addStretch();
    return card;
}

}  // namespace fulcrum::ui

#include "moc_home_page.cpp"
