// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/first_start_page.h"

#include <QCheckBox>
#include <QClipboard>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLineEdit>
#include <QStackedWidget>

#include "database/records/people.h"
#include "ui/page/background_job.h"
#include "ui/page/fields.h"
#include "ui/shell/join_form.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

FirstStartPage::FirstStartPage(Context& context) : Page(context, "first_start_page") {
    steps_ = new QStackedWidget;
    steps_->addWidget(build_choice());
    steps_->addWidget(build_form());
    steps_->addWidget(build_recovery());
    steps_->addWidget(join_ = new JoinForm(context));
    connect(join_, &JoinForm::back, this, [this] { steps_->setCurrentIndex(0); });
    connect(join_, &JoinForm::joined, this, [this] {
        forget_input();
        emit programme_joined();
    });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scrolled(steps_, 860, PagePlace::centred));
}

QWidget* FirstStartPage::build_choice() {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(18);
    layout->addSpacing(40);
    layout->addWidget(make_label(QStringLiteral("Fulcrum"), "title"));
    layout->addWidget(
        make_label(tr("A simulator for laparoscopic rectal surgery with its training programme: tasks, "
                      "scores with their evidence, reviews and reports.")));
    auto* row = new QHBoxLayout;
    row->setSpacing(18);
    QFrame* create = make_card(12);
    card_layout(create)->addWidget(make_label(tr("Create programme"), "heading"));
    card_layout(create)->addWidget(
        make_label(tr("For a department or a training centre. You become its first administrator and then "
                      "add people, roles and cohorts."),
                   "muted"));
    card_layout(create)->addStretch();
    start_create_ = make_button(tr("Create programme"), "create_programme", "primary");
    connect(start_create_, &QPushButton::clicked, this, [this] {
        steps_->setCurrentIndex(1);
        programme_->setFocus();
    });
    card_layout(create)->addWidget(start_create_);
    row->addWidget(create);
    QFrame* look = make_card(12);
    card_layout(look)->addWidget(make_label(tr("Look around"), "heading"));
    card_layout(look)->addWidget(make_label(
        tr("A demonstration programme: 24 simulated trainees after 12 weeks of training. The people are not "
           "real; their attempts were simulated in full. You can practise, and every screen has content."),
        "muted"));
    card_layout(look)->addStretch();
    QPushButton* look_button = make_button(tr("Look around"), "look_around");
    connect(look_button, &QPushButton::clicked, this, &FirstStartPage::look_around);
    card_layout(look)->addWidget(look_button);
    row->addWidget(look);
    layout->addLayout(row);
    layout->addWidget(build_join());
    job_ = new JobBar;
    layout->addWidget(job_);
    layout->addStretch();
    return body;
}

QFrame* FirstStartPage::build_join() {
    QFrame* card = make_card(8);
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    row->add(make_label(tr("Is this a further station of a programme that has a server? Join it with a token "
                           "of the server's owner."),
                        "muted"),
             1, 300);
    start_join_ = make_button(tr("Join a programme"), "join_programme");
    connect(start_join_, &QPushButton::clicked, this, [this] {
        steps_->setCurrentWidget(join_);
        join_->begin();
    });
    row->add(start_join_);
    card_layout(card)->addWidget(holder);
    auto* restore_holder = new QWidget;
    auto* restore_row = new FlowRow(restore_holder);
    restore_row->add(
        make_label(tr("Is there a backup of a programme, from this machine or another one?"), "muted"), 1,
        300);
    QPushButton* restore = make_button(tr("Restore a backup"), "first_restore");
    connect(restore, &QPushButton::clicked, this, &FirstStartPage::restore_wanted);
    restore_row->add(restore);
    card_layout(card)->addWidget(restore_holder);
    return card;
}

QWidget* FirstStartPage::build_form() {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addSpacing(30);
    layout->addWidget(make_label(tr("Create programme"), "title"));
    QFrame* card = make_card(10);
    auto* form = new QFormLayout;
    form->setSpacing(10);
    const auto field = [form](const QString& label, const char* name, bool secret) {
        QLineEdit* edit = make_field(form, label, name, secret);
        mark_begun(edit, tr("a programme that is not created yet"));
        return edit;
    };
    programme_ = field(tr("Programme"), "programme_name", false);
    programme_->setPlaceholderText(tr("for example: Department of Surgery"));
    name_ = field(tr("Your name"), "administrator_name", false);
    login_ = field(tr("Your login"), "administrator_login", false);
    login_->setPlaceholderText(tr("Letters, digits and . _ - @"));
    password_ = field(tr("Password"), "administrator_password", true);
    password_->setPlaceholderText(tr("at least %1 characters").arg(database::password_minimum_length));
    repeat_ = field(tr("Password again"), "administrator_password_again", true);
    card_layout(card)->addLayout(form);
    problem_ = make_label({}, "bad");
    card_layout(card)->addWidget(problem_);
    create_job_ = new JobBar;
    card_layout(card)->addWidget(create_job_);
    auto* buttons = new QHBoxLayout;
    back_ = make_button(tr("Back"), "create_back");
    connect(back_, &QPushButton::clicked, this, [this] { steps_->setCurrentIndex(0); });
    create_ = make_button(tr("Create programme"), "create_confirm", "primary");
    connect(create_, &QPushButton::clicked, this, &FirstStartPage::create);
    enter_leads_on({programme_, name_, login_, password_, repeat_}, create_);
    buttons->addWidget(back_);
    buttons->addStretch();
    buttons->addWidget(create_);
    card_layout(card)->addLayout(buttons);
    layout->addWidget(card);
    layout->addStretch();
    return body;
}

