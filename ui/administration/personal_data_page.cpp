// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/personal_data_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QSpinBox>
#include <QTableWidget>
#include <memory>

#include "database/sync/person_data.h"
#include "database/sync/station_erasure.h"
#include "ui/language/words.h"
#include "ui/page/background_job.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// Name of the job that erases one person.
constexpr const char* erasure_name = "erases_person";

/// A store for a worker.
database::Store open_for_worker(const std::string& path, bool read_only) {
    database::StoreOptions options;
    options.read_only = read_only;
    options.close_interrupted = false;
    return database::Store::open(path, options);
}

}  // namespace

PersonalDataPage::PersonalDataPage(Context& context) : Page(context, "personal_data_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addWidget(make_label(tr("Personal data"), "title"));
    bar_ = new JobBar;
    connect(bar_, &JobBar::cancelled, this, &PersonalDataPage::ended);
    layout->addWidget(bar_);
    closed_ = make_label(tr("The demonstration holds simulated people only."), "muted");
    layout->addWidget(closed_);
    layout->addWidget(person_card_ = build_person());
    layout->addWidget(retention_card_ = build_retention());
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000));
}

QFrame* PersonalDataPage::build_person() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("One person"), "heading"));
    card_layout(card)->addWidget(
        make_label(tr("All that this store holds about a person: look at it, write it to a folder for the "
                      "person, or erase it. The audit log says that it was done."),
                   "muted"));
    person_ = make_narrow_choice("data_person", tr("Person"), 24);
    connect(person_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PersonalDataPage::look);
    card_layout(card)->addWidget(person_, 0, Qt::AlignLeft);
    look_bar_ = new JobBar;
    look_bar_->setObjectName(QStringLiteral("data_looking"));
    connect(look_bar_, &JobBar::cancelled, this, [this] {
        look_job_ = nullptr;
        person_->setCurrentIndex(0);  // so that the same person can be chosen again
    });
    card_layout(card)->addWidget(look_bar_);
    what_ = make_label({}, "muted");
    what_->setObjectName(QStringLiteral("data_summary"));
    card_layout(card)->addWidget(what_);
    rows_ = make_table({tr("Stored"), tr("Number")}, "data_rows");
    rows_->setAccessibleName(tr("Personal data"));
    rows_->setMinimumHeight(200);
    card_layout(card)->addWidget(rows_);
    export_ = make_button(tr("Write to a folder …"), "export_all", "primary");
    connect(export_, &QPushButton::clicked, this, [this] {
        const QString folder = QFileDialog::getSaveFileName(this, tr("New folder for the data"), {}, {},
                                                            nullptr, QFileDialog::DontConfirmOverwrite);
        if (!folder.isEmpty()) export_to(folder);
    });
    card_layout(card)->addWidget(export_, 0, Qt::AlignLeft);
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("erase_reason"));
    reason_->setPlaceholderText(tr("Reason for erasing; it stays, so name nobody in it"));
    reason_->setAccessibleName(tr("Reason for erasing"));
    mark_begun(reason_, tr("a reason for erasing somebody"));
    card_layout(card)->addWidget(reason_);
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    erase_ = make_button(tr("Erase this person"), "erase_person");
    erase_sure_ = make_button(tr("Erase for good"), "erase_person_sure", "primary");
    connect(reason_, &QLineEdit::textChanged, this, &PersonalDataPage::update_buttons);
    ask_twice(erase_, erase_sure_);
    connect(erase_sure_, &QPushButton::clicked, this, &PersonalDataPage::erase);
    row->add(erase_);
    row->add(erase_sure_);
    card_layout(card)->addWidget(holder);
    return card;
}

