// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/station_page.h"

#include <QDate>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <algorithm>

#include "database/records/curricula.h"
#include "database/store/signing_keys.h"
#include "ui/administration/server_card.h"
#include "ui/administration/stations_card.h"
#include "ui/language/error_text.h"
#include "ui/language/language.h"
#include "ui/page/background_job.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

StationPage::StationPage(Context& context) : Page(context, "station_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addWidget(make_label(tr("Station"), "title"));
    place_ = make_label({}, "muted");
    place_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    layout->addWidget(place_);
    curricula_ = make_label({});
    curricula_->setObjectName(QStringLiteral("curricula_not_here"));
    layout->addWidget(curricula_);
    bar_ = new JobBar;
    connect(bar_, &JobBar::cancelled, this, &StationPage::ended);
    layout->addWidget(bar_);
    layout->addWidget(build_backup());
    layout->addWidget(build_check());
    layout->addWidget(build_key());
    server_ = new ServerCard(context);
    connect(server_, &ServerCard::started, this, &StationPage::start);
    connect(server_, &ServerCard::ended, this, &StationPage::ended);
    layout->addWidget(server_);
    stations_ = new StationsCard(context);
    layout->addWidget(stations_);
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000));
}

QFrame* StationPage::build_backup() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Back up"), "heading"));
    card_layout(card)->addWidget(
        make_label(tr("Copies the whole store into one file; you can continue to work. Keep the file on "
                      "another disk. It is as confidential as the store itself."),
                   "muted"));
    backup_ = make_button(tr("Back up …"), "back_up", "primary");
    connect(backup_, &QPushButton::clicked, this, &StationPage::ask_backup);
    card_layout(card)->addWidget(backup_, 0, Qt::AlignLeft);
    card_layout(card)->addWidget(
        make_label(tr("A backup can take the place of the store. You are signed out for that; the backup's "
                      "administrator signs in, and what is in the store now is kept under another name."),
                   "muted"));
    restore_ = make_button(tr("Restore a backup …"), "restore_a_backup");
    restore_sure_ = make_button(tr("Sign out and choose a backup"), "restore_a_backup_sure", "primary");
    ask_twice(restore_, restore_sure_);
    connect(restore_sure_, &QPushButton::clicked, this, [this] { emit this->context().restore_wanted(); });
    auto* row = new FlowRow;
    row->add(restore_);
    row->add(restore_sure_);
    card_layout(card)->addLayout(row);
    return card;
}

QFrame* StationPage::build_check() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Check for damage"), "heading"));
    card_layout(card)->addWidget(
        make_label(tr("Reads the whole store (file pages, references, audit log, recordings and scores) and "
                      "lists any damage. Then it simulates a few attempts again, drawn by chance, and "
                      "compares them with their records, for at most 20 seconds. Nothing is changed."),
                   "muted"));
    check_ = make_button(tr("Check the store"), "check_store", "primary");
    connect(check_, &QPushButton::clicked, this, &StationPage::check);
    card_layout(card)->addWidget(check_, 0, Qt::AlignLeft);
    verdict_ = make_label({});
    verdict_->setObjectName(QStringLiteral("check_verdict"));
    verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    verdict_->hide();
    card_layout(card)->addWidget(verdict_);
    items_ =
        make_table({tr("Checked"), tr("Result"), tr("Number checked"), tr("What is wrong")}, "check_items");
    items_->setAccessibleName(tr("Check for damage"));
    items_->hide();
    card_layout(card)->addWidget(items_);
    return card;
}

