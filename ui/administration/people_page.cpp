// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/people_page.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableWidget>
#include <algorithm>

#include "ui/administration/changes.h"
#include "ui/administration/import_card.h"
#include "ui/administration/merge_card.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr database::Role roles_of_people[] = {database::Role::trainee, database::Role::educator,
                                              database::Role::director, database::Role::administrator};

std::vector<QCheckBox*> add_role_boxes(QFormLayout* form, const QString& label, const char* prefix) {
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    std::vector<QCheckBox*> boxes;
    for (const database::Role role : roles_of_people) {
        auto* box = new QCheckBox(role_text(database::role_name(role)));
        box->setObjectName(QString::fromLatin1(prefix) + QString::fromLatin1(database::role_name(role)));
        row->add(box);
        boxes.push_back(box);
    }
    form->addRow(label, holder);
    return boxes;
}

std::vector<database::Role> chosen(const std::vector<QCheckBox*>& boxes) {
    std::vector<database::Role> roles;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i]->isChecked()) roles.push_back(roles_of_people[i]);
    }
    return roles;
}

}  // namespace

PeoplePage::PeoplePage(Context& context) : Page(context, "people_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addWidget(make_label(tr("People"), "title"));
    secret_ = make_card(8);
    card_layout(secret_)->addWidget(make_label(tr("One-time password"), "heading"));
    secret_text_ = make_label({});
    secret_text_->setObjectName(QStringLiteral("one_time_password"));
    secret_text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    secret_text_->setFocusPolicy(Qt::StrongFocus);  // to be read and copied without a mouse
    card_layout(secret_)->addWidget(secret_text_);
    QPushButton* noted = make_button(tr("I have handed it over"), "password_noted");
    connect(noted, &QPushButton::clicked, this, [this] {
        issued_.clear();
        secret_text_->clear();
        secret_text_->setProperty("password", QVariant());
        secret_->hide();
    });
    card_layout(secret_)->addWidget(noted, 0, Qt::AlignLeft);
    secret_->hide();
    layout->addWidget(secret_);
    layout->addWidget(build_add());
    table_ =
        make_table({tr("Name"), tr("Login"), tr("Roles"), tr("Account"), tr("Last sign-in")}, "people_table");
    table_->setAccessibleName(tr("People"));
    table_->setMinimumHeight(240);
    layout->addWidget(table_);
    layout->addWidget(build_editor());
    import_ = new ImportCard(context);
    connect(import_, &ImportCard::imported, this, &PeoplePage::fill);
    layout->addWidget(import_);
    picker_ = new QCheckBox(
        in_lines(tr("On the sign-in screen, list the people who signed in here in the last 30 days"),
                 fontMetrics(), widest_line));
    picker_->setObjectName(QStringLiteral("sign_in_picker"));
    connect(picker_, &QCheckBox::clicked, this, [this](bool on) {
        this->context().guarded([&] {
            database::People(this->context().store()).set_sign_in_picker(this->context().session(), on);
        });
    });
    layout->addWidget(picker_);
    layout->addStretch(1);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &PeoplePage::select);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000));
}

QFrame* PeoplePage::build_add() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Add a person"), "heading"));
    auto* form = new QFormLayout;
    form->setSpacing(8);
    new_name_ = new QLineEdit;
    new_name_->setObjectName(QStringLiteral("new_person_name"));
    mark_begun(new_name_, tr("a person who is not added yet"));
    form->addRow(tr("Name"), new_name_);
    new_login_ = new QLineEdit;
    new_login_->setObjectName(QStringLiteral("new_person_login"));
    mark_begun(new_login_, tr("a person who is not added yet"));
    new_login_->setPlaceholderText(tr("Letters, digits and . _ - @"));
    form->addRow(tr("Login"), new_login_);
    new_roles_ = add_role_boxes(form, tr("Roles"), "new_role_");
    new_roles_.front()->setChecked(true);
    card_layout(card)->addLayout(form);
    QPushButton* button = make_button(tr("Add person"), "add_person", "primary");
    connect(button, &QPushButton::clicked, this, &PeoplePage::add);
    card_layout(card)->addWidget(button, 0, Qt::AlignLeft);
    return card;
}

QFrame* PeoplePage::build_editor() {
    editor_ = make_card(8);
    who_ = make_label({}, "heading");
    card_layout(editor_)->addWidget(who_);
    auto* form = new QFormLayout;
    form->setSpacing(8);
    name_ = new QLineEdit;
    name_->setObjectName(QStringLiteral("person_name"));
    form->addRow(tr("Name"), name_);
    login_ = new QLineEdit;
    login_->setObjectName(QStringLiteral("person_login"));
    form->addRow(tr("Login"), login_);
    roles_ = add_role_boxes(form, tr("Roles"), "role_");
    card_layout(editor_)->addLayout(form);
    auto* row = new QHBoxLayout;
    QPushButton* save_button = make_button(tr("Save"), "save_person", "primary");
    connect(save_button, &QPushButton::clicked, this, &PeoplePage::save);
    QPushButton* issue_button = make_button(tr("Issue one-time password"), "issue_password");
    connect(issue_button, &QPushButton::clicked, this, &PeoplePage::issue);
    active_ = make_button({}, "toggle_active");
    connect(active_, &QPushButton::clicked, this, &PeoplePage::toggle_active);
    row->addWidget(save_button);
    row->addWidget(issue_button);
    row->addWidget(active_);
    row->addStretch();
    card_layout(editor_)->addLayout(row);
    merge_ = new MergeCard(context());
    connect(merge_, &MergeCard::merged, this, &PeoplePage::fill);
    card_layout(editor_)->addWidget(merge_);
    editor_->hide();
    return editor_;
}