QFrame* PersonalDataPage::build_retention() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("How long data are kept"), "heading"));
    card_layout(card)->addWidget(make_label(
        tr("Trainees whose last practice or sign-in is longer ago are listed here. Nobody is erased "
           "until you do it."),
        "muted"));
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    limited_ = new QCheckBox(tr("Keep data of trainees for"));
    limited_->setObjectName(QStringLiteral("retention_limited"));
    months_ = new QSpinBox;
    months_->setObjectName(QStringLiteral("retention_months"));
    months_->setAccessibleName(tr("Months after the last practice"));
    months_->setRange(1, database::longest_retention);
    months_->setValue(36);
    save_ = make_button(tr("Save"), "save_retention");
    connect(limited_, &QCheckBox::toggled, months_, &QWidget::setEnabled);
    connect(save_, &QPushButton::clicked, this, &PersonalDataPage::save_retention);
    row->add(limited_);
    row->add(months_);
    row->add(make_label(tr("months after the last practice")));
    row->add(save_);
    card_layout(card)->addWidget(holder);
    due_text_ = make_label({});
    due_text_->setObjectName(QStringLiteral("due_summary"));
    card_layout(card)->addWidget(due_text_);
    due_table_ = make_table({tr("Name"), tr("Login"), tr("Last practice"), tr("Attempts")}, "due_people");
    due_table_->setAccessibleName(tr("How long data are kept"));
    due_table_->setMinimumHeight(160);
    card_layout(card)->addWidget(due_table_);
    auto* buttons = new QWidget;
    auto* buttons_row = new FlowRow(buttons);
    erase_due_ = make_button(tr("Erase all listed"), "erase_due");
    erase_due_sure_ = make_button({}, "erase_due_sure", "primary");
    connect(erase_due_, &QPushButton::clicked, this, [this] {
        erase_due_sure_->setText(tr("Erase %n people for good", nullptr, static_cast<int>(due_.size())));
    });
    ask_twice(erase_due_, erase_due_sure_);
    connect(erase_due_sure_, &QPushButton::clicked, this, &PersonalDataPage::erase_due);
    buttons_row->add(erase_due_);
    buttons_row->add(erase_due_sure_);
    card_layout(card)->addWidget(buttons);
    return card;
}

std::string PersonalDataPage::chosen() const {
    return plain(person_->currentData().toString());
}

void PersonalDataPage::enter() {
    entered_ = true;
    const bool open = context().allowed(database::Operation::export_all);
    closed_->setVisible(!open);
    person_card_->setVisible(open);
    retention_card_->setVisible(open);
    if (!open) return;
    auto* erasure =
        context().findChild<BackgroundJob*>(QLatin1String(erasure_name), Qt::FindDirectChildrenOnly);
    if (job_ == nullptr && erasure != nullptr) follow_erasure(erasure);
    fill_people();
    show_retention();
    person_->setFocus();
}

void PersonalDataPage::leave() {
    entered_ = false;
    for (BackgroundJob** job : {&look_job_, &due_job_, &job_}) {
        // An erasure that was begun is done all the same, and the window says so.
        if (*job == nullptr || (*job)->parent() != this) continue;
        (*job)->cancel();
        *job = nullptr;
    }
}

void PersonalDataPage::fill_people() {
    const std::string before = chosen();
    const QSignalBlocker quiet(person_);
    person_->clear();
    person_->addItem(tr("nobody chosen"), QString());
    context().guarded([&] {
        for (const database::Person& one : database::People(context().store()).list(context().session())) {
            if (one.kind != database::PersonKind::real || !one.merged_into.empty() ||
                one.login == "erased-" + one.id)
                continue;
            person_->addItem(text(one.display_name) + QStringLiteral(" · ") + text(one.login), text(one.id));
            if (one.id == before) person_->setCurrentIndex(person_->count() - 1);
        }
    });
    look();
}

void PersonalDataPage::look() {
    if (look_job_ != nullptr) look_job_->cancel();
    look_job_ = nullptr;
    reason_->clear();
    erase_sure_->hide();
    show_rows(nullptr);
    if (chosen().empty()) return;
    auto found = std::make_shared<database::PersonDataExport>();
    look_job_ = BackgroundJob::run(
        this,
        [found, session = context().session(), person = chosen(),
         path = context().store().path()](const Progress& progress) {
            *found = database::export_person_data(open_for_worker(path, true), session, person, {}, progress);
        },
        [this, found] {
            look_job_ = nullptr;
            show_rows(found.get());
        },
        [this](const QString& why) {
            look_job_ = nullptr;
            context().complain(why);
        });
    look_bar_->watch(look_job_, tr("Reading what is stored …"));
}