QFrame* StationPage::build_key() {
    key_card_ = make_card(8);
    card_layout(key_card_)->addWidget(make_label(tr("Signing key"), "heading"));
    card_layout(key_card_)->addWidget(
        make_label(tr("The station signs its audit log with this key, and every report names the key. Change "
                      "it if the key's file may have been copied, or when a person with access to the file "
                      "leaves. The old key signs the change, and everything it signed before stays valid."),
                   "muted"));
    keys_ = make_table({tr("Key"), tr("From"), tr("Until"), tr("Origin")}, "station_keys");
    keys_->setAccessibleName(tr("Signing key"));
    keys_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    card_layout(key_card_)->addWidget(keys_);
    key_reason_ = new QLineEdit;
    key_reason_->setObjectName(QStringLiteral("key_reason"));
    key_reason_->setPlaceholderText(tr("Reason for the change"));
    key_reason_->setAccessibleName(tr("Reason for the change"));
    mark_begun(key_reason_, tr("a reason for another key"));
    change_key_ = make_button(tr("Change the key"), "change_key");
    connect(key_reason_, &QLineEdit::textChanged, this,
            [this] { change_key_->setEnabled(!key_reason_->text().trimmed().isEmpty()); });
    connect(change_key_, &QPushButton::clicked, this, &StationPage::change_key);
    card_layout(key_card_)->addWidget(key_reason_);
    card_layout(key_card_)->addWidget(change_key_, 0, Qt::AlignLeft);
    return key_card_;
}

void StationPage::show_keys() {
    key_card_->setVisible(context().allowed(database::Operation::rotate_key));
    key_reason_->clear();
    change_key_->setEnabled(false);
    keys_->setRowCount(0);
    if (!key_card_->isVisibleTo(this)) return;
    const database::Store& store = context().store();
    const std::vector<database::SigningKey> keys =
        database::signing_keys(store.connection(), store.station_id());
    for (auto key = keys.rbegin(); key != keys.rend(); ++key) {  // the newest first
        const bool in_use = key == keys.rbegin(), first = key + 1 == keys.rend();
        const int row = keys_->rowCount();
        keys_->insertRow(row);
        keys_->setItem(row, 0, make_cell(text(key->fingerprint.substr(0, 16))));
        keys_->item(row, 0)->setToolTip(text(key->fingerprint));
        keys_->setItem(row, 1, make_cell(date_text(key->from)));
        keys_->setItem(row, 2, make_cell(in_use ? tr("in use") : date_text(key->until)));
        keys_->setItem(row, 3,
                       make_cell(first            ? tr("first key")
                                 : key->announced ? tr("✓ signed by the previous key")
                                                  : tr("✕ not signed by the previous key")));
    }
    fit_columns(keys_);
    constexpr int most_rows = 6;
    fit_height(keys_, most_rows);
}

void StationPage::change_key() {
    try {
        const database::SigningKey key = database::rotate_station_key(context().store(), context().session(),
                                                                      plain(key_reason_->text().trimmed()));
        key_reason_->setFocus();  // the button is disabled, and the next one does something else
        show_keys();
        context().say(tr("The station signs with the key %1 from now on. Keep a copy of its file.")
                          .arg(text(key.fingerprint.substr(0, 16))));
    } catch (const std::exception& error) {
        context().complain(error_text(error));
    }
}

void StationPage::show_curricula() {
    QStringList lines;
    context().guarded([&] {
        const Curriculum& newest = context().services().curriculum();
        for (const database::MissingCurriculum& one : database::Curricula(context().store()).check(newest))
            lines << QStringLiteral("▲ ") + sentence_text(one.words());
    });
    if (!lines.isEmpty()) lines << sentence_text(database::not_here_hint());
    curricula_->setText(lines.join(QLatin1Char('\n')));
    curricula_->setVisible(!lines.isEmpty());
}

void StationPage::enter() {
    show_keys();
    show_curricula();
    server_->show_link();
    stations_->look();
    place_->setText(tr("The store: %1").arg(text(context().store().path())));
    backup_->setVisible(context().allowed(database::Operation::backup));
    restore_->setVisible(backup_->isVisible());
    restore_sure_->hide();
    check_->setVisible(context().allowed(database::Operation::check_store));
    (backup_->isVisible() ? backup_ : check_)->setFocus();
}

void StationPage::leave() {
    if (job_ != nullptr) job_->cancel();
    free_buttons();
    stations_->stop();
}

void StationPage::start(BackgroundJob* job, const QString& line) {
    job_ = job;
    bar_->watch(job, line);
    check_->setEnabled(false);
    backup_->setEnabled(false);
    restore_->setEnabled(false);
    restore_sure_->hide();
    server_->set_busy(true);
}

void StationPage::free_buttons() {
    job_ = nullptr;
    check_->setEnabled(true);
    backup_->setEnabled(true);
    restore_->setEnabled(true);
    server_->set_busy(false);
}

