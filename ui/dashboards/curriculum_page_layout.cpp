// SPDX-License-Identifier: GPL-3.0-or-later
// What the page of the curriculum is made of.
#include <QLineEdit>
#include <QListWidget>
#include <QTabWidget>

#include "ui/dashboards/curriculum_forms.h"
#include "ui/dashboards/curriculum_page.h"
#include "ui/dashboards/pass_rule_designer.h"
#include "ui/dashboards/remedies_form.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

QWidget* CurriculumPage::make_tasks() {
    auto* holder = new QWidget;
    auto* layout = new QVBoxLayout(holder);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    tasks_ = new QListWidget;
    tasks_->setObjectName(QStringLiteral("curriculum_tasks"));
    tasks_->setAccessibleName(tr("Tasks of the curriculum"));
    tasks_->setMinimumWidth(256);
    tasks_->setMinimumHeight(12 * fontMetrics().height());
    tasks_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(tasks_, 1);
    auto* row = new FlowRow;
    up_ = make_button(tr("▲ Up"), "task_up");
    down_ = make_button(tr("▼ Down"), "task_down");
    remove_ = make_button(tr("Remove"), "task_remove");
    for (QPushButton* button : {up_, down_, remove_}) row->add(button);
    layout->addLayout(row);
    auto* more = new FlowRow;
    new_task_ = make_narrow_choice("task_new", tr("Task to be added"), 8);
    add_ = make_button(tr("Add"), "task_add");
    more->add(new_task_, 1, with_text(180));  // on a line of its own in a narrow window
    more->add(add_);
    layout->addLayout(more);
    return holder;
}

QWidget* CurriculumPage::make_task_card() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(task_name_);
    facts_->setObjectName(QStringLiteral("task_facts"));
    card_layout(card)->addWidget(facts_);
    tabs_ = new QTabWidget;
    tabs_->setObjectName(QStringLiteral("curriculum_tabs"));
    auto* rule = new QWidget;
    auto* layout = new QVBoxLayout(rule);
    layout->addWidget(designer_, 1);
    restore_ = make_button(tr("Back to the rule in force"), "rule_restore");
    layout->addWidget(restore_, 0, Qt::AlignLeft);
    layout->addWidget(make_label(tr("Calculated for trainees who pass each attempt with the same "
                                    "probability. Learning, and the days, variants and ratings that a rule "
                                    "can also require, are not included; they make proficiency later."),
                                 "muted"));
    tabs_->addTab(rule, tr("Pass rule"));
    tabs_->addTab(needs_, tr("Prerequisites"));
    tabs_->addTab(ratings_, tr("Ratings"));
    tabs_->addTab(remedies_, tr("Remedies"));
    tabs_->addTab(stages_, tr("Stages"));
    card_layout(card)->addWidget(tabs_, 1);
    return card;
}

QWidget* CurriculumPage::make_problems() {
    QFrame* card = make_card(6);
    card_layout(card)->addWidget(make_label(tr("Problems of the draft"), "heading"));
    no_problems_ = make_label(tr("None."));
    no_problems_->setObjectName(QStringLiteral("curriculum_no_problems"));
    card_layout(card)->addWidget(no_problems_);
    problem_list_ = new QListWidget;
    problem_list_->setObjectName(QStringLiteral("curriculum_problems"));
    problem_list_->setAccessibleName(tr("Problems of the draft"));
    problem_list_->setWordWrap(true);
    problem_list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    problem_list_->setMinimumHeight(6 * fontMetrics().height());
    problem_list_->setItemDelegate(new TintDelegate(problem_list_));
    card_layout(card)->addWidget(problem_list_);
    return card;
}

QWidget* CurriculumPage::make_publishing() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Publish"), "heading"));
    card_layout(card)->addWidget(
        make_label(tr("Trainees who have begun keep their version until an educator moves them. Trainees who "
                      "begin later follow the new version. Your name and reason are kept in the audit log."),
                   "muted"));
    auto* row = new FlowRow;
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("curriculum_reason"));
    reason_->setAccessibleName(tr("Reason for the new version"));
    reason_->setPlaceholderText(tr("Reason"));
    reason_->setMaxLength(1000);
    publish_ = make_button(tr("Publish"), "curriculum_publish", "primary");
    discard_ = make_button(tr("Discard the draft"), "curriculum_discard");
    row->add(reason_, 1, with_text(240));
    row->add(publish_);
    row->add(discard_);
    discard_sure_ = make_button(tr("Discard it for good"), "curriculum_discard_sure", "primary");
    row->add(discard_sure_);
    card_layout(card)->addLayout(row);
    why_not_ = make_label({}, "muted");
    why_not_->setObjectName(QStringLiteral("curriculum_why_not"));
    card_layout(card)->addWidget(why_not_);
    card_layout(card)->addLayout(make_draft_row());
    return card;
}

QLayout* CurriculumPage::make_draft_row() {
    auto* row = new FlowRow;
    QLabel* name = make_label(tr("Draft as a file"));
    name->setWordWrap(false);
    row->add(name);
    path_ = new QLineEdit;
    path_->setObjectName(QStringLiteral("curriculum_path"));
    path_->setAccessibleName(tr("File of the draft"));
    row->add(path_, 1, with_text(240));
    save_ = make_button(tr("Save"), "curriculum_save");
    QPushButton* open = make_button(tr("Open …"), "curriculum_open");
    row->add(save_);
    row->add(open);
    open_sure_ =
        make_button(tr("Open another draft in place of this one"), "curriculum_open_sure", "primary");
    row->add(open_sure_);
    ask_twice(open, open_sure_, [this] { return is_unsaved(); });
    connect(open_sure_, &QPushButton::clicked, this, &CurriculumPage::open_draft);
    return row;
}

}  // namespace fulcrum::ui
