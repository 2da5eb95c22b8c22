// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/actions_card.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>

#include "database/records/people.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

ActionsCard::ActionsCard(Context& context) : context_(context) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QFrame* card = make_card(8);
    outer->addWidget(card);
    hint_ = make_label({}, "muted");
    card_layout(card)->addWidget(hint_);
    auto* row = new FlowRow;
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("action_reason"));
    reason_->setAccessibleName(tr("Reason"));
    mark_begun(reason_, tr("a reason for a correction"));
    row->add(reason_, 1, with_text(200));
    void_ = make_button(tr("Void this attempt"), "void_attempt");
    reassign_ = make_button(tr("Reassign …"), "reassign_attempt");
    reassign_->setCheckable(true);
    request_ = make_button(tr("Request a correction"), "request_correction");
    for (QPushButton* button : {void_, reassign_, request_}) row->add(button);
    card_layout(card)->addLayout(row);
    // On a line of its own: in the row it would appear where the pointer has just pressed.
    void_sure_ = make_button(tr("Void it for good"), "void_attempt_sure", "primary");
    card_layout(card)->addWidget(void_sure_, 0, Qt::AlignLeft);

    right_person_row_ = new QWidget;
    auto* second = new FlowRow(right_person_row_);
    QLabel* performed = make_label(tr("Performed by"));
    performed->setWordWrap(false);
    second->add(performed);
    right_person_ = new QComboBox;
    right_person_->setObjectName(QStringLiteral("reassign_person"));
    right_person_->setAccessibleName(tr("Performed by"));
    right_person_->setMinimumWidth(240);
    second->add(right_person_);
    QPushButton* confirm = make_button(tr("Void and copy for this person"), "reassign_confirm", "primary");
    second->add(confirm);
    card_layout(card)->addWidget(right_person_row_);

    // Without a reason nothing would be done: then that is said at once.
    ask_twice(void_, void_sure_, [this] { return !reason_->text().trimmed().isEmpty(); });
    connect(void_sure_, &QPushButton::clicked, this, &ActionsCard::void_attempt);
    connect(reassign_, &QPushButton::toggled, right_person_row_, &QWidget::setVisible);
    connect(confirm, &QPushButton::clicked, this, &ActionsCard::reassign);
    connect(request_, &QPushButton::clicked, this, &ActionsCard::ask_correction);
}

void ActionsCard::open(const database::AttemptSummary& attempt) {
    attempt_id_ = attempt.meta.id;
    person_id_ = attempt.meta.person_id;
    const database::Subject subject = database::Subject::person(person_id_);
    const bool stands = attempt.state != AttemptState::voided;
    const bool can_void = stands && context_.allowed(database::Operation::void_attempt, subject);
    const bool can_ask = stands && context_.allowed(database::Operation::request_correction, subject);
    bool can_reassign = stands && context_.allowed(database::Operation::reassign_attempt, subject);
    right_person_->clear();
    if (can_reassign) fill_people();
    can_reassign = can_reassign && right_person_->count() > 0;
    setVisible(can_void || can_reassign || can_ask);
    void_->setVisible(can_void);
    void_sure_->hide();
    reassign_->setVisible(can_reassign);
    reassign_->setChecked(false);
    right_person_row_->setVisible(false);
    request_->setVisible(can_ask);
    reason_->clear();
    reason_->setPlaceholderText(can_void ? tr("Reason (kept in the audit log)")
                                         : tr("What is wrong with this attempt"));
    hint_->setText(can_void
                       ? tr("Voiding removes the attempt from progress, cohorts and benchmarks. It stays "
                            "visible, struck through, with your reason. Reassigning voids it as well and "
                            "stores a copy, with recording and score, for the person who performed it.")
                       : tr("Wrong person, or a mistaken attempt? An educator can void or reassign it."));
}

void ActionsCard::fill_people() {
    context_.guarded([&] {
        for (const database::Person& person : database::People(context_.store()).list(context_.session())) {
            const bool trains = std::find(person.roles.begin(), person.roles.end(),
                                          database::Role::trainee) != person.roles.end();
            if (person.id == person_id_ || !trains || !person.active ||
                !context_.allowed(database::Operation::reassign_attempt,
                                  database::Subject::person(person.id)))
                continue;
            right_person_->addItem(text(person.display_name), text(person.id));
        }
    });
}

std::string ActionsCard::reason(const QString& missing) {
    const std::string words = plain(reason_->text().trimmed());
    if (words.empty()) {
        reason_->setFocus();
        context_.complain(missing);
    }
    return words;
}

void ActionsCard::void_attempt() {
    const std::string words = reason(tr("Enter a reason."));
    if (words.empty()) return;
    if (context_.guarded([&] {
            database::Attempts(context_.store()).void_attempt(context_.session(), attempt_id_, words);
        })) {
        reason_->clear();
        context_.say(tr("The attempt is voided."));
        emit context_.attempt_voided(text(attempt_id_));
        emit changed();
    } else {
        void_->setFocus();
        void_sure_->hide();
    }
}

void ActionsCard::reassign() {
    const std::string words = reason(tr("Enter a reason."));
    if (words.empty()) return;
    const std::string person = plain(right_person_->currentData().toString());
    const QString name = right_person_->currentText();
    if (context_.guarded([&] {
            database::Attempts(context_.store()).reassign(context_.session(), attempt_id_, person, words);
        })) {
        reason_->clear();
        context_.say(tr("Reassigned to %1; this record is voided.").arg(name));
        emit context_.attempt_voided(text(attempt_id_));
        emit changed();
    }
}

void ActionsCard::ask_correction() {
    const std::string words = reason(tr("Say what is wrong with this attempt."));
    if (words.empty()) return;
    if (context_.guarded([&] {
            database::Attempts(context_.store()).request_correction(context_.session(), attempt_id_, words);
        })) {
        reason_->clear();
        context_.say(tr("Your educators will see the request."));
    }
}

}  // namespace fulcrum::ui

#include "moc_actions_card.cpp"
