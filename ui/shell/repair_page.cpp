// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/repair_page.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QLocale>
#include <QTableWidget>
#include <algorithm>

#include "database/records/people.h"
#include "database/store/store_restore.h"
#include "ui/language/error_text.h"
#include "ui/page/background_job.h"
#include "ui/page/fields.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

RepairPage::RepairPage(Context& context) : Page(context, "repair_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addWidget(title_ = make_label({}, "title"));
    layout->addWidget(problem_card_ = build_problem());
    layout->addWidget(restore_card_ = build_restore());
    layout->addWidget(other_card_ = build_other_ways());
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000, PagePlace::centred));
}

QFrame* RepairPage::build_problem() {
    QFrame* card = make_card(8);
    problem_ = make_label({}, "bad");
    problem_->setObjectName(QStringLiteral("store_problem"));
    card_layout(card)->addWidget(problem_);
    place_ = make_label({}, "muted");
    place_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    card_layout(card)->addWidget(place_);
    again_ = make_button({}, "try_again");
    connect(again_, &QPushButton::clicked, this, &RepairPage::try_again);
    card_layout(card)->addWidget(again_, 0, Qt::AlignLeft);
    return card;
}

QFrame* RepairPage::build_restore() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Restore a backup"), "heading"));
    card_layout(card)->addWidget(
        make_label(tr("The backup is read from end to end before it takes the store's place. What is there "
                      "now is kept under another name. What was done after the backup is not in it."),
                   "muted"));
    search_bar_ = new JobBar;
    connect(search_bar_, &JobBar::cancelled, this, [this] { job_ = nullptr; });
    card_layout(card)->addWidget(search_bar_);
    searched_ = make_label({}, "muted");
    searched_->setObjectName(QStringLiteral("backups_searched"));
    card_layout(card)->addWidget(searched_);
    table_ = make_table({tr("Last entry"), tr("Programme"), tr("Holds"), tr("Size"), tr("State"), tr("File")},
                        "found_backups");
    table_->setAccessibleName(tr("Restore a backup"));
    table_->setMinimumHeight(170);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &RepairPage::update_buttons);
    card_layout(card)->addWidget(table_);
    folder_ = make_button(tr("Look in another folder …"), "look_in_folder");
    connect(folder_, &QPushButton::clicked, this, [this] {
        const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder with backups"));
        if (!folder.isEmpty()) look_in(folder);
    });
    card_layout(card)->addWidget(folder_, 0, Qt::AlignLeft);
    auto* form = new QFormLayout;
    form->setSpacing(10);
    login_ = make_field(form, tr("Administrator of the backup"), "restore_login", false);
    password_ = make_field(form, tr("Password"), "restore_password", true);
    card_layout(card)->addLayout(form);
    refused_ = make_label({}, "bad");
    refused_->setObjectName(QStringLiteral("restore_problem"));
    refused_->hide();
    card_layout(card)->addWidget(refused_);
    restore_bar_ = new JobBar;
    card_layout(card)->addWidget(restore_bar_);
    restore_ = make_button(tr("Restore this backup"), "restore_backup", "primary");
    for (QLineEdit* edit : {login_, password_}) {
        connect(edit, &QLineEdit::textChanged, this, &RepairPage::update_buttons);
    }
    enter_leads_on({login_, password_}, restore_);
    connect(restore_, &QPushButton::clicked, this, &RepairPage::restore);
    card_layout(card)->addWidget(restore_, 0, Qt::AlignLeft);
    return card;
}

