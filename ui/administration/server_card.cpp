// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/server_card.h"

#include <QLineEdit>
#include <QPointer>
#include <cmath>
#include <memory>

#include "database/records/curricula.h"
#include "database/sync/enrolment.h"
#include "ui/language/error_text.h"
#include "ui/language/language.h"
#include "ui/page/background_job.h"
#include "ui/page/mail_room.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

QLabel* selectable_label(const char* name) {
    QLabel* label = make_label({});
    label->setObjectName(QLatin1String(name));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

/// Opens the store for a worker.
database::Store store_for_exchange(const std::string& path) {
    database::StoreOptions options;
    options.close_interrupted = false;
    return database::Store::open(path, options);
}

}  // namespace

ServerCard::ServerCard(Context& context)
    : context_(context),
      address_(new QLineEdit),
      token_(new QLineEdit),
      place_(selectable_label("server_place")),
      scope_(make_label({}, "muted")),
      last_(make_label({}, "muted")),
      result_(selectable_label("server_result")) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Programme server"), "heading"));
    layout->addWidget(make_label(tr("The stations of a programme exchange people, attempts and reviews "
                                    "through its server. This station "
                                    "works without it, too, and sends what is new at the next exchange."),
                                 "muted"));
    layout->addWidget(link_ = make_link());
    layout->addWidget(form_ = make_form());
    result_->hide();
    layout->addWidget(result_);
}

QWidget* ServerCard::make_link() {
    auto* holder = new QWidget;
    auto* layout = new QVBoxLayout(holder);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QLabel* label : {place_, scope_, last_}) layout->addWidget(label);
    auto* buttons = new QWidget;
    auto* row = new FlowRow(buttons);
    exchange_ = make_button(tr("Exchange now"), "exchange_now", "primary");
    again_ = make_button(tr("Enrol again …"), "enrol_again");
    again_->setToolTip(
        tr("With another token of the server's owner: for other cohorts, or where the "
           "password of the station's account was lost."));
    row->add(exchange_);
    row->add(again_);
    connect(exchange_, &QPushButton::clicked, this, &ServerCard::exchange);
    connect(again_, &QPushButton::clicked, this, [this] {
        form_->show();
        again_->hide();
        token_->setFocus();
    });
    layout->addWidget(buttons);
    return holder;
}

QWidget* ServerCard::make_form() {
    auto* holder = new QWidget;
    auto* layout = new QVBoxLayout(holder);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(make_label(tr("The server's owner makes a token with \"fulcrum server enrol\" and "
                                    "tells you its address. A token "
                                    "is good for one station, once, and for some days."),
                                 "muted"));
    address_->setObjectName(QStringLiteral("server_address"));
    address_->setPlaceholderText(QStringLiteral("postgresql://HOST/fulcrum"));
    address_->setAccessibleName(tr("Address of the server"));
    token_->setObjectName(QStringLiteral("server_token"));
    token_->setPlaceholderText(tr("Token, such as 0A1B2-…"));
    token_->setAccessibleName(tr("Token"));
    enrol_ = make_button(tr("Enrol this station"), "enrol_station", "primary");
    for (QLineEdit* field : {address_, token_}) {
        layout->addWidget(field);
        mark_begun(field, tr("an enrolment of this station that is not complete yet"));
        connect(field, &QLineEdit::textChanged, this, &ServerCard::update_buttons);
    }
    connect(enrol_, &QPushButton::clicked, this, &ServerCard::enrol);
    layout->addWidget(enrol_, 0, Qt::AlignLeft);
    return holder;
}

void ServerCard::update_buttons() {
    const bool filled = !address_->text().trimmed().isEmpty() && !token_->text().trimmed().isEmpty();
    enrol_->setEnabled(!busy_ && filled);
    exchange_->setEnabled(!busy_);
}

void ServerCard::set_busy(bool busy) {
    busy_ = busy;
    update_buttons();
}

