// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/cohorts_page.h"

#include <QLineEdit>
#include <QListWidget>

#include "ui/administration/changes.h"
#include "ui/page/station_note.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

void fill_checks(QListWidget* list, const std::vector<database::Person>& people, database::Role role,
                 const std::vector<std::string>& checked) {
    list->clear();
    for (const database::Person& person : people) {
        if (!holds(person.roles, role) && !holds(checked, person.id)) continue;
        auto* item = new QListWidgetItem(text(person.display_name), list);
        item->setData(Qt::UserRole, text(person.id));
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setCheckState(holds(checked, person.id) ? Qt::Checked : Qt::Unchecked);
    }
}

/// Whether a check mark is another one than the list was filled with.
bool is_touched(const QListWidget* list, const std::vector<std::string>& filled) {
    for (int row = 0; row < list->count(); ++row) {
        const QListWidgetItem* item = list->item(row);
        const bool was = holds(filled, plain(item->data(Qt::UserRole).toString()));
        if ((item->checkState() == Qt::Checked) != was) return true;
    }
    return false;
}

std::vector<std::string> checked_ids(const QListWidget* list) {
    std::vector<std::string> ids;
    for (int row = 0; row < list->count(); ++row) {
        if (list->item(row)->checkState() == Qt::Checked) {
            ids.push_back(plain(list->item(row)->data(Qt::UserRole).toString()));
        }
    }
    return ids;
}

}  // namespace

CohortsPage::CohortsPage(Context& context) : Page(context, "cohorts_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addWidget(make_label(tr("Assign cohorts"), "title"));
    note_ = new StationNote;
    layout->addWidget(note_);
    auto* add_row = new QHBoxLayout;
    new_name_ = new QLineEdit;
    new_name_->setObjectName(QStringLiteral("new_cohort_name"));
    new_name_->setPlaceholderText(tr("Name of the new cohort"));
    new_name_->setAccessibleName(tr("Name of the new cohort"));
    mark_begun(new_name_, tr("a cohort that is not added yet"));
    add_row->addWidget(new_name_);
    QPushButton* add_button = make_button(tr("Add cohort"), "add_cohort", "primary");
    add_row->addWidget(add_button);
    add_row->addStretch();
    layout->addLayout(add_row);
    // With large text, names have the whole width.
    const bool large = text_percent() > 150;
    const auto direction = large ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
    auto* row = new QBoxLayout(direction);
    list_ = new QListWidget;
    list_->setObjectName(QStringLiteral("cohort_list"));
    list_->setAccessibleName(tr("Cohorts"));
    if (large) {
        list_->setMaximumHeight(4 * fontMetrics().height());
    } else {
        list_->setMaximumWidth(with_text(260));
    }
    row->addWidget(list_, 1);
    editor_ = make_card(8);
    QLabel* name_of = make_label(tr("Name"), "muted");
    card_layout(editor_)->addWidget(name_of);
    name_ = new QLineEdit;
    name_->setObjectName(QStringLiteral("cohort_name"));
    name_->setAccessibleName(tr("Name"));
    name_of->setBuddy(name_);
    card_layout(editor_)->addWidget(name_);
    auto* lists = new QBoxLayout(direction);
    const auto column = [&](const QString& title, const char* name) {
        auto* inner = new QVBoxLayout;
        inner->addWidget(make_label(title, "heading"));
        auto* list = new QListWidget;
        list->setObjectName(QString::fromLatin1(name));
        list->setAccessibleName(title);
        list->setMinimumHeight(280);
        inner->addWidget(list);
        lists->addLayout(inner);
        return list;
    };
    members_ = column(tr("Trainees"), "cohort_members");
    educators_ = column(tr("Educators"), "cohort_educators");
    card_layout(editor_)->addLayout(lists);
    QPushButton* save_button = make_button(tr("Save cohort"), "save_cohort", "primary");
    card_layout(editor_)->addWidget(save_button, 0, Qt::AlignLeft);
    row->addWidget(editor_, 3);
    layout->addLayout(row);
    layout->addStretch(1);
    connect(add_button, &QPushButton::clicked, this, &CohortsPage::add);
    connect(save_button, &QPushButton::clicked, this, &CohortsPage::save);
    connect(list_, &QListWidget::currentRowChanged, this, &CohortsPage::select);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000));
}

void CohortsPage::enter() {
    note_->look(context());
    fill();
    (list_->count() > 0 ? static_cast<QWidget*>(list_) : new_name_)->setFocus();
}

QStringList CohortsPage::begun_input(Ending ending) const {
    QStringList begun = Page::begun_input(ending);
    const database::Cohort* cohort = selected();
    if (cohort != nullptr &&
        (plain(name_->text().trimmed()) != cohort->name || is_touched(members_, cohort->members) ||
         is_touched(educators_, cohort->educators)))
        begun << tr("changes to a cohort");
    return begun;
}

void CohortsPage::fill() {
    const database::Cohort* before = selected();
    const std::string kept = before == nullptr ? std::string() : before->id;
    context().guarded([&] {
        const database::People people(context().store());
        cohorts_ = people.cohorts(context().session());
        people_ = people.list(context().session());
    });
    const QSignalBlocker quiet(list_);
    list_->clear();
    int current = cohorts_.empty() ? -1 : 0;
    for (const database::Cohort& cohort : cohorts_) {
        list_->addItem(text(cohort.name));
        if (cohort.id == kept) current = list_->count() - 1;
    }
    list_->setCurrentRow(current);
    select();
}

const database::Cohort* CohortsPage::selected() const {
    const int row = list_->currentRow();
    return row < 0 || row >= static_cast<int>(cohorts_.size()) ? nullptr
                                                               : &cohorts_[static_cast<std::size_t>(row)];
}

void CohortsPage::select() {
    const database::Cohort* cohort = selected();
    editor_->setVisible(cohort != nullptr);
    if (cohort == nullptr) return;
    name_->setText(text(cohort->name));
    fill_checks(members_, people_, database::Role::trainee, cohort->members);
    fill_checks(educators_, people_, database::Role::educator, cohort->educators);
}

void CohortsPage::add() {
    std::string id;
    if (context().guarded([&] {
            id = database::People(context().store())
                     .create_cohort(context().session(), plain(new_name_->text().trimmed()));
        })) {
        new_name_->clear();
        fill();
        for (std::size_t i = 0; i < cohorts_.size(); ++i) {
            if (cohorts_[i].id == id) list_->setCurrentRow(static_cast<int>(i));
        }
    }
}

void CohortsPage::save() {
    const database::Cohort* cohort = selected();
    if (cohort == nullptr) return;
    if (context().guarded([&] {
            const database::People people(context().store());
            const std::string name = plain(name_->text().trimmed());
            if (name != cohort->name) people.rename_cohort(context().session(), cohort->id, name);
            // Of a cohort that is gone, the store says so.
            const database::Cohort now =
                people.find_cohort(context().session(), cohort->id).value_or(*cohort);
            const std::vector<std::string> members = checked_ids(members_),
                                           educators = checked_ids(educators_);
            if (is_changed(cohort->members, members))
                people.set_members(context().session(), cohort->id,
                                   with_changes(now.members, cohort->members, members));
            if (is_changed(cohort->educators, educators))
                people.set_educators(context().session(), cohort->id,
                                     with_changes(now.educators, cohort->educators, educators));
        })) {
        context().say(tr("Saved."));
    }
    fill();
}

}  // namespace fulcrum::ui

#include "moc_cohorts_page.cpp"
