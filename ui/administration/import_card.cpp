// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/import_card.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QTableWidget>
#include <algorithm>
#include <memory>

#include "sim_core/numerics/output_file.h"
#include "ui/page/background_job.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

using What = database::PersonImport::What;

QString what_words(const database::PersonImport& step) {
    switch (step.what) {
        case What::create:
            return ImportCard::tr("new account");
        case What::add_role:
            return ImportCard::tr("gets a role");
        case What::nothing:
            return ImportCard::tr("exists already");
        case What::refused:
            break;
    }
    return ImportCard::tr("not imported: the account is deactivated");
}

QString role_words(const std::vector<database::Role>& roles) {
    QStringList words;
    for (const database::Role role : roles) words << role_text(database::role_name(role));
    return words.join(QStringLiteral(", "));
}

int count_of(const std::vector<database::PersonImport>& steps, What what) {
    return static_cast<int>(std::count_if(
        steps.begin(), steps.end(), [&](const database::PersonImport& step) { return step.what == what; }));
}

}  // namespace

ImportCard::ImportCard(Context& context)
    : context_(context),
      path_(new QLineEdit),
      passwords_(new QLineEdit),
      table_(make_table({tr("Name"), tr("Login"), tr("Roles"), tr("Import")}, "import_table")),
      summary_(make_label({})),
      details_(new QWidget),
      bar_(new JobBar) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Import people from a list"), "heading"));
    layout->addWidget(make_label(
        tr("Choose a folder or ZIP archive with OneRoster CSV files, or one CSV file with the columns login, "
           "name, role and "
           "cohort. The import only adds accounts and roles; it renames, deactivates and removes nobody."),
        "muted"));
    layout->addWidget(make_path_row());
    auto* below = new QVBoxLayout(details_);
    below->setContentsMargins(0, 0, 0, 0);
    summary_->setObjectName(QStringLiteral("import_summary"));
    below->addWidget(summary_);
    table_->setAccessibleName(tr("Import people from a list"));
    table_->setMinimumHeight(180);
    below->addWidget(table_);
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    QLabel* label = make_label(tr("One-time passwords"));
    label->setWordWrap(false);
    row->add(label);
    passwords_->setObjectName(QStringLiteral("import_passwords"));
    passwords_->setAccessibleName(tr("New file for the one-time passwords"));
    row->add(passwords_, 1, 240);
    import_ = make_button(tr("Import"), "import_people", "primary");
    row->add(import_);
    below->addWidget(holder);
    layout->addWidget(details_);
    layout->addWidget(bar_);
    details_->hide();
    connect(import_, &QPushButton::clicked, this, &ImportCard::import);
    connect(bar_, &JobBar::cancelled, this, [this] { look_job_ = nullptr; });
}

ImportCard::~ImportCard() {
    if (job_ == nullptr) return;
    job_->disconnect(this);  // there is no receiver any more
    job_->cancel();
}

QWidget* ImportCard::make_path_row() {
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    path_->setObjectName(QStringLiteral("import_path"));
    path_->setAccessibleName(tr("File or folder of the list"));
    row->add(path_, 1, 240);
    QPushButton* file = make_button(tr("File …"), "import_file");
    QPushButton* folder = make_button(tr("Folder …"), "import_folder");
    look_ = make_button(tr("Preview"), "import_look");
    for (QPushButton* button : {file, folder, look_}) row->add(button);
    connect(file, &QPushButton::clicked, this, [this] { choose(false); });
    connect(folder, &QPushButton::clicked, this, [this] { choose(true); });
    connect(look_, &QPushButton::clicked, this, &ImportCard::look);
    connect(path_, &QLineEdit::returnPressed, this, &ImportCard::look);
    // What is shown belongs to the path that was looked at.
    connect(path_, &QLineEdit::textChanged, this, &ImportCard::forget);
    return holder;
}

void ImportCard::choose(bool folder) {
    auto* dialog = new QFileDialog(this, tr("List of people"), path_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(folder ? QFileDialog::Directory : QFileDialog::ExistingFile);
    if (!folder) dialog->setNameFilter(tr("CSV or ZIP (*.csv *.zip)"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        path_->setText(QDir::toNativeSeparators(path));
        look();
    });
    dialog->open();
}

void ImportCard::stop_looking() {
    if (look_job_ != nullptr) look_job_->cancel();
    look_job_ = nullptr;
}

void ImportCard::forget() {
    if (job_ != nullptr) return;
    stop_looking();
    plan_.clear();
    left_out_.clear();
    details_->hide();
}

void ImportCard::look() {
    if (job_ != nullptr) return;
    forget();
    const QString path = QDir::fromNativeSeparators(path_->text().trimmed());
    if (path.isEmpty()) {
        path_->setFocus();
        return;
    }
    struct Found {
        std::vector<database::PersonImport> plan;
        std::vector<Sentence> left_out;
    };
    auto found = std::make_shared<Found>();
    look_job_ = BackgroundJob::run(
        this,
        [found, list = path.toStdString(), session = context_.session(),
         store_path = context_.store().path()](const Progress&) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(store_path, options);
            const database::Roster roster = database::read_roster(list);
            found->plan = database::RosterImport(store, session).plan_people(roster);
            found->left_out = roster.left_out;
        },
        [this, found, path] {
            look_job_ = nullptr;
            plan_ = std::move(found->plan);
            for (const Sentence& line : found->left_out) left_out_ << sentence_text(line);
            const QDir folder = QFileInfo(path).isDir() ? QDir(path) : QFileInfo(path).dir();
            passwords_->setText(QDir::toNativeSeparators(folder.filePath(QStringLiteral("passwords.csv"))));
            show_plan();
        },
        [this](const QString& why) {
            look_job_ = nullptr;
            context_.complain(why);
        });
    bar_->watch(look_job_, tr("Reading the list …"));
}