void PeoplePage::enter() {
    fill();
    new_name_->setFocus();
    picker_->setVisible(context().allowed(database::Operation::manage_settings));
    context().guarded([&] { picker_->setChecked(database::People(context().store()).sign_in_picker()); });
}

void PeoplePage::leave() {
    import_->stop();
}

QStringList PeoplePage::begun_input(Ending ending) const {
    QStringList begun = Page::begun_input(ending);
    const database::Person* person = selected();
    if (person != nullptr &&
        (plain(name_->text().trimmed()) != person->display_name ||
         plain(login_->text().trimmed()) != person->login || is_changed(person->roles, chosen(roles_))))
        begun << tr("changes to a person");
    return begun;
}

void PeoplePage::fill() {
    const database::Person* before = selected();
    const std::string kept = before == nullptr ? std::string() : before->id;
    context().guarded([&] { people_ = database::People(context().store()).list(context().session()); });
    const QSignalBlocker quiet(table_);
    table_->setRowCount(0);
    table_->clearSelection();
    for (const database::Person& person : people_) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        QStringList roles;
        for (const database::Role role : person.roles) roles << role_text(database::role_name(role));
        QString account = person.active                ? tr("active")
                          : person.merged_into.empty() ? tr("deactivated")
                                                       : tr("merged");
        if (person.kind != database::PersonKind::real) account += tr(" · synthetic");
        table_->setItem(row, 0, make_cell(text(person.display_name)));
        table_->setItem(row, 1, make_cell(text(person.login)));
        table_->setItem(row, 2, make_cell(roles.join(QStringLiteral(", "))));
        table_->setItem(row, 3, make_cell(account));
        table_->setItem(row, 4, make_cell(local_time(person.last_sign_in)));
        if (person.id == kept) table_->selectRow(row);
    }
    fit_columns(table_, {4});
    select();
}

const database::Person* PeoplePage::selected() const {
    const int row = table_->currentRow();
    if (row < 0 || row >= static_cast<int>(people_.size()) || table_->selectedItems().isEmpty())
        return nullptr;
    return &people_[static_cast<std::size_t>(row)];
}

void PeoplePage::select() {
    const database::Person* person = selected();
    editor_->setVisible(person != nullptr);
    if (person == nullptr) return;
    who_->setText(text(person->display_name) + QStringLiteral(" · ") + text(person->login));
    name_->setText(text(person->display_name));
    login_->setText(text(person->login));
    login_->setEnabled(person->kind == database::PersonKind::real && person->merged_into.empty());
    for (std::size_t i = 0; i < roles_.size(); ++i) {
        roles_[i]->setChecked(holds(person->roles, roles_of_people[i]));
    }
    merge_->show_for(*person, people_);
    active_->setEnabled(person->merged_into.empty());
    active_->setText(person->active ? tr("Deactivate") : tr("Activate"));
}

void PeoplePage::show_issued(const Issued& issued) {
    issued_.erase(std::remove_if(issued_.begin(), issued_.end(),
                                 [&](const Issued& one) { return one.person_id == issued.person_id; }),
                  issued_.end());
    QString before;
    for (const Issued& one : issued_) before += QStringLiteral("%1: %2\n").arg(one.who, text(one.password));
    secret_text_->setText(
        before + tr("%1: %2\nValid for 24 hours and shown only now. It must be changed at the first sign-in.")
                     .arg(issued.who, text(issued.password)));
    secret_text_->setProperty("password", text(issued.password));
    issued_.push_back(issued);
    secret_->show();
}

void PeoplePage::add() {
    context().guarded([&] {
        const auto created = database::People(context().store())
                                 .create(context().session(), plain(new_login_->text().trimmed()),
                                         plain(new_name_->text().trimmed()), chosen(new_roles_));
        show_issued({created.person.id, text(created.person.display_name), created.one_time_password});
        new_login_->clear();
        new_name_->clear();
        new_name_->setFocus();
    });
    fill();
}

void PeoplePage::save() {
    const database::Person* person = selected();
    if (person == nullptr) return;
    if (context().guarded([&] {
            const database::People people(context().store());
            const std::string name = plain(name_->text().trimmed());
            if (name != person->display_name) people.rename(context().session(), person->id, name);
            const std::string login = plain(login_->text().trimmed());
            if (login != person->login) people.set_login(context().session(), person->id, login);
            const std::vector<database::Role> roles = chosen(roles_);
            if (is_changed(person->roles, roles)) {
                const database::Person now = people.find(context().session(), person->id).value_or(*person);
                people.set_roles(context().session(), person->id,
                                 with_changes(now.roles, person->roles, roles));
            }
        })) {
        context().say(tr("Saved."));
    }
    fill();
}

void PeoplePage::issue() {
    const database::Person* person = selected();
    if (person == nullptr) return;
    context().guarded([&] {
        show_issued(
            {person->id, text(person->display_name),
             database::People(context().store()).issue_one_time_password(context().session(), person->id)});
    });
}

void PeoplePage::toggle_active() {
    const database::Person* person = selected();
    if (person == nullptr) return;
    context().guarded([&] {
        database::People(context().store()).set_active(context().session(), person->id, !person->active);
    });
    fill();
}

}  // namespace fulcrum::ui

#include "moc_people_page.cpp"
