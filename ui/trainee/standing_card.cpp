// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/standing_card.h"

#include <QComboBox>
#include <QLineEdit>
#include <map>

#include "database/records/curricula.h"
#include "database/records/standings.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// What the decision changed; of one that comes into force later, what was decided.
QString decision_line(const database::OverrideRow& row,
                      const std::map<std::string, DecisionEffect>& effects) {
    const bool unlocks = row.decision.kind == StandingOverride::Kind::unlocked;
    const auto found = effects.find(row.decision.id);
    const bool known = found != effects.end();
    const QString what = unlocks ? StandingCard::tr("Unlocked by %1 on %2: %3")
                         : known && found->second == DecisionEffect::check_passed
                             ? StandingCard::tr("Check confirmed by %1 on %2: %3")
                             : StandingCard::tr("Declared proficient by %1 on %2: %3");
    const QString line = what.arg(text(row.author_name), date_text(row.decision.time), text(row.reason));
    if (row.own) return StandingCard::tr("%1 (does not count: both accounts are one person's)").arg(line);
    if (!known || found->second != DecisionEffect::none) return line;
    return (unlocks ? StandingCard::tr("%1 (changed nothing: the task was not locked)")
                    : StandingCard::tr("%1 (changed nothing: proficient already, and no check was due)"))
        .arg(line);
}

QString outcome_text(DecisionEffect effect) {
    switch (effect) {
        case DecisionEffect::unlocked:
            return StandingCard::tr("The task is unlocked.");
        case DecisionEffect::declared:
            return StandingCard::tr("Declared proficient.");
        case DecisionEffect::check_passed:
            return StandingCard::tr("The check is confirmed.");
        case DecisionEffect::none:
            return StandingCard::tr("The decision changed nothing.");
    }
    return {};
}

}  // namespace

StandingCard::StandingCard(Context& context) : context_(context) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QFrame* card = make_card(6);
    outer->addWidget(card);
    lines_ = new QVBoxLayout;
    card_layout(card)->addLayout(lines_);
    decision_ = new QWidget;
    auto* row = new QHBoxLayout(decision_);
    row->setContentsMargins(0, 0, 0, 0);
    kind_ = new QComboBox;
    kind_->setObjectName(QStringLiteral("decision_kind"));
    kind_->setAccessibleName(tr("Decision"));
    row->addWidget(kind_);
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("decision_reason"));
    reason_->setAccessibleName(tr("Reason"));
    reason_->setPlaceholderText(tr("Reason (kept in the audit log)"));
    mark_begun(reason_, tr("a reason for a decision"));
    row->addWidget(reason_, 1);
    QPushButton* button = make_button(tr("Decide"), "decide_standing");
    row->addWidget(button);
    card_layout(card)->addWidget(decision_);
    connect(button, &QPushButton::clicked, this, &StandingCard::decide);
}

void StandingCard::show_task(const std::string& person_id, const std::string& task_id) {
    person_id_ = person_id;
    task_id_ = task_id;
    reason_->clear();
    fill();
}

void StandingCard::fill() {
    clear_layout(lines_);
    const Curriculum& curriculum = context_.services().curriculum();
    const database::Subject subject = database::Subject::person(person_id_);
    const bool readable =
        !person_id_.empty() && context_.allowed(database::Operation::read_progress, subject);
    bool known = false;
    if (readable)
        context_.guarded([&] {
            const auto followed =
                database::Curricula(context_.store()).assignments(context_.session(), person_id_, curriculum);
            const std::int64_t at = context_.store().now();
            // Of a version that is not at this station the card of the curriculum says so.
            known = database::missing_in(followed, at).empty() &&
                    curriculum_at(followed, at)->find(task_id_) != nullptr;
        });
    setVisible(known);
    if (!known) return;
    const database::Standings standings(context_.store());
    TaskStanding here;
    std::vector<database::OverrideRow> decisions;
    std::map<std::string, DecisionEffect> effects;
    context_.guarded([&] {
        const PersonRecord record = standings.record(context_.session(), person_id_, curriculum);
        const std::int64_t at = context_.store().now();
        for (const TaskStanding& one : standing_of(record, at))
            if (one.task == task_id_) here = one;
        effects = effects_of(record, at);
        decisions = standings.overrides(context_.session(), person_id_);
    });
    auto* head = new QHBoxLayout;
    head->addWidget(new StandingBadge(here));
    QLabel* state = make_label(capital(standing_text(here)), "heading");
    state->setObjectName(QStringLiteral("standing_text"));
    head->addWidget(state, 1);
    lines_->addLayout(head);
    const QString detail = standing_detail(here);
    if (!detail.isEmpty()) lines_->addWidget(make_label(detail, "muted"));
    for (const database::OverrideRow& row : decisions) {
        if (row.decision.task != task_id_) continue;
        QLabel* line = make_label(decision_line(row, effects), "muted");
        line->setObjectName(QStringLiteral("decision_words"));
        lines_->addWidget(line);
    }
    kind_->clear();
    if (here.standing == Standing::locked)
        kind_->addItem(tr("Unlock"), static_cast<int>(StandingOverride::Kind::unlocked));
    const bool confirms = here.standing == Standing::due;
    // Until the next check there is nothing to decide on a proficiency.
    if (confirms || here.declared_at == 0)
        kind_->addItem(confirms ? tr("Confirm the check") : tr("Declare proficient"),
                       static_cast<int>(StandingOverride::Kind::proficient));
    decision_->setVisible(kind_->count() > 0 &&
                          context_.allowed(database::Operation::decide_standing, subject));
}

void StandingCard::decide() {
    const std::string words = plain(reason_->text().trimmed());
    if (words.empty()) {
        reason_->setFocus();
        context_.complain(tr("Enter a reason."));
        return;
    }
    const auto kind = static_cast<StandingOverride::Kind>(kind_->currentData().toInt());
    DecisionEffect effect = DecisionEffect::none;
    const bool done = context_.guarded([&] {
        const Curriculum& newest = context_.services().curriculum();
        const database::Standings standings(context_.store());
        const std::string id =
            standings.decide(context_.session(), person_id_, task_id_, kind, words, &newest);
        // What was shown may be older: a check that was due may have ended in a relapse since.
        effect =
            effects_of(standings.record(context_.session(), person_id_, newest), context_.store().now())[id];
    });
    // It may have been refused because the standing is not the one that was shown.
    if (!done) return fill();
    context_.say(outcome_text(effect));
    reason_->clear();
    fill();
    emit decided();
}

}  // namespace fulcrum::ui

#include "moc_standing_card.cpp"