void ImportCard::show_plan() {
    table_->setRowCount(static_cast<int>(plan_.size()) + left_out_.size());
    int row = 0;
    for (const database::PersonImport& step : plan_) {
        table_->setItem(row, 0, make_cell(text(step.person.name)));
        table_->setItem(row, 1, make_cell(text(step.person.login)));
        table_->setItem(row, 2, make_cell(role_words(step.person.roles)));
        QTableWidgetItem* what = make_cell(what_words(step));
        if (step.what == What::refused) set_tint(what, Tint::bad);
        if (step.what == What::nothing) set_tint(what, Tint::muted);
        table_->setItem(row++, 3, what);
    }
    for (const QString& line : left_out_) {
        for (int column = 0; column < 3; ++column) table_->setItem(row, column, make_cell({}));
        QTableWidgetItem* what = make_cell(tr("left out: %1").arg(line));
        set_tint(what, Tint::muted);
        table_->setItem(row++, 3, what);
    }
    fit_columns(table_, {1, 2});
    const int created = count_of(plan_, What::create), changed = count_of(plan_, What::add_role);
    summary_->setText(tr("%n new accounts", nullptr, created) + QStringLiteral(" · ") +
                      tr("%n people get a role", nullptr, changed) + QStringLiteral(" · ") +
                      tr("%n are there already", nullptr, count_of(plan_, What::nothing)) +
                      QStringLiteral(" · ") +
                      tr("%n left out", nullptr, count_of(plan_, What::refused) + left_out_.size()));
    import_->setEnabled(created + changed > 0);
    passwords_->setEnabled(created > 0);
    details_->show();
    announce(summary_, summary_->text());
}

void ImportCard::import() {
    if (job_ != nullptr || plan_.empty()) return;
    struct Result {
        std::vector<database::PersonImport> steps;
    };
    auto result = std::make_shared<Result>();
    result->steps = plan_;
    const QString passwords = QDir::fromNativeSeparators(passwords_->text().trimmed());
    std::shared_ptr<OutputFile> file;
    if (count_of(plan_, What::create) > 0) {
        const bool opened = context_.guarded([&] {
            file = std::make_shared<OutputFile>(passwords.toStdString(), OutputFile::Existing::keep,
                                                OutputFile::Access::owner_only);
        });
        if (!opened) return;
    }
    import_->setEnabled(false);
    look_->setEnabled(false);
    const auto ended = [this] {
        job_ = nullptr;
        look_->setEnabled(true);
    };
    job_ = BackgroundJob::run(
        this,
        [result, file, session = context_.session(),
         path = context_.store().path()](const Progress& progress) {
            const database::Store store = database::Store::open(path);
            const auto told = [&](std::size_t done, std::size_t all) {
                return progress(
                    static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(all, 1)), {});
            };
            try {
                database::RosterImport(store, session).bring_people(result->steps, told);
            } catch (...) {
                if (file) database::write_passwords(*file, result->steps);
                throw;
            }
            // Also after a stop: whoever was created needs the password.
            if (file) database::write_passwords(*file, result->steps);
        },
        [this, ended, result, passwords] {
            ended();
            finish(result->steps, passwords);
        },
        [this, ended](const QString& why) {
            ended();
            emit imported();
            look();
            context_.complain(why);
        });
    connect(job_, &BackgroundJob::ended, this, [this, ended] {
        if (job_ == nullptr) return;  // done or failed
        ended();
        if (!context_.signed_in()) return;  // signing out stopped it, and nobody may read the list now
        emit imported();
        forget();
        context_.say(
            tr("Stopped. The accounts that were made have their passwords in the file; an import of "
               "the same list makes the others."));
    });
    bar_->watch(job_, tr("Making accounts …"));
}

void ImportCard::finish(const std::vector<database::PersonImport>& steps, const QString& passwords) {
    const int created = count_of(steps, What::create);
    emit imported();
    forget();
    path_->clear();
    QString line = tr("%n accounts were made.", nullptr, created);
    if (created > 0)
        line +=
            QLatin1Char(' ') + tr("Their one-time passwords are in %1, valid for 24 hours. Hand them over "
                                  "and delete the file.")
                                   .arg(QDir::toNativeSeparators(passwords));
    context_.say(line);
}

void ImportCard::stop() {
    stop_looking();
    if (job_ != nullptr) job_->cancel();
}

}  // namespace fulcrum::ui

#include "moc_import_card.cpp"
