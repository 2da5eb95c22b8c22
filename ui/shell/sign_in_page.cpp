// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/sign_in_page.h"

#include <QFormLayout>
#include <QLineEdit>
#include <algorithm>

#include "database/records/people.h"
#include "ui/page/background_job.h"
#include "ui/page/fields.h"
#include "ui/style/announce.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

BackgroundJob* sign_in_job(QObject* parent, const std::string& store_path, const std::string& login,
                           const std::string& password, std::optional<database::Role> role,
                           std::function<void(const database::Session&)> done,
                           std::function<void(const QString&)> refused) {
    auto session = std::make_shared<std::optional<database::Session>>();
    return BackgroundJob::run(
        parent,
        [=](const Progress&) {
            const database::Store store = database::Store::open(store_path);
            *session = database::People(store).sign_in(login, password, role);
        },
        [session, done = std::move(done)] { done(**session); }, std::move(refused));
}

SignInPage::SignInPage(Context& context) : Page(context, "sign_in_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(16);
    layout->addSpacing(30);
    programme_ = make_label({}, "title");
    layout->addWidget(programme_);
    notice_ = make_label({}, "muted");
    layout->addWidget(notice_);

    auto* row = new QHBoxLayout;
    row->setSpacing(18);
    form_ = make_card(10);
    card_layout(form_)->addWidget(make_label(tr("Sign in"), "heading"));
    auto* form = new QFormLayout;
    form->setSpacing(10);
    login_ = make_field(form, tr("Login"), "login", false);
    password_ = make_field(form, tr("Password"), "password", true);
    card_layout(form_)->addLayout(form);
    problem_ = make_label({}, "bad");
    problem_->setObjectName(QStringLiteral("sign_in_problem"));
    problem_->setMinimumHeight(36);
    card_layout(form_)->addWidget(problem_);
    job_ = new JobBar;
    card_layout(form_)->addWidget(job_);
    button_ = make_button(tr("Sign in"), "sign_in", "primary");
    card_layout(form_)->addWidget(button_);
    QPushButton* lost = make_button(tr("Forgotten password?"), "forgotten_password", "link");
    card_layout(form_)->addWidget(lost, 0, Qt::AlignLeft);
    card_layout(form_)->addStretch();
    connect(button_, &QPushButton::clicked, this, &SignInPage::sign_in);
    connect(login_, &QLineEdit::returnPressed, password_, [this] { password_->setFocus(); });
    connect(password_, &QLineEdit::returnPressed, this, &SignInPage::sign_in);
    row->addWidget(form_, 3);

    picker_ = make_card(6);
    card_layout(picker_)->addWidget(make_label(tr("Recently signed in here"), "heading"));
    picker_list_ = new QVBoxLayout;
    card_layout(picker_)->addLayout(picker_list_);
    card_layout(picker_)->addStretch();
    row->addWidget(picker_, 2);
    layout->addLayout(row);

    recovery_ = build_recovery();
    layout->addWidget(recovery_);
    new_code_card_ = build_new_code();
    layout->addWidget(new_code_card_);
    connect(lost, &QPushButton::clicked, this, [this] {
        recovery_->setVisible(!recovery_->isVisible());
        if (recovery_->isVisible()) recovery_login_->setFocus();
    });

    demo_ = make_card(8);
    card_layout(demo_)->addWidget(make_label(tr("Look around as"), "heading"));
    demo_list_ = new QVBoxLayout;
    card_layout(demo_)->addLayout(demo_list_);
    QPushButton* back = make_button(tr("Leave the demonstration"), "leave_demo", "link");
    connect(back, &QPushButton::clicked, this, &SignInPage::leave_demo);
    card_layout(demo_)->addWidget(back, 0, Qt::AlignLeft);
    layout->addWidget(demo_);
    layout->addStretch();

    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 900, PagePlace::centred));
    setFocusProxy(login_);
}

QFrame* SignInPage::build_recovery() {
    QFrame* card = make_card(10);
    card_layout(card)->addWidget(make_label(tr("Forgotten password"), "heading"));
    card_layout(card)->addWidget(
        make_label(tr("An administrator can give you a one-time password, valid for 24 hours. The last "
                      "administrator uses the recovery code instead:"),
                   "muted"));
    auto* form = new QFormLayout;
    form->setSpacing(10);
    recovery_login_ = make_field(form, tr("Administrator's login"), "recovery_login", false);
    recovery_code_ = make_field(form, tr("Recovery code"), "recovery_code_field", false);
    recovery_password_ = make_field(form, tr("New password"), "recovery_password", true);
    card_layout(card)->addLayout(form);
    for (QLineEdit* edit : {recovery_code_, recovery_password_}) mark_begun(edit, tr("a new password"));
    recover_ = make_button(tr("Set the new password"), "recover");
    connect(recover_, &QPushButton::clicked, this, &SignInPage::recover);
    card_layout(card)->addWidget(recover_, 0, Qt::AlignRight);
    card->hide();
    return card;
}

QFrame* SignInPage::build_new_code() {
    QFrame* card = make_card(10);
    card_layout(card)->addWidget(make_label(tr("Your new recovery code"), "heading"));
    card_layout(card)->addWidget(
        make_label(tr("The password was changed. The code that you used no longer works, and this one is "
                      "shown only once. Write it down and lock it away: without it, the last administrator "
                      "cannot set a new password.")));
    new_code_ = make_code_label("new_recovery_code");
    card_layout(card)->addWidget(new_code_);
    noted_ = make_button(tr("I have written it down"), "new_code_noted", "primary");
    connect(noted_, &QPushButton::clicked, this, [this] {
        new_code_->clear();
        new_code_card_->hide();
        form_->setEnabled(true);
        login_->setFocus();
    });
    card_layout(card)->addWidget(noted_, 0, Qt::AlignLeft);
    card->hide();
    return card;
}