QFrame* RepairPage::build_other_ways() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Other ways"), "heading"));
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    aside_ = make_button(tr("Keep the file under another name"), "put_aside");
    connect(aside_, &QPushButton::clicked, this, [this] {
        aside_confirm_->show();
        // Not on the one that does it: a key pressed once too often takes it back.
        aside_confirm_->findChild<QPushButton*>(QStringLiteral("put_aside_cancel"))->setFocus();
        announce(aside_confirm_, aside_confirm_->findChild<QLabel*>()->text());
    });
    other_ = make_button(tr("Open another programme …"), "open_other");
    connect(other_, &QPushButton::clicked, this, [this] {
        const QString file =
            QFileDialog::getOpenFileName(this, tr("Store of another programme"), {}, tr("Store (*.db)"));
        if (!file.isEmpty()) open_other(file);
    });
    look_around_ = make_button(tr("Look around"), "repair_look_around");
    connect(look_around_, &QPushButton::clicked, this, &RepairPage::look_around_wanted);
    quit_ = make_button(tr("Quit"), "quit");
    connect(quit_, &QPushButton::clicked, this, [this] { window()->close(); });
    for (QPushButton* button : {aside_, other_, look_around_, quit_}) row->add(button);
    card_layout(card)->addWidget(holder);
    aside_confirm_ = make_card(8);
    card_layout(aside_confirm_)
        ->addWidget(
            make_label(tr("The file stays in its folder, with \".damaged\" and the time behind its name. "
                          "Fulcrum then begins with an empty store; a backup can be restored later.")));
    auto* sure = new QWidget;
    auto* sure_row = new FlowRow(sure);
    QPushButton* confirm = make_button(tr("Give it another name"), "put_aside_confirm", "primary");
    QPushButton* cancel = make_button(tr("Cancel"), "put_aside_cancel");
    connect(confirm, &QPushButton::clicked, this, &RepairPage::put_aside);
    connect(cancel, &QPushButton::clicked, this, [this] {
        aside_->setFocus();
        aside_confirm_->hide();
    });
    sure_row->add(confirm);
    sure_row->add(cancel);
    card_layout(aside_confirm_)->addWidget(sure);
    card_layout(card)->addWidget(aside_confirm_);
    return card;
}

std::string RepairPage::store_path() const {
    return context().services().store_path(false);
}

void RepairPage::show_trouble(const QString& problem, const QString& hint, bool damaged) {
    trouble_ = true;
    damaged_ = damaged;
    // A long path breaks after its folders. What is copied is the place below, which has no such breaks.
    QString words = hint.isEmpty() ? problem : problem + QLatin1Char('\n') + hint;
    problem_->setText(words.replace(QLatin1Char('/'), QStringLiteral("/\u200b")));
    title_->setText(damaged ? tr("The store is damaged") : tr("The store cannot be opened"));
    again_->setText(tr("Try again"));
}

void RepairPage::show_restore() {
    trouble_ = damaged_ = false;
    title_->setText(tr("Restore a backup"));
    again_->setText(tr("Back"));
}

void RepairPage::enter() {
    problem_->setVisible(trouble_);
    place_->setText(tr("The store: %1").arg(text(store_path())));
    restore_card_->setVisible(!trouble_ || damaged_);
    other_card_->setVisible(trouble_);
    aside_->setVisible(damaged_);
    aside_confirm_->hide();
    refused_->hide();
    password_->clear();
    backups_.clear();
    folders_.clear();
    show_backups();
    set_busy(false);
    if (restore_card_->isVisibleTo(this)) {
        folders_ = database::backup_folders(store_path());
        look();
        login_->setFocus();
    } else {
        again_->setFocus();
    }
}

void RepairPage::leave() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
    password_->clear();
}

void RepairPage::look_in(const QString& folder) {
    if (busy_) return;
    if (std::find(folders_.begin(), folders_.end(), plain(folder)) == folders_.end())
        folders_.push_back(plain(folder));
    look();
}

void RepairPage::look() {
    if (job_ != nullptr) job_->cancel();
    searched_->hide();
    auto found = std::make_shared<std::vector<database::FoundBackup>>();
    job_ = BackgroundJob::run(
        this,
        [found, path = store_path(), folders = folders_](const Progress& progress) {
            *found = database::find_backups(path, folders, progress);
        },
        [this, found] {
            job_ = nullptr;
            backups_ = std::move(*found);
            show_backups();
        },
        [this](const QString& why) {
            job_ = nullptr;
            context().complain(why);
        });
    search_bar_->watch(job_, tr("Looking for backups …"));
    update_buttons();
}

