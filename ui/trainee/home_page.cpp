// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/home_page.h"

#include <QGridLayout>

#include "database/records/report_data.h"
#include "database/records/reviews.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/trainee/next_task.h"

namespace fulcrum::ui {

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
    layout->addWidget(make_label(tr("Tasks"), "heading"));
    cards_ = new QGridLayout;
    cards_->setSpacing(14);
    layout->addLayout(cards_);
    layout->addStretch();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000));
}

void HomePage::enter() {
    const database::Session& session = context().session();
    greeting_->setText(tr("Hello, %1").arg(text(session.display_name())));
    std::vector<database::CohortRow> rows;
    context().guarded([&] {
        std::vector<std::string> ids;
        for (const TaskDefinition& task : context().services().tasks()) ids.push_back(task.id);
        rows = database::Reports(context().store()).person_table(session, session.person_id(), ids);
    });
    const std::vector<TaskSummary> summaries = summarise(rows, context().services().tasks());
    fill_next(summaries);
    fill_interrupted();
    fill_comments();
    fill_tasks(summaries);
}

void HomePage::fill_next(const std::vector<TaskSummary>& summaries) {
    clear_layout(next_);
    const NextTask next = next_task(summaries, context().services().tasks(), context().store().now());
    next_->addWidget(make_label(tr("Next"), "muted"));
    if (next.task_id.empty()) {
        next_->addWidget(make_label(tr("No tasks are installed."), "heading"));
        return;
    }
    next_->addWidget(make_label(context().task_title(next.task_id), "title"));
    next_->addWidget(make_label(next.why));
    QPushButton* go = make_button(tr("Open the briefing"), "next_briefing", "primary");
    connect(go, &QPushButton::clicked, this,
            [this, id = text(next.task_id)] { emit context().briefing_wanted(id); });
    next_->addWidget(go, 0, Qt::AlignLeft);
    go->setFocus();
}

void HomePage::fill_interrupted() {
    clear_layout(interrupted_);
    const std::vector<InterruptedScore>& scored = context().interrupted();
    interrupted_card_->setVisible(!scored.empty());
    interrupted_->addWidget(
        make_label(tr("Interrupted before you signed in: %1").arg(scored.size()), "heading"));
    for (const InterruptedScore& one : scored) {
        const QString what =
            tr("%1, %2, %3 recorded: ")
                .arg(context().task_title(one.task_id), local_time(one.started), clock_text(one.duration_s));
        // The debrief behind the link says which limit; a line has no room for it.
        const QString verdict = one.passed == false
                                    ? tr("failed: a limit was exceeded before the interruption")
                                    : tr("does not count (%1)").arg(statement_text(one.why));
        QPushButton* open = make_button(what + verdict, "interrupted_attempt", "link");
        connect(open, &QPushButton::clicked, this,
                [this, id = text(one.attempt_id)] { emit context().debrief_wanted(id, -1); });
        interrupted_->addWidget(open, 0, Qt::AlignLeft);
    }
}

void HomePage::fill_comments() {
    clear_layout(comments_);
    std::vector<database::Comment> unread;
    context().guarded([&] { unread = database::Reviews(context().store()).unread(context().session()); });
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

void HomePage::fill_tasks(const std::vector<TaskSummary>& summaries) {
    clear_layout(cards_);
    int index = 0;
    for (const TaskSummary& summary : summaries) {
        cards_->addWidget(task_card(summary), index / 2, index % 2);
        ++index;
    }
}

QFrame* HomePage::task_card(const TaskSummary& summary) {
    QFrame* card = make_card(6);
    const TaskDefinition* task = context().task(summary.task_id);
    card_layout(card)->addWidget(
        make_label(task == nullptr ? QString() : tr("Stage %1").arg(text(task->stage)), "muted"));
    card_layout(card)->addWidget(make_label(context().task_title(summary.task_id), "heading"));
    QLabel* state = nullptr;
    switch (summary.state) {
        case database::TaskState::passed:
            state = make_label(summary.provisional ? tr("✓ passed (provisional)") : tr("✓ passed"), "good");
            break;
        case database::TaskState::attempted:
            state = make_label(tr("attempted, not passed yet"), "neutral");
            break;
        case database::TaskState::open:
            state = make_label(tr("open"), "neutral");
            break;
    }
    card_layout(card)->addWidget(state);
    QString figures = tr("counting attempts: %1").arg(summary.attempts);
    if (summary.best_points) figures += tr(" · best %1").arg(points_text(*summary.best_points));
    if (summary.not_counting > 0) figures += tr(" · not counting: %1").arg(summary.not_counting);
    card_layout(card)->addWidget(make_label(figures, "muted"));
    card_layout(card)->addWidget(make_label(summary.last_attempt == 0
                                                ? tr("not attempted yet")
                                                : tr("last on %1").arg(local_time(summary.last_attempt)),
                                            "muted"));
    auto* row = new QHBoxLayout;
    QPushButton* briefing =
        make_button(tr("Briefing"), qPrintable(QStringLiteral("briefing_") + text(summary.task_id)));
    connect(briefing, &QPushButton::clicked, this,
            [this, id = text(summary.task_id)] { emit context().briefing_wanted(id); });
    row->addWidget(briefing);
    QPushButton* progress =
        make_button(tr("Progress"), qPrintable(QStringLiteral("progress_") + text(summary.task_id)));
    connect(progress, &QPushButton::clicked, this, [this, id = text(summary.task_id)] {
        emit context().progress_wanted(text(context().session().person_id()), id);
    });
    row->addWidget(progress);
    row->addStretch();
    card_layout(card)->addLayout(row);
    return card;
}

}  // namespace fulcrum::ui

#include "moc_home_page.cpp"