void ServerCard::show_link() {
    const bool allowed = context_.allowed(database::Operation::backup) && !context_.store().is_demo();
    setVisible(allowed);
    if (!allowed) return;
    std::optional<database::LinkedServer> linked;
    try {
        linked = database::linked_server(context_.store(), context_.session());
    } catch (const std::exception& error) {
        context_.complain(error_text(error));
    }
    linked_ = linked.has_value();
    link_->setVisible(linked_);
    form_->setVisible(!linked_);
    again_->setVisible(linked_);
    token_->clear();
    update_buttons();
    if (!linked) return;
    address_->setModified(false);  // it has been used
    place_->setText(tr("Enrolled at %1").arg(text(linked->address)));
    QStringList cohorts;
    for (const std::string& name : linked->cohorts) cohorts << text(name);
    scope_->setText(cohorts.isEmpty() ? tr("Gets everybody of the programme.")
                                      : tr("Gets the people of: %1").arg(cohorts.join(QStringLiteral(", "))));
    last_->setText(linked->last_sync == 0
                       ? tr("Nothing was exchanged yet.")
                       : tr("Last exchange with something new: %1").arg(date_text(linked->last_sync)));
}

void ServerCard::run(const QString& line,
                     std::function<database::SyncResult(const database::SyncOptions&)> work) {
    if (busy_) return;
    result_->hide();
    auto result = std::make_shared<database::SyncResult>();
    BackgroundJob* job = BackgroundJob::run(
        this,
        [result, line, work = std::move(work)](const Progress& progress) {
            double so_far = 0;
            database::SyncOptions options;
            options.progress = [&](double done, const std::string&) { so_far = done; };
            options.stop = [&] { return !progress(so_far, plain(line)); };
            *result = work(options);
        },
        [this, result] {
            // What came is in force from now on, not from the next start.
            if (result->complete) context_.guarded([&] { context_.services().look_for_curriculum(); });
            emit ended();
            show_link();
            show_result(*result);
        },
        [this](const QString& why) {
            emit ended();
            show_link();
            context_.complain(why);
        });
    connect(job, &BackgroundJob::ended, this, [this, job] {
        // Done and failed say it themselves; a station that is not enrolled has no next exchange.
        if (!job->cancelled() || !linked_) return;
        database::SyncResult stopped;
        stopped.complete = false;
        show_result(stopped);
    });
    emit started(job, line);
}

void ServerCard::enrol() {
    if (!enrol_->isEnabled()) return;
    run(tr("Enrolling, then exchanging …"),
        [card = QPointer<ServerCard>(this), ui_thread = MailRoom::of_application(),
         session = context_.session(), path = context_.store().path(), to = plain(address_->text().trimmed()),
         token = plain(token_->text().trimmed())](const database::SyncOptions& options) {
            const database::Store store = store_for_exchange(path);
            const database::Enrolment enrolment =
                database::enrol_station(store, session, database::ServerAddress::parse(to), token);
            // Shown before the exchange, and also after a cancel: what has begun to enrol is enrolled.
            ui_thread->post([card] {
                if (card) card->show_link();
            });
            return database::sync_with_server(store, session, enrolment.address, options);
        });
}

void ServerCard::exchange() {
    run(tr("Exchanging …"),
        [session = context_.session(), path = context_.store().path()](const database::SyncOptions& options) {
            const database::Store store = store_for_exchange(path);
            return database::sync_with_server(store, session, database::server_of(store), options);
        });
}

void ServerCard::show_result(const database::SyncResult& result) {
    std::int64_t sent = 0, received = 0;
    for (const database::SyncCount& one : result.counts) {
        sent += one.pushed;
        received += one.pulled;
    }
    QStringList lines;
    lines << (!result.complete ? tr("Stopped before the end. Nothing is lost; the next exchange "
                                    "completes it.")
              : sent + received == 0
                  ? tr("✓ Station and server agree already.")
                  : tr("✓ Station and server agree: %1 records sent, %2 received.").arg(sent).arg(received));
    if (result.erased > 0)
        lines << tr("%n person(s) were erased here, as on the server.", nullptr,
                    static_cast<int>(result.erased));
    if (std::abs(result.clock_ahead_s) > database::clock_tolerance_s)
        lines << tr("The clocks of station and server differ by %1 s: set this one.")
                     .arg(std::llround(std::abs(result.clock_ahead_s)));
    context_.guarded([&] {
        const Curriculum& newest = context_.services().curriculum();
        for (const database::MissingCurriculum& one : database::Curricula(context_.store()).check(newest))
            lines << QStringLiteral("▲ ") + sentence_text(one.words());
    });
    for (const Sentence& conflict : result.conflicts) lines << QStringLiteral("▲ ") + sentence_text(conflict);
    result_->setText(lines.join(QLatin1Char('\n')));
    result_->show();
    announce(result_, result_->text());
}

}  // namespace fulcrum::ui

#include "moc_server_card.cpp"
