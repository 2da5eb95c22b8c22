// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/merge_card.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "database/records/person_merge.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

MergeCard::MergeCard(Context& context) : context_(context) {
    setObjectName(QStringLiteral("merge_card"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 8, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Does this person have two accounts?"), "heading"));
    what_ = make_label({}, "muted");
    what_->setWordWrap(true);
    layout->addWidget(what_);
    choice_ = new QWidget;
    auto* form = new QFormLayout(choice_);
    form->setContentsMargins(0, 0, 0, 0);
    into_ = new QComboBox;
    into_->setObjectName(QStringLiteral("merge_into"));
    into_->setAccessibleName(tr("Account that stays"));
    into_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    into_->setMinimumContentsLength(16);
    form->addRow(tr("Account that stays"), into_);
    layout->addWidget(choice_);
    plan_ = make_label({});
    plan_->setObjectName(QStringLiteral("merge_plan"));
    plan_->setWordWrap(true);
    layout->addWidget(plan_);
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("merge_reason"));
    reason_->setAccessibleName(tr("Reason"));
    reason_->setPlaceholderText(tr("Reason, for the audit log"));
    mark_begun(reason_, tr("a reason for merging two accounts"));
    layout->addWidget(reason_);
    auto* row = new FlowRow;
    merge_ = make_button(tr("Merge"), "merge_people");
    undo_ = make_button(tr("Undo the merge"), "unmerge_people");
    row->add(merge_);
    row->add(undo_);
    layout->addLayout(row);
    connect(into_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &MergeCard::look);
    connect(merge_, &QPushButton::clicked, this, &MergeCard::merge);
    connect(undo_, &QPushButton::clicked, this, &MergeCard::undo);
}

std::string MergeCard::chosen() const {
    return plain(into_->currentData().toString());
}

void MergeCard::show_for(const database::Person& person, const std::vector<database::Person>& people) {
    setVisible(person.kind == database::PersonKind::real);
    person_ = person.id;
    reason_->clear();
    const bool is_merged = !person.merged_into.empty();
    const QSignalBlocker quiet(into_);
    into_->clear();
    into_->addItem(tr("nobody chosen"), QString());
    QString owner;
    for (const database::Person& other : people) {
        const QString name = text(other.display_name) + QStringLiteral(" · ") + text(other.login);
        if (other.id == person.merged_into) owner = name;
        if (other.id != person.id && other.kind == database::PersonKind::real && other.merged_into.empty() &&
            other.active)
            into_->addItem(name, text(other.id));
    }
    what_->setText(
        is_merged
            ? tr("This account was merged into that of %1. It can no longer be used to sign in.").arg(owner)
            : tr("Merge this account into the other account of the same person. This login can then no "
                 "longer be used to sign in."));
    choice_->setVisible(!is_merged);
    merge_->setVisible(!is_merged);
    undo_->setVisible(is_merged);
    look();
}

void MergeCard::look() {
    plan_->clear();
    merge_->setEnabled(false);
    if (person_.empty() || chosen().empty()) {
        plan_->hide();
        return;
    }
    QStringList lines;
    const bool possible = context_.guarded([&] {
        const database::MergePlan plan =
            database::PersonMerge(context_.store()).plan(context_.session(), person_, chosen());
        for (const database::MergePlan::Count& one : plan.counts)
            lines << tr("%1: %2").arg(sentence_text(one.what)).arg(one.count);
        for (const std::string& cohort : plan.cohorts) lines << tr("cohort: %1").arg(text(cohort));
        lines.prepend(lines.isEmpty() ? tr("Nothing follows to %1.").arg(text(plan.into.display_name))
                                      : tr("These follow to %1:").arg(text(plan.into.display_name)));
    });
    plan_->setText(lines.join(QLatin1Char('\n')));
    plan_->setVisible(possible);
    merge_->setEnabled(possible);
}

void MergeCard::merge() {
    if (context_.guarded([&] {
            database::PersonMerge(context_.store())
                .merge(context_.session(), person_, chosen(), plain(reason_->text().trimmed()));
        })) {
        reason_->setFocus();  // not on the button that takes this button's place
        context_.say(tr("Merged."));
        emit merged();
    }
}

void MergeCard::undo() {
    if (context_.guarded([&] {
            database::PersonMerge(context_.store())
                .undo(context_.session(), person_, plain(reason_->text().trimmed()));
        })) {
        reason_->setFocus();
        context_.say(tr("The merge was undone."));
        emit merged();
    }
}

}  // namespace fulcrum::ui

#include "moc_merge_card.cpp"