void PersonalDataPage::show_rows(const database::PersonDataExport* found) {
    const bool read = found != nullptr;
    rows_->setRowCount(0);
    if (read) {
        for (const database::ErasedRows& one : found->rows) {
            const int row = rows_->rowCount();
            rows_->insertRow(row);
            rows_->setItem(row, 0, make_cell(capital(sentence_text(database::title_of_table(one.table)))));
            rows_->setItem(row, 1, make_cell(QString::number(one.rows), Qt::AlignRight | Qt::AlignVCenter));
        }
        what_->setText(tr("Recordings in this store: %1").arg(found->traces));
    }
    fit_columns(rows_, {1});
    what_->setVisible(read);
    rows_->setVisible(read);
    reason_->setVisible(read && context().allowed(database::Operation::erase_person));
    update_buttons();
}

void PersonalDataPage::update_buttons() {
    const bool free = job_ == nullptr, somebody = rows_->rowCount() > 0;
    export_->setEnabled(free && somebody && context().allowed(database::Operation::export_all));
    erase_->setVisible(reason_->isVisibleTo(this));
    erase_->setEnabled(free && somebody && !reason_->text().trimmed().isEmpty());
    if (!erase_->isEnabled()) erase_sure_->hide();
    save_->setEnabled(free);
    erase_due_->setEnabled(free && !due_.empty());
    if (!erase_due_->isEnabled()) erase_due_sure_->hide();
}

void PersonalDataPage::start(BackgroundJob* job, const QString& line) {
    job_ = job;
    bar_->watch(job, line);
    update_buttons();
}

void PersonalDataPage::ended() {
    job_ = nullptr;
    update_buttons();
}

void PersonalDataPage::export_to(const QString& folder) {
    if (job_ != nullptr || chosen().empty()) return;
    auto done = std::make_shared<database::PersonDataExport>();
    start(BackgroundJob::run(
              this,
              [done, session = context().session(), person = chosen(), to = plain(folder),
               path = context().store().path()](const Progress& progress) {
                  *done = database::export_person_data(open_for_worker(path, false), session, person, to,
                                                       progress, words_in_use);
              },
              [this, done, folder] {
                  ended();
                  if (!done->stopped)
                      context().say(tr("Written to %1. Give it to the person, and delete it.").arg(folder));
              },
              [this](const QString& why) {
                  ended();
                  context().complain(why);
              }),
          tr("Writing the data …"));
}

// Of the context, not of the page: what is begun cannot be stopped, and whoever has left the page learns of
// it.
void PersonalDataPage::erase() {
    const std::string person = chosen();
    if (job_ != nullptr || person.empty()) return;
    reason_->setModified(false);  // it is given now
    person_->setFocus();          // not on what comes next when the button is gone
    erase_sure_->hide();
    Context* const owner = &context();
    BackgroundJob* const job = BackgroundJob::run(
        owner,
        [session = owner->session(), person, reason = plain(reason_->text().trimmed()),
         path = owner->store().path()](const Progress&) {
            database::erase_person(open_for_worker(path, false), session, person, reason, false);
        },
        [owner] {
            owner->say(
                tr("Erased. A backup from before still has the person; restoring it erases them again."));
        },
        [owner](const QString& why) { owner->complain(why); });
    connect(owner, &Context::session_changed, job, [owner, job] {
        if (!owner->signed_in()) job->cancel();
    });
    job->setObjectName(QLatin1String(erasure_name));
    connect(job, &BackgroundJob::ended, job, [job] { job->setObjectName({}); });
    follow_erasure(job);
}