void SignInPage::enter() {
    const bool demo = context().store().is_demo();
    const std::string name = context().store().programme_name();
    programme_->setText(demo ? tr("Demonstration programme") : text(name));
    form_->setVisible(!demo);
    demo_->setVisible(demo);
    recovery_->hide();
    problem_->clear();
    password_->clear();
    const auto& interrupted = context().store().interrupted_at_open();
    notice_->setVisible(!interrupted.empty());
    if (!interrupted.empty()) {
        notice_->setText(
            tr("%n attempts were running when the program last ended. They are listed as interrupted; "
               "everything recorded until then is kept.",
               nullptr, static_cast<int>(interrupted.size())));
    }
    if (demo) {
        picker_->hide();
        fill_demo();
    } else {
        fill_picker();
        login_->setFocus();
    }
}

void SignInPage::leave() {
    for (QLineEdit* edit : {password_, recovery_code_, recovery_password_}) edit->clear();
}

void SignInPage::fill_picker() {
    clear_layout(picker_list_);
    std::vector<database::RecentSignIn> recent;
    context().guarded([&] {
        recent = database::People(context().store()).recent_sign_ins(context().store().station_session());
    });
    picker_->setVisible(!recent.empty());
    for (const database::RecentSignIn& who : recent) {
        QPushButton* pick = make_button(text(who.display_name), "pick_person", "rail");
        pick->setToolTip(text(who.login));
        connect(pick, &QPushButton::clicked, this, [this, login = text(who.login)] {
            login_->setText(login);
            password_->setFocus();
        });
        picker_list_->addWidget(pick);
    }
}

void SignInPage::fill_demo() {
    clear_layout(demo_list_);
    context().guarded([&] {
        const database::People people(context().store());
        const std::vector<database::Person> all = people.list(context().store().station_session());
        constexpr int shown_trainees = 6;
        for (const database::Role role : {database::Role::trainee, database::Role::educator,
                                          database::Role::director, database::Role::administrator}) {
            int listed = 0;
            for (const database::Person& person : all) {
                if (std::find(person.roles.begin(), person.roles.end(), role) == person.roles.end()) continue;
                if (role == database::Role::trainee && ++listed > shown_trainees) continue;
                QPushButton* pick = make_button(
                    tr("%1 — %2").arg(text(person.display_name), role_text(database::role_name(role))),
                    "pick_demo_person", "rail");
                connect(pick, &QPushButton::clicked, this, [this, login = person.login, role] {
                    context().guarded([&] {
                        context().set_session(database::People(context().store()).demo_session(login, role));
                    });
                });
                demo_list_->addWidget(pick);
            }
            if (listed > shown_trainees)
                demo_list_->addWidget(make_label(
                    tr("Educators and the director see %n more trainee(s).", "", listed - shown_trainees),
                    "muted"));
        }
    });
}

void SignInPage::sign_in() {
    if (busy_) return;
    if (login_->text().trimmed().isEmpty() || password_->text().isEmpty()) {
        announce_problem(problem_, tr("Enter your login and your password."));
        (login_->text().trimmed().isEmpty() ? login_ : password_)->setFocus();
        return;
    }
    set_busy(true);
    problem_->clear();
    BackgroundJob* job = sign_in_job(
        this, context().store().path(), plain(login_->text().trimmed()), plain(password_->text()),
        std::nullopt,
        [this](const database::Session& session) {
            password_->clear();
            context().set_session(session);
        },
        [this](const QString& why) {
            password_->clear();
            announce_problem(problem_, why);
            password_->setFocus();
        });
    connect(job, &BackgroundJob::ended, this, [this] {
        set_busy(false);
        if (!context().signed_in()) password_->setFocus();
    });
    job_->watch(job, tr("Signing in …"));
}

void SignInPage::set_busy(bool busy) {
    busy_ = busy;
    button_->setEnabled(!busy);
    recover_->setEnabled(!busy);
}

void SignInPage::recover() {
    if (busy_) return;
    set_busy(true);
    problem_->clear();
    auto next = std::make_shared<std::string>();
    BackgroundJob* job = BackgroundJob::run(
        this,
        [next, path = context().store().path(), login = plain(recovery_login_->text().trimmed()),
         code = plain(recovery_code_->text().trimmed()),
         password = plain(recovery_password_->text())](const Progress&) {
            const database::Store store = database::Store::open(path);
            *next = database::People(store).recover_administrator(login, code, password);
        },
        [this, next] {
            recovery_password_->clear();
            recovery_code_->clear();
            recovery_->hide();
            // It is nowhere else: nobody signs in before it is confirmed, as where a programme is created.
            form_->setEnabled(false);
            new_code_->setText(text(*next));
            new_code_card_->show();
            new_code_->setFocus();  // not on the button that takes it away
        },
        [this](const QString& why) { announce_problem(problem_, why); });
    connect(job, &BackgroundJob::ended, this, [this] { set_busy(false); });
    job_->watch(job, tr("Checking the recovery code …"), JobBar::Cancel::none);
}

}  // namespace fulcrum::ui

#include "moc_sign_in_page.cpp"
