// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/join_form.h"

#include <QFormLayout>
#include <QLineEdit>

#include "database/sync/enrolment.h"
#include "database/sync/sync.h"
#include "ui/page/background_job.h"
#include "ui/page/fields.h"
#include "ui/style/announce.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

JoinForm::JoinForm(Context& context) : context_(context) {
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(14);
    layout->addSpacing(30);
    layout->addWidget(make_label(tr("Join a programme"), "title"));
    QFrame* card = make_card(10);
    card_layout(card)->addWidget(make_label(
        tr("The owner of the programme server makes a token for this station with \"fulcrum server "
           "enrol\" and tells you the server's address. People sign in here with the passwords that "
           "they have at the other stations."),
        "muted"));
    auto* form = new QFormLayout;
    form->setSpacing(10);
    address_ = make_field(form, tr("Server"), "join_address", false);
    address_->setPlaceholderText(QStringLiteral("postgresql://HOST/fulcrum"));
    token_ = make_field(form, tr("Token"), "join_token", false);
    card_layout(card)->addLayout(form);
    problem_ = make_label({}, "bad");
    problem_->setObjectName(QStringLiteral("join_problem"));
    card_layout(card)->addWidget(problem_);
    bar_ = new JobBar;
    card_layout(card)->addWidget(bar_);
    auto* buttons = new QHBoxLayout;
    QPushButton* back_button = make_button(tr("Back"), "join_back");
    connect(back_button, &QPushButton::clicked, this, &JoinForm::back);
    join_ = make_button(tr("Join"), "join_confirm", "primary");
    connect(join_, &QPushButton::clicked, this, &JoinForm::join);
    for (QLineEdit* edit : {address_, token_}) {
        mark_begun(edit, tr("a programme that is not joined yet"));
        connect(edit, &QLineEdit::textChanged, this, &JoinForm::update_button);
    }
    enter_leads_on({address_, token_}, join_);
    buttons->addWidget(back_button);
    buttons->addStretch();
    buttons->addWidget(join_);
    card_layout(card)->addLayout(buttons);
    layout->addWidget(card);
    layout->addStretch();
    update_button();
}

void JoinForm::begin() {
    problem_->clear();
    token_->clear();
    address_->setFocus();
}

void JoinForm::update_button() {
    join_->setEnabled(!busy_ && !address_->text().trimmed().isEmpty() && !token_->text().trimmed().isEmpty());
}

void JoinForm::join() {
    if (!join_->isEnabled()) return;
    problem_->clear();
    std::string path;
    if (!context_.guarded([&] {
            context_.services().open_store(false);
            path = context_.store().path();
        })) {
        return;
    }
    busy_ = true;
    update_button();
    const std::string to = plain(address_->text().trimmed()), token = plain(token_->text().trimmed()),
                      line = plain(tr("Fetching the programme …"));
    auto complete = std::make_shared<bool>(false);
    BackgroundJob* job = BackgroundJob::run(
        this,
        [=](const Progress& progress) {
            const database::Store store = database::Store::open(path);
            const database::Session station = store.station_session();
            const auto server = database::ServerAddress::parse(to);
            // Enrolled before, and stopped before its people came: the token has done its work.
            const database::ServerAddress own =
                database::is_enrolled_at(store, server)
                    ? database::server_of(store)
                    : database::enrol_station(store, station, server, token).address;
            double so_far = 0;
            database::SyncOptions options;
            options.progress = [&](double done, const std::string&) { so_far = done; };
            options.stop = [&] { return !progress(so_far, line); };
            *complete = database::sync_with_server(store, station, own, options).complete;
        },
        [this, complete] {
            if (*complete) emit joined();
        },
        [this](const QString& why) { announce_problem(problem_, capital(why)); });
    connect(job, &BackgroundJob::ended, this, [this] {
        busy_ = false;
        update_button();
    });
    bar_->watch(job, text(line));
}

}  // namespace fulcrum::ui

#include "moc_join_form.cpp"