QWidget* FirstStartPage::build_recovery() {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addSpacing(30);
    layout->addWidget(make_label(tr("Your recovery code"), "title"));
    QFrame* card = make_card(12);
    card_layout(card)->addWidget(
        make_label(tr("This code is shown only once. Write it down and lock it away: without it, the last "
                      "administrator cannot set a new password.")));
    code_ = make_code_label("recovery_code");
    card_layout(card)->addWidget(code_);
    QPushButton* copy = make_button(tr("Copy"), "copy_code");
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(code_->text()); });
    card_layout(card)->addWidget(copy, 0, Qt::AlignLeft);
    auto* noted = new QCheckBox(tr("I have written it down"));
    noted->setObjectName(QStringLiteral("code_noted"));
    card_layout(card)->addWidget(noted);
    continue_ = make_button(tr("Continue"), "code_continue", "primary");
    continue_->setEnabled(false);
    connect(noted, &QCheckBox::toggled, continue_, &QWidget::setEnabled);
    connect(continue_, &QPushButton::clicked, this, [this] {
        code_->clear();
        emit programme_created();
    });
    card_layout(card)->addWidget(continue_, 0, Qt::AlignRight);
    layout->addWidget(card);
    layout->addStretch();
    return body;
}

void FirstStartPage::enter() {
    steps_->setCurrentIndex(0);
    start_create_->setFocus();
}

QStringList FirstStartPage::begun_input(Ending ending) const {
    return ending == Ending::session ? QStringList() : Page::begun_input(ending);
}

void FirstStartPage::forget_input() {
    for (QLineEdit* edit : findChildren<QLineEdit*>()) edit->clear();
}

void FirstStartPage::create() {
    if (!create_->isEnabled()) return;
    if (password_->text() != repeat_->text()) {
        announce_problem(problem_, tr("The two passwords are not the same."));
        repeat_->setFocus();
        return;
    }
    if (password_->text().size() < database::password_minimum_length) {
        announce_problem(
            problem_,
            tr("The password needs at least %1 characters.").arg(database::password_minimum_length));
        password_->setFocus();
        return;
    }
    problem_->clear();
    std::string path;
    if (!context().guarded([&] {
            context().services().open_store(false);
            path = context().store().path();
        })) {
        return;
    }
    auto created = std::make_shared<std::optional<database::CreatedProgramme>>();
    for (QPushButton* button : {create_, back_}) button->setEnabled(false);
    const std::string programme = plain(programme_->text().trimmed()),
                      login = plain(login_->text().trimmed()), name = plain(name_->text().trimmed()),
                      password = plain(password_->text());
    BackgroundJob* job = BackgroundJob::run(
        this,
        [=](const Progress&) {
            const database::Store store = database::Store::open(path);
            *created = database::People(store).create_programme(programme, login, name, password);
        },
        [this, created] {
            forget_input();
            code_->setText(text((*created)->recovery_code));
            context().set_session((*created)->administrator);
            steps_->setCurrentIndex(2);
            code_->setFocus();
        },
        [this](const QString& error) { announce_problem(problem_, error); });
    connect(job, &BackgroundJob::ended, this, [this] {
        for (QPushButton* button : {create_, back_}) button->setEnabled(true);
    });
    create_job_->watch(job, tr("Creating the programme …"), JobBar::Cancel::none);
}

void FirstStartPage::look_around() {
    if (context().services().demo_is_built()) {
        open_demo();
        return;
    }
    StoreService* services = &context().services();
    auto built = std::make_shared<bool>(false);
    BackgroundJob* job = BackgroundJob::run(
        this, [services, built](const Progress& progress) { *built = services->unpack_demo(progress); },
        [this, built] {
            // Only where the person waits for it: another form may be open, and its programme in the making.
            if (*built && steps_->currentIndex() == 0) open_demo();
        },
        [this](const QString& error) { context().complain(error); });
    job_->watch(job, tr("Unpacking the demonstration programme …"));
}

void FirstStartPage::open_demo() {
    if (context().guarded([&] { context().services().open_store(true); })) emit demo_opened();
}

}  // namespace fulcrum::ui

#include "moc_first_start_page.cpp"