void RepairPage::show_backups() {
    QStringList folders;
    for (const std::string& folder : folders_) folders << text(folder);
    searched_->setText(backups_.empty()
                           ? tr("No backup was found in %1.").arg(folders.join(QStringLiteral(", ")))
                           : tr("Found in %1.").arg(folders.join(QStringLiteral(", "))));
    searched_->setVisible(!folders.isEmpty());
    const QSignalBlocker quiet(table_);
    table_->setRowCount(0);
    table_->clearSelection();
    int first_sound = -1;
    for (const database::FoundBackup& one : backups_) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        const bool sound = one.problems.empty();
        if (sound && first_sound < 0) first_sound = row;
        QStringList problems;
        for (const Sentence& problem : one.problems) problems << sentence_text(problem);
        table_->setItem(row, 0, make_cell(local_time(one.newest > 0 ? one.newest : one.written)));
        table_->setItem(row, 1, make_cell(text(one.programme)));
        table_->setItem(
            row, 2,
            make_cell(tr("%n people", nullptr, static_cast<int>(one.people)) + QStringLiteral(", ") +
                      tr("%n attempts", nullptr, static_cast<int>(one.attempts))));
        table_->setItem(
            row, 3, make_cell(QLocale().formattedDataSize(one.bytes, 1, QLocale::DataSizeTraditionalFormat)));
        table_->setItem(row, 4, make_cell(sound ? tr("✓ no damage found") : tr("✕ cannot be used")));
        set_tint(table_->item(row, 4), sound ? Tint::good : Tint::bad);
        table_->item(row, 4)->setToolTip(problems.join(QLatin1Char('\n')));
        const QString path = text(one.path);
        table_->setItem(row, 5, make_cell(path.mid(path.lastIndexOf(QLatin1Char('/')) + 1)));
        table_->item(row, 5)->setToolTip(path);
    }
    fit_columns(table_, {0});
    table_->setVisible(!backups_.empty());
    if (first_sound >= 0) table_->selectRow(first_sound);
    update_buttons();
}

const database::FoundBackup* RepairPage::selected() const {
    const auto row = static_cast<std::size_t>(table_->currentRow());
    if (table_->selectedItems().isEmpty() || row >= backups_.size()) return nullptr;
    return &backups_[row];
}

void RepairPage::update_buttons() {
    const database::FoundBackup* backup = selected();
    restore_->setEnabled(!busy_ && backup != nullptr && backup->problems.empty() &&
                         !login_->text().trimmed().isEmpty() && !password_->text().isEmpty());
}

void RepairPage::set_busy(bool busy) {
    busy_ = busy;
    for (QWidget* one : std::initializer_list<QWidget*>{again_, folder_, aside_, other_, look_around_, quit_,
                                                        table_, login_, password_})
        one->setEnabled(!busy);
    update_buttons();
}

void RepairPage::restore() {
    if (!restore_->isEnabled()) return;
    if (job_ != nullptr) job_->cancel();  // still looking
    refused_->hide();
    set_busy(true);
    auto done = std::make_shared<database::Replaced>();
    const std::string login = plain(login_->text().trimmed()), password = plain(password_->text());
    const auto ended = [this] {
        job_ = nullptr;
        set_busy(false);
    };
    job_ = BackgroundJob::run(
        this,
        [=, from = selected()->path, path = store_path()](const Progress& progress) {
            *done = database::restore_store(
                from, path,
                [&](const database::Store& copy) {
                    return database::People(copy).sign_in(login, password, database::Role::administrator);
                },
                {}, progress, database::ReplacedFile::any);
        },
        [this, done, ended] {
            ended();
            if (done->stopped) return;
            emit restored(done->kept.empty()
                              ? tr("The backup was restored.")
                              : tr("The backup was restored. What was there before is kept in %1")
                                    .arg(text(done->kept)));
        },
        [this, ended](const QString& why) {
            ended();
            password_->clear();
            refused_->show();
            announce_problem(refused_, capital(why));
            password_->setFocus();
        });
    restore_bar_->watch(job_, tr("Restoring the backup …"));
    connect(job_, &BackgroundJob::ended, this, ended);
}

void RepairPage::put_aside() {
    try {
        const std::string kept = database::put_aside(store_path());
        context().say(tr("The file is kept in %1").arg(text(kept)));
        emit try_again();
    } catch (const std::exception& error) {
        aside_confirm_->hide();
        context().complain(error_text(error));
    }
}

void RepairPage::open_other(const QString& file) {
    context().services().choose_store(plain(file));
    emit try_again();
}

}  // namespace fulcrum::ui

#include "moc_repair_page.cpp"
