// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/draft_merge_card.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <optional>

#include "sim_core/numerics/name_table.h"
#include "ui/dashboards/curriculum_forms.h"
#include "ui/dashboards/pass_rule_designer.h"
#include "ui/style/flow_row.h"
#include "ui/style/remedy_words.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

QString list_or_none(const QStringList& words, const QString& between = QStringLiteral(", ")) {
    return words.isEmpty() ? DraftMergeCard::tr("none") : words.join(between);
}

QString ids_in_words(const std::vector<std::string>& ids) {
    QStringList words;
    for (const std::string& id : ids) words << text(id);
    return list_or_none(words);
}

template <typename Item, typename Id>
QString order_in_words(const std::vector<Item>& items, Id Item::*id) {
    QStringList words;
    for (const Item& one : items) words << text(one.*id);
    return list_or_none(words);
}

QString ratings_in_words(const std::optional<RatingRule>& rule, bool exact) {
    if (!rule) return DraftMergeCard::tr("none");
    const QString mean = exact ? QString::number(rule->lowest_mean, 'g', 15) : figure(rule->lowest_mean);
    QStringList words{DraftMergeCard::tr("form %1").arg(text(rule->form)),
                      DraftMergeCard::tr("raters: %1").arg(rule->raters),
                      DraftMergeCard::tr("lowest mean %1").arg(mean)};
    if (!rule->items.empty()) words << DraftMergeCard::tr("items: %1").arg(ids_in_words(rule->items));
    if (rule->every_item) words << DraftMergeCard::tr("each item");
    if (rule->blind) words << DraftMergeCard::tr("blind");
    return words.join(QStringLiteral(", "));
}

QString remedies_in_words(const CurriculumTask& task, const std::vector<TaskDefinition>& tasks, bool exact) {
    QStringList words;
    for (const Remedy& one : task.remedies) {
        words << remedy_words(one, task.task, tasks);
        if (exact) words.back() += QStringLiteral(" (%1)").arg(QString::number(one.bound, 'g', 15));
    }
    return list_or_none(words, QStringLiteral("; "));
}

QString devices_in_words(const CurriculumTask& task) {
    QStringList classes;
    for (const DeviceClass one : task.device_classes) classes << device_class_text(one);
    return list_or_none(classes);
}

QString stage_in_words(const Curriculum& of, const std::string& id) {
    const CurriculumStage* stage = of.find_stage(id);
    return stage == nullptr ? DraftMergeCard::tr("not in it") : text(stage->title);
}

using Tasks = std::vector<TaskDefinition>;

struct PartWords {
    DraftPart kind;
    CurriculumField field;  ///< where it is shown
    const char* name;       ///< with %1 for its stage; null: of a task, by the name of the field
    /// Its value: of the curriculum and its stages, or of a task; the other is null. `exact`: with every
    /// digit, where the usual words are the same on both sides.
    QString (*of_curriculum)(const Curriculum& of, const std::string& id);
    QString (*of_task)(const CurriculumTask& task, const Tasks& tasks, bool exact);
};
constexpr PartWords part_rows[] = {
    {DraftPart::title, CurriculumField::title,
     QT_TRANSLATE_NOOP("fulcrum::ui::DraftMergeCard", "Title of the curriculum"),
     [](const Curriculum& of, const std::string&) { return text(of.title); }, nullptr},
    {DraftPart::stage_order, CurriculumField::stages,
     QT_TRANSLATE_NOOP("fulcrum::ui::DraftMergeCard", "Order of the stages"),
     [](const Curriculum& of, const std::string&) { return order_in_words(of.stages, &CurriculumStage::id); },
     nullptr},
    {DraftPart::stage, CurriculumField::stages, QT_TRANSLATE_NOOP("fulcrum::ui::DraftMergeCard", "Stage %1"),
     stage_in_words, nullptr},
    {DraftPart::stage_title, CurriculumField::stages,
     QT_TRANSLATE_NOOP("fulcrum::ui::DraftMergeCard", "Title of stage %1"), stage_in_words, nullptr},
    {DraftPart::task_order, CurriculumField::title,
     QT_TRANSLATE_NOOP("fulcrum::ui::DraftMergeCard", "Order of the tasks"),
     [](const Curriculum& of, const std::string&) { return order_in_words(of.tasks, &CurriculumTask::task); },
     nullptr},
    {DraftPart::task, CurriculumField::task, nullptr, nullptr,
     [](const CurriculumTask&, const Tasks&, bool) { return DraftMergeCard::tr("in it"); }},
    {DraftPart::task_stage, CurriculumField::stage, nullptr, nullptr,
     [](const CurriculumTask& task, const Tasks&, bool) { return text(task.stage); }},
    {DraftPart::after, CurriculumField::after, nullptr, nullptr,
     [](const CurriculumTask& task, const Tasks&, bool) { return ids_in_words(task.after); }},
    {DraftPart::rule, CurriculumField::rule, nullptr, nullptr,
     [](const CurriculumTask& task, const Tasks&, bool exact) {
         return exact ? text(pass_rule_text(task.rule)) : pass_rule_words(task.rule);
     }},
    {DraftPart::variants, CurriculumField::variants, nullptr, nullptr,
     [](const CurriculumTask& task, const Tasks&, bool) { return QString::number(task.variants); }},
    {DraftPart::devices, CurriculumField::devices, nullptr, nullptr,
     [](const CurriculumTask& task, const Tasks&, bool) { return devices_in_words(task); }},
    {DraftPart::ratings, CurriculumField::ratings, nullptr, nullptr,
     [](const CurriculumTask& task, const Tasks&, bool exact) {
         return ratings_in_words(task.ratings, exact);
     }},
    {DraftPart::remedies, CurriculumField::remedies, nullptr, nullptr, remedies_in_words},
};
static_assert(in_order(part_rows) &&
                  std::size(part_rows) == static_cast<std::size_t>(DraftPart::remedies) + 1,
              "a row for every part, in the enum's order");

