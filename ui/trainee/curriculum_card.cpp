// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/curriculum_card.h"

#include <QComboBox>
#include <QLineEdit>
#include <algorithm>

#include "database/records/curricula.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// "B1 Bowel handling: locked → open".
QString words_of(const QString& task, const database::CurriculumChange& change) {
    if (change.only_before)
        return CurriculumCard::tr("%1: no longer part of it (now: %2)")
            .arg(task, standing_name(change.before));
    if (change.only_after) return CurriculumCard::tr("%1: added (%2)").arg(task, standing_name(change.after));
    return CurriculumCard::tr("%1: %2 → %3")
        .arg(task, standing_name(change.before), standing_name(change.after));
}

}  // namespace

CurriculumCard::CurriculumCard(Context& context) : context_(context) {
    setObjectName(QStringLiteral("curriculum_card"));
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QFrame* card = make_card(6);
    outer->addWidget(card);
    lines_ = new QVBoxLayout;
    card_layout(card)->addLayout(lines_);
    choice_ = new QWidget;
    auto* row = new QHBoxLayout(choice_);
    row->setContentsMargins(0, 0, 0, 0);
    versions_ = new QComboBox;
    versions_->setObjectName(QStringLiteral("curriculum_versions"));
    versions_->setAccessibleName(tr("Version of the curriculum"));
    row->addWidget(versions_);
    QPushButton* look = make_button(tr("What would change"), "curriculum_preview");
    row->addWidget(look);
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("curriculum_reason"));
    reason_->setAccessibleName(tr("Reason"));
    reason_->setPlaceholderText(tr("Reason (kept in the audit log)"));
    mark_begun(reason_, tr("a reason for moving somebody to another version"));
    row->addWidget(reason_, 1);
    QPushButton* go = make_button(tr("Move"), "curriculum_move");
    row->addWidget(go);
    card_layout(card)->addWidget(choice_);
    changes_ = make_label({});
    changes_->setObjectName(QStringLiteral("curriculum_changes"));
    card_layout(card)->addWidget(changes_);
    connect(versions_, QOverload<int>::of(&QComboBox::activated), this, [this] { changes_->hide(); });
    connect(look, &QPushButton::clicked, this, &CurriculumCard::preview);
    connect(go, &QPushButton::clicked, this, &CurriculumCard::move);
}

void CurriculumCard::show_person(const std::string& person_id) {
    person_id_ = person_id;
    reason_->clear();
    fill();
}

void CurriculumCard::refresh() {
    const QVariant chosen = versions_->currentData();
    fill();
    const int again = versions_->findData(chosen);
    if (again >= 0) versions_->setCurrentIndex(again);
}

void CurriculumCard::fill() {
    clear_layout(lines_);
    changes_->hide();
    versions_->clear();
    const Curriculum& newest = context_.services().curriculum();
    const database::Subject subject = database::Subject::person(person_id_);
    const bool known = !person_id_.empty() && context_.allowed(database::Operation::read_progress, subject);
    setVisible(known);
    if (!known) return;
    std::vector<database::FollowedCurriculum> followed;
    context_.guarded([&] {
        followed = database::Curricula(context_.store()).followed(context_.session(), person_id_, newest);
    });
    if (followed.empty()) return;
    // A move of a station whose clock is ahead is not in force yet.
    const std::int64_t at = context_.store().now();
    const auto coming = std::find_if(followed.begin() + 1, followed.end(),
                                     [&](const database::FollowedCurriculum& one) { return one.since > at; });
    const database::FollowedCurriculum& now = *(coming - 1);
    const Curriculum* version = newest.version_named(now.name);
    QLabel* name = make_label(
        version == nullptr
            ? tr("Curriculum: %1").arg(text(now.name))
            : tr("Curriculum: %1, version %2").arg(asset_text(version->title)).arg(version->version));
    name->setObjectName(QStringLiteral("curriculum_name"));
    lines_->addWidget(name);
    for (std::size_t i = 1; i < followed.size(); ++i) {
        const database::FollowedCurriculum& one = followed[i];
        if (one.moved_by.empty()) continue;
        const QString what = one.name == followed[i - 1].name ? tr("On %1 by a decision of %2 on %3: %4")
                                                              : tr("Moved to %1 by %2 on %3: %4");
        lines_->addWidget(make_label(
            what.arg(text(one.name), text(one.moved_by), date_text(one.since), text(one.reason)), "muted"));
    }
    std::string missing;
    context_.guarded([&] {
        missing = database::Curricula(context_.store()).missing(context_.session(), person_id_, newest);
    });
    if (!missing.empty()) {
        QLabel* words = make_label(QStringLiteral("▲ %1\n%2")
                                       .arg(sentence_text(database::not_here_words(missing)),
                                            sentence_text(database::not_here_hint())));
        words->setObjectName(QStringLiteral("curriculum_not_here"));
        lines_->addWidget(words);
        choice_->hide();
        return;
    }
    for (auto one = coming; one != followed.end(); ++one) {
        if (one->name == (one - 1)->name) continue;  // written by a decision: nothing will change
        lines_->addWidget(make_label(tr("▲ The move to %1 comes into force on %2: the clock of the station "
                                        "where it was made is ahead of this one.")
                                         .arg(text(one->name), local_time(one->since))));
    }
    if (now.name != newest.name())
        lines_->addWidget(make_label(tr("There is a newer version, %1. Each person stays on their version "
                                        "until an educator moves them.")
                                         .arg(newest.version),
                                     "muted"));
    const auto add = [&](const Curriculum& one) {
        if (one.name() != followed.back().name)
            versions_->addItem(tr("version %1").arg(one.version), text(one.name()));
    };
    add(newest);
    for (const Curriculum& one : newest.older) add(one);
    choice_->setVisible(versions_->count() > 0 &&
                        context_.allowed(database::Operation::decide_standing, subject));
}

void CurriculumCard::preview() {
    std::vector<database::CurriculumChange> changes;
    if (!context_.guarded([&] {
            changes = database::Curricula(context_.store())
                          .preview(context_.session(), person_id_, context_.services().curriculum(),
                                   plain(versions_->currentData().toString()));
        }))
        return;
    QStringList lines;
    for (const database::CurriculumChange& change : changes)
        lines << words_of(context_.task_title(change.task), change);
    changes_->setText(lines.isEmpty()
                          ? tr("No standing changes today. Rules that differ apply to later attempts.")
                          : lines.join(QStringLiteral("\n")));
    changes_->show();
}

void CurriculumCard::move() {
    const std::string words = plain(reason_->text().trimmed());
    if (words.empty()) {
        reason_->setFocus();
        context_.complain(tr("Enter a reason."));
        return;
    }
    const std::string to = plain(versions_->currentData().toString());
    if (!context_.guarded([&] {
            database::Curricula(context_.store())
                .move(context_.session(), {person_id_}, context_.services().curriculum(), to, words);
        }))
        return;
    context_.say(tr("Moved to %1. What was passed or declared proficient stays.").arg(text(to)));
    reason_->clear();
    fill();
    emit moved();
}

}  // namespace fulcrum::ui

#include "moc_curriculum_card.cpp"