void PersonalDataPage::follow_erasure(BackgroundJob* job) {
    job_ = job;
    bar_->watch(job, tr("Erasing …"), JobBar::Cancel::none);
    connect(job, &BackgroundJob::ended, this, [this, job] {
        if (job_ != job) return;
        ended();
        if (!entered_) return;
        fill_people();
        show_retention();
    });
    update_buttons();
}

void PersonalDataPage::show_retention() {
    if (due_job_ != nullptr) due_job_->cancel();
    due_job_ = nullptr;
    std::optional<int> months;
    context().guarded([&] { months = database::retention_months(context().store()); });
    kept_months_ = months;
    limited_->setChecked(months.has_value());
    months_->setEnabled(months.has_value());
    if (months) months_->setValue(*months);
    if (!months) return show_due({}, tr("No end is set: nobody is due."));
    show_due({}, tr("Looking for people who are due …"));
    auto due = std::make_shared<std::vector<database::DuePerson>>();
    due_job_ = BackgroundJob::run(
        this,
        [due, session = context().session(), path = context().store().path()](const Progress&) {
            *due = database::people_due(open_for_worker(path, true), session);
        },
        [this, due] {
            due_job_ = nullptr;
            const QString words = due->empty()
                                      ? tr("Nobody is due.")
                                      : tr("%n people are due.", nullptr, static_cast<int>(due->size()));
            show_due(std::move(*due), words);
        },
        [this](const QString& why) {
            due_job_ = nullptr;
            show_due({}, {});
            context().complain(why);
        });
}

void PersonalDataPage::show_due(std::vector<database::DuePerson> due, const QString& words) {
    due_ = std::move(due);
    erase_due_sure_->hide();
    due_table_->setRowCount(0);
    for (const database::DuePerson& one : due_) {
        const int row = due_table_->rowCount();
        due_table_->insertRow(row);
        due_table_->setItem(row, 0, make_cell(text(one.display_name)));
        due_table_->setItem(row, 1, make_cell(text(one.login)));
        due_table_->setItem(row, 2, make_cell(local_time(one.last)));
        due_table_->setItem(row, 3,
                            make_cell(QString::number(one.attempts), Qt::AlignRight | Qt::AlignVCenter));
    }
    fit_columns(due_table_, {2});
    due_text_->setText(words);
    due_table_->setVisible(!due_.empty());
    erase_due_->setVisible(!due_.empty());
    update_buttons();
}

std::optional<int> PersonalDataPage::chosen_months() const {
    return limited_->isChecked() ? std::optional<int>(months_->value()) : std::nullopt;
}

QStringList PersonalDataPage::begun_input(Ending ending) const {
    QStringList begun = Page::begun_input(ending);
    if (chosen_months() != kept_months_) begun << tr("how long data are kept");
    return begun;
}

void PersonalDataPage::save_retention() {
    if (context().guarded(
            [&] { database::set_retention_months(context().store(), context().session(), chosen_months()); }))
        context().say(tr("Saved."));
    show_retention();
}

void PersonalDataPage::erase_due() {
    if (job_ != nullptr) return;
    months_->setFocus();
    erase_due_sure_->hide();
    std::vector<std::string> ids;
    for (const database::DuePerson& one : due_) ids.push_back(one.id);
    auto erased = std::make_shared<std::vector<std::string>>();
    BackgroundJob* const job = BackgroundJob::run(
        this,
        [erased, ids, session = context().session(),
         path = context().store().path()](const Progress& progress) {
            *erased = database::erase_due(open_for_worker(path, false), session, ids, progress);
        },
        [this, erased] {
            context().say(tr("%n people were erased.", nullptr, static_cast<int>(erased->size())));
        },
        [this](const QString& why) { context().complain(why); });
    start(job, tr("Erasing …"));
    // Also after *Cancel*: some are erased then, and the list has the others.
    connect(job, &BackgroundJob::ended, this, [this] {
        ended();
        if (!entered_) return;
        fill_people();
        show_retention();
    });
}

}  // namespace fulcrum::ui

#include "moc_personal_data_page.cpp"