void StationPage::ended() {
    free_buttons();
    if (!isVisible()) return;
    stations_->look();
    show_curricula();
}

void StationPage::check() {
    if (job_ != nullptr) return;
    verdict_->hide();
    items_->hide();
    auto report = std::make_shared<database::CheckReport>();
    start(BackgroundJob::run(
              this,
              [report, session = context().session(), services = &context().services()](
                  const Progress& progress) { *report = services->check_store(session, progress); },
              [this, report] {
                  ended();
                  show_report(*report);
              },
              [this](const QString& why) {
                  ended();
                  context().complain(why);
              }),
          tr("Checking the store …"));
}

QString StationPage::verdict_of(const database::CheckReport& report) {
    const auto simulated = std::find_if(
        report.items.begin(), report.items.end(),
        [](const database::CheckItem& item) { return item.id == database::CheckId::simulation; });
    if (simulated == report.items.end()) {
        if (report.ok) return tr("✓ The store is intact.");
        return tr(
            "✕ The store is damaged. Restore the newest backup: what is in the store now is kept under "
            "another name.");
    }
    if (report.ok)
        return tr("✓ The store is intact.") + QLatin1Char(' ') +
               (simulated->count == 0 ? tr("No attempt was simulated again: the line on simulation says why.")
                                      : tr("%n attempts were simulated again; all agree with their records.",
                                           nullptr, static_cast<int>(simulated->count)));
    QStringList problems;
    for (const Sentence& problem : simulated->problems) problems << sentence_text(problem);
    return tr("✕ The store can be read, but not every attempt that was simulated again agrees with its "
              "record "
              "(%1 simulated): %2. Such a record was replaced and signed with the station's key, or this "
              "computer has a hardware fault. Compare the attempt with an older backup, and change the key.")
        .arg(simulated->count)
        .arg(problems.join(QStringLiteral("; ")));
}

void StationPage::show_report(const database::CheckReport& report) {
    verdict_->setText(verdict_of(report));
    set_tint(verdict_, report.ok ? Tint::good : Tint::bad);
    verdict_->show();
    announce(verdict_, verdict_->text());
    items_->setRowCount(0);
    for (const database::CheckItem& item : report.items) {
        const int row = items_->rowCount();
        items_->insertRow(row);
        QStringList problems;
        for (const Sentence& problem : item.problems) problems << sentence_text(problem);
        for (const Sentence& note : item.notes) problems << sentence_text(note);
        items_->setItem(row, 0, make_cell(sentence_text(item.name.c_str())));
        items_->setItem(row, 1, make_cell(item.ok ? tr("✓ intact") : tr("✕ damaged")));
        items_->setItem(row, 2, make_cell(QString::number(item.count), Qt::AlignRight | Qt::AlignVCenter));
        items_->setItem(row, 3, make_cell(problems.join(QStringLiteral("; "))));
        items_->item(row, 3)->setToolTip(problems.join(QLatin1Char('\n')));
    }
    fit_columns(items_);
    fit_height(items_, items_->rowCount());
    items_->show();
}

void StationPage::ask_backup() {
    const QString name = QFileInfo(text(context().store().path())).completeBaseName() +
                         QDate::currentDate().toString(QStringLiteral("-yyyy-MM-dd")) + QStringLiteral(".db");
    const QString path = QFileDialog::getSaveFileName(this, tr("Back up to"), name, tr("Store (*.db)"),
                                                      nullptr, QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty()) back_up_to(path);
}

void StationPage::back_up_to(const QString& path) {
    if (job_ != nullptr) return;
    auto written = std::make_shared<bool>(false);
    start(BackgroundJob::run(
              this,
              [written, session = context().session(), to = plain(path),
               store_path = context().store().path()](const Progress& progress) {
                  database::StoreOptions options;
                  options.close_interrupted = false;
                  *written = database::Store::open(store_path, options).backup(session, to, progress);
              },
              [this, written, path] {
                  ended();
                  if (*written) context().say(tr("Backed up to %1").arg(path));
              },
              [this](const QString& why) {
                  ended();
                  context().complain(why);
              }),
          tr("Backing up …"));
}

}  // namespace fulcrum::ui

#include "moc_station_page.cpp"
