// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/password_page.h"

#include <QFormLayout>
#include <QLineEdit>

#include "database/records/people.h"
#include "ui/page/background_job.h"
#include "ui/page/fields.h"
#include "ui/style/announce.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

PasswordPage::PasswordPage(Context& context) : Page(context, "password_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addSpacing(30);
    layout->addWidget(make_label(tr("Choose a new password"), "title"));
    QFrame* card = make_card(10);
    why_ = make_label({});
    card_layout(card)->addWidget(why_);
    auto* form = new QFormLayout;
    form->setSpacing(10);
    const auto field = [form](const QString& label, const char* name) {
        QLineEdit* edit = make_field(form, label, name, true);
        mark_begun(edit, tr("a new password"));
        return edit;
    };
    old_ = field(tr("Current password"), "old_password");
    new_ = field(tr("New password"), "new_password");
    new_->setPlaceholderText(tr("at least %1 characters").arg(database::password_minimum_length));
    again_ = field(tr("New password again"), "new_password_again");
    card_layout(card)->addLayout(form);
    problem_ = make_label({}, "bad");
    card_layout(card)->addWidget(problem_);
    job_ = new JobBar;
    card_layout(card)->addWidget(job_);
    auto* buttons = new QHBoxLayout;
    cancel_ = make_button(tr("Cancel"), "password_cancel");
    change_ = make_button(tr("Change password"), "password_change", "primary");
    buttons->addWidget(cancel_);
    buttons->addStretch();
    buttons->addWidget(change_);
    card_layout(card)->addLayout(buttons);
    layout->addWidget(card);
    layout->addStretch();
    connect(change_, &QPushButton::clicked, this, &PasswordPage::change);
    connect(cancel_, &QPushButton::clicked, this, [this] {
        if (this->context().session().must_change_password()) {
            emit this->context().switch_user_wanted();
        } else {
            emit this->context().home_wanted();
        }
    });
    enter_leads_on({old_, new_, again_}, change_);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 640, PagePlace::centred));
}

void PasswordPage::enter() {
    const bool must = context().session().must_change_password();
    why_->setText(
        must ? tr("You signed in with a one-time password. It was made for you by somebody else, so choose "
                  "one that only you know.")
             : tr("It takes effect at your next sign-in."));
    cancel_->setText(must ? tr("Sign out") : tr("Cancel"));
    problem_->clear();
    old_->setFocus();
}

void PasswordPage::leave() {
    for (QLineEdit* edit : {old_, new_, again_}) edit->clear();
}

void PasswordPage::change() {
    if (!change_->isEnabled()) return;
    if (new_->text() != again_->text()) {
        announce_problem(problem_, tr("The two new passwords are not the same."));
        again_->setFocus();
        return;
    }
    if (new_->text().size() < database::password_minimum_length) {
        announce_problem(
            problem_,
            tr("The password needs at least %1 characters.").arg(database::password_minimum_length));
        new_->setFocus();
        return;
    }
    problem_->clear();
    for (QPushButton* button : {change_, cancel_}) button->setEnabled(false);
    auto changed = std::make_shared<std::optional<database::Session>>();
    BackgroundJob* job = BackgroundJob::run(
        this,
        [changed, path = context().store().path(), session = context().session(),
         before = plain(old_->text()), after = plain(new_->text())](const Progress&) {
            const database::Store store = database::Store::open(path);
            *changed = database::People(store).change_password(session, before, after);
        },
        [this, changed] {
            for (QLineEdit* edit : {old_, new_, again_}) edit->clear();
            context().set_session(**changed);
            context().say(tr("Password changed."));
        },
        [this](const QString& why) {
            announce_problem(problem_, why);
            old_->setFocus();
        });
    connect(job, &BackgroundJob::ended, this, [this] {
        for (QPushButton* button : {change_, cancel_}) button->setEnabled(true);
    });
    job_->watch(job, tr("Changing the password …"), JobBar::Cancel::none);
}

}  // namespace fulcrum::ui

#include "moc_password_page.cpp"