QString value_in_words(const DraftDifference& one, const Curriculum& of, const Tasks& tasks, bool exact) {
    const PartWords& row = row_of(part_rows, one.part);
    if (row.of_curriculum != nullptr) return row.of_curriculum(of, one.of);
    const CurriculumTask* task = of.find(one.of);
    return task == nullptr ? DraftMergeCard::tr("not in it") : row.of_task(*task, tasks, exact);
}

QString note_words(const DraftMeeting& meeting, int in_force) {
    QStringList taken;
    for (const DraftDifference& one : meeting.taken) taken << part_words(one);
    switch (meeting.base) {
        case DraftMeeting::Base::known:
            return DraftMergeCard::tr(
                       "This draft was begun from version %1; version %2 is in force now. Taken from it: %3.")
                .arg(meeting.from)
                .arg(in_force)
                .arg(list_or_none(taken, QStringLiteral("; ")));
        case DraftMeeting::Base::not_here:
            return DraftMergeCard::tr(
                       "This draft was begun from a version %1 that this station does not have. So it cannot "
                       "be known which of its differences from version %2 are its author's changes. Exchange "
                       "with the programme server first and open the draft again, or decide each of them.")
                .arg(meeting.from)
                .arg(in_force);
        case DraftMeeting::Base::not_named:
            break;
    }
    return DraftMergeCard::
        tr("This draft does not say from which version it was begun: an older program saved it, or it was "
           "written elsewhere. So it cannot be known which of its differences from version %1 are its "
           "author's changes, and which were published since. Decide each of them.")
            .arg(in_force);
}

}  // namespace

QString part_words(const DraftDifference& one) {
    const PartWords& row = row_of(part_rows, one.part);
    if (row.name == nullptr) return text(one.of) + QStringLiteral(", ") + field_words(row.field);
    return DraftMergeCard::tr(row.name).replace(QLatin1String("%1"), text(one.of));
}

CurriculumField field_of(const DraftDifference& one, const Curriculum& draft) {
    const PartWords& row = row_of(part_rows, one.part);
    const bool is_away = row.of_task != nullptr && draft.find(one.of) == nullptr;
    return is_away ? CurriculumField::title : row.field;
}

BothValues both_values(const DraftDifference& one, const Curriculum& draft, const Curriculum& in_force,
                       const std::vector<TaskDefinition>& tasks) {
    BothValues both{value_in_words(one, draft, tasks, false), value_in_words(one, in_force, tasks, false)};
    if (both.draft == both.in_force)
        both = {value_in_words(one, draft, tasks, true), value_in_words(one, in_force, tasks, true)};
    return both;
}

DraftMergeCard::DraftMergeCard(QWidget* parent) : QWidget(parent) {
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QFrame* card = make_card(6);
    outer->addWidget(card);
    card_layout(card)->addWidget(make_label(tr("Changes by two authors"), "heading"));
    note_ = make_label({});
    note_->setObjectName(QStringLiteral("merge_note"));
    card_layout(card)->addWidget(note_);
    ask_ = make_label(tr("Decide each of these; nothing can be published before."));
    card_layout(card)->addWidget(ask_);
    list_ = new QListWidget;
    list_->setObjectName(QStringLiteral("merge_list"));
    list_->setAccessibleName(tr("Changes by two authors"));
    list_->setWordWrap(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMinimumHeight(8 * fontMetrics().height());
    card_layout(card)->addWidget(list_);
    choice_ = new QWidget;
    auto* row = new FlowRow(choice_);
    row->setContentsMargins(0, 0, 0, 0);
    keep_ = make_button(tr("Keep the draft's"), "merge_keep");
    take_ = make_button({}, "merge_take");
    row->add(keep_);
    row->add(take_);
    card_layout(card)->addWidget(choice_);
    connect(list_, &QListWidget::itemActivated, this, [this] { emit place_wanted(list_->currentRow()); });
    connect(list_, &QListWidget::itemClicked, this, [this] { emit place_wanted(list_->currentRow()); });
    connect(keep_, &QPushButton::clicked, this, [this] { emit decided(list_->currentRow(), false); });
    connect(take_, &QPushButton::clicked, this, [this] { emit decided(list_->currentRow(), true); });
    hide();
}

void DraftMergeCard::show_meeting(const DraftMeeting* meeting, const Curriculum& draft,
                                  const Curriculum& in_force, const std::vector<TaskDefinition>& tasks) {
    setVisible(meeting != nullptr);
    if (meeting == nullptr) {
        list_->clear();
        return;
    }
    note_->setText(note_words(*meeting, in_force.version));
    const bool open = !meeting->collisions.empty();
    for (QWidget* part : std::initializer_list<QWidget*>{ask_, list_, choice_}) part->setVisible(open);
    take_->setText(tr("As in version %1").arg(in_force.version));
    take_->setAccessibleName(take_->text());
    const int row = std::max(0, list_->currentRow());
    list_->clear();
    for (const DraftDifference& one : meeting->collisions) {
        const BothValues both = both_values(one, draft, in_force, tasks);
        list_->addItem(part_words(one) + QLatin1Char('\n') + tr("Draft: %1").arg(both.draft) +
                       QLatin1Char('\n') + tr("Version %1: %2").arg(in_force.version).arg(both.in_force));
    }
    list_->setCurrentRow(std::min(row, list_->count() - 1));
}

}  // namespace fulcrum::ui

#include "moc_draft_merge_card.cpp"
