// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/lock_page.h"

#include <QApplication>
#include <QDialog>
#include <QLineEdit>

#include "database/records/people.h"
#include "ui/shell/sign_in_page.h"
#include "ui/style/announce.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// Dialogs, menus and lists that are open would stay usable over the lock, with the session's rights.
void close_what_is_open(const QWidget& window) {
    const QWidget* before = nullptr;
    for (QWidget* popup = QApplication::activePopupWidget(); popup != nullptr && popup != before;
         popup = QApplication::activePopupWidget()) {
        before = popup;
        popup->close();
    }
    for (QDialog* dialog : window.findChildren<QDialog*>()) dialog->reject();
}

}  // namespace

LockPage::LockPage(Context& context) : Page(context, "lock_page") {
    auto* layout = new QVBoxLayout(this);
    layout->addStretch();
    QFrame* card = make_card(12);
    card->setMaximumWidth(with_text(460));
    card->setMinimumWidth(with_text(420));
    card_layout(card)->addWidget(make_label(tr("Locked"), "title"));
    who_ = make_label({});
    card_layout(card)->addWidget(who_);
    notice_ = make_label({}, "muted");
    notice_->setObjectName(QStringLiteral("lock_notice"));
    card_layout(card)->addWidget(notice_);
    password_ = new QLineEdit;
    password_->setObjectName(QStringLiteral("unlock_password"));
    password_->setAccessibleName(tr("Password"));
    password_->setPlaceholderText(tr("Password"));
    password_->setEchoMode(QLineEdit::Password);
    card_layout(card)->addWidget(password_);
    problem_ = make_label({}, "bad");
    card_layout(card)->addWidget(problem_);
    job_ = new JobBar;
    card_layout(card)->addWidget(job_);
    auto* row = new QHBoxLayout;
    other_ = make_button(tr("Switch user"), "lock_switch_user");
    unlock_ = make_button(tr("Unlock"), "unlock", "primary");
    row->addWidget(other_);
    row->addStretch();
    row->addWidget(unlock_);
    card_layout(card)->addLayout(row);
    // Between stretches, not aligned: only so is its height that of its words at its own width.
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addWidget(card, 1000);
    middle->addStretch(1);
    layout->addLayout(middle);
    layout->addStretch();
    connect(other_, &QPushButton::clicked, this, &LockPage::switch_user);
    connect(unlock_, &QPushButton::clicked, this, &LockPage::unlock);
    connect(password_, &QLineEdit::returnPressed, this, &LockPage::unlock);
    // Of somebody who has signed out, it unlocks nothing any longer.
    connect(&context, &Context::session_changed, this, [this] {
        if (checking_ != nullptr) checking_->cancel();
    });
}

void LockPage::enter() {
    close_what_is_open(*window());
    const bool demo = context().session().is_demo();
    who_->setText(tr("%1 is signed in. The content is hidden after ten minutes without input.")
                      .arg(text(context().session().display_name())));
    notice_->clear();
    problem_->clear();
    password_->clear();
    const bool server = context().store().is_server();
    other_->setVisible(!server);
    password_->setPlaceholderText(server ? tr("Password of the server's account") : tr("Password"));
    password_->setVisible(!demo);
    (demo ? static_cast<QWidget*>(unlock_) : password_)->setFocus();
}

void LockPage::set_notice(const QString& line) {
    announce_problem(notice_, line);
}

void LockPage::unlock() {
    if (!unlock_->isEnabled()) return;
    if (context().session().is_demo()) {
        emit unlocked();
        return;
    }
    const database::Session& session = context().session();
    // An administrator may have changed it since the sign-in.
    std::string login = session.login();
    context().guarded([&] { login = database::People(context().store()).login_now(session); });
    unlock_->setEnabled(false);
    BackgroundJob* job = sign_in_job(
        this, context().store().path(), login, plain(password_->text()), session.role(),
        [this](const database::Session&) { emit unlocked(); },
        [this](const QString& why) {
            announce_problem(problem_, why);
            password_->clear();
            password_->setFocus();
        });
    checking_ = job;
    connect(job, &BackgroundJob::ended, this, [this] { unlock_->setEnabled(true); });
    job_->watch(job, tr("Unlocking …"));
}

}  // namespace fulcrum::ui

#include "moc_lock_page.cpp"
