// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/trace_import_card.h"

#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QScrollArea>
#include <QTableWidget>
#include <QTimer>

#include "database/records/people.h"
#include "database/store/store.h"
#include "ui/page/background_job.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

const QString time_format = QStringLiteral("yyyy-MM-dd HH:mm");
constexpr int shown_names = 8;  // of columns that were not read

const QString own_format = QStringLiteral("own"), another_file = QStringLiteral("another");

QString names_of(const nlohmann::json& names) {
    QStringList words;
    for (const nlohmann::json& name : names) {
        if (words.size() == shown_names) {
            words << TraceImportCard::tr("and %1 more").arg(static_cast<int>(names.size()) - shown_names);
            break;
        }
        words << text(name.get<std::string>()).left(40);
    }
    return words.join(QStringLiteral(", "));
}

}  // namespace

TraceImportCard::TraceImportCard(Context& context)
    : context_(context),
      path_(new QLineEdit),
      exercise_(new QLineEdit),
      performed_(new QLineEdit),
      mapping_(new QComboBox),
      person_(new QComboBox),
      look_(make_button(tr("Read the file"), "trace_look")),
      import_(make_button(tr("Import"), "trace_import", "primary")),
      problem_(make_label({})),
      summary_(make_label({})),
      notes_(make_label({}, "muted")),
      columns_(make_table({tr("Value"), tr("Unit"), tr("Column in the file"), tr("Unit in the file")},
                          "trace_columns")),
      details_(new QWidget),
      bar_(new JobBar) {
    setObjectName(QStringLiteral("trace_import_card"));
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Import a recording from another system"), "heading"));
    layout->addWidget(make_label(
        tr("A recording from a box trainer, a robot or another simulator. It is measured and marked as "
           "external. It is not compared with limits and does not count in the curriculum."),
        "muted"));
    layout->addWidget(file_row());
    problem_->setObjectName(QStringLiteral("trace_problem"));
    set_tint(problem_, Tint::bad);
    problem_->hide();
    layout->addWidget(problem_);
    layout->addWidget(preview());
    layout->addWidget(bar_);
    connect(look_, &QPushButton::clicked, this, &TraceImportCard::look);
    connect(import_, &QPushButton::clicked, this, &TraceImportCard::store);
}

TraceImportCard::~TraceImportCard() {
    stop();
}

void TraceImportCard::stop() {
    if (job_ == nullptr) return;
    job_->disconnect(this);
    job_->cancel();
    job_ = nullptr;
    set_busy(false);
}

QWidget* TraceImportCard::add_field(FlowRow* row, const QString& label, QWidget* field, const char* name) {
    field->setObjectName(QString::fromLatin1(name));
    field->setAccessibleName(label);
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    QLabel* words = make_label(label);
    words->setBuddy(field);
    column->addWidget(words);
    column->addWidget(field);
    row->add(holder, 1, with_text(190));
    return holder;
}

QWidget* TraceImportCard::file_row() {
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    add_field(row, tr("File of the recording"), path_, "trace_path");
    mapping_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    add_field(row, tr("Format of the file"), mapping_, "trace_mapping");
    QPushButton* file = make_button(tr("File …"), "trace_file");
    row->add(file);
    row->add(look_);
    connect(file, &QPushButton::clicked, this, &TraceImportCard::choose_trace);
    connect(path_, &QLineEdit::returnPressed, this, &TraceImportCard::look);
    connect(path_, &QLineEdit::textChanged, this, &TraceImportCard::forget);
    connect(mapping_, QOverload<int>::of(&QComboBox::activated), this, &TraceImportCard::mapping_changed);
    return holder;
}

QWidget* TraceImportCard::person_row() {
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    person_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    exercise_->setPlaceholderText(QStringLiteral("peg-transfer"));
    exercise_->setMaxLength(40);
    add_field(row, tr("Person"), person_, "trace_person");
    add_field(row, tr("Exercise"), exercise_, "trace_exercise");
    add_field(row, tr("Performed at"), performed_, "trace_performed");
    row->add(import_);
    return holder;
}

QWidget* TraceImportCard::preview() {
    auto* below = new QVBoxLayout(details_);
    below->setContentsMargins(0, 0, 0, 0);
    summary_->setObjectName(QStringLiteral("trace_summary"));
    notes_->setObjectName(QStringLiteral("trace_notes"));
    below->addWidget(summary_);
    below->addWidget(notes_);
    columns_->setAccessibleName(tr("Column in the file"));
    columns_->setMinimumHeight(150);
    below->addWidget(columns_);
    below->addWidget(person_row());
    details_->hide();
    return details_;
}

void TraceImportCard::enter() {
    context_.guarded([&] {
        const QString before = person_->currentData().toString();
        person_->clear();
        person_->addItem(tr("Choose a person"), QString());
        for (const database::Person& person : database::People(context_.store()).list(context_.session()))
            if (context_.allowed(database::Operation::import_attempt, database::Subject::person(person.id)))
                person_->addItem(text(person.display_name), text(person.id));
        person_->setCurrentIndex(std::max(0, person_->findData(before)));
        if (mapping_->count() > 0) return;
        mapping_->addItem(tr("Fulcrum (CSV)"), own_format);
        // The first word is the format's name; the whole title has no room with large text.
        for (const DeliveredMapping& one : delivered_mappings()) {
            mapping_->addItem(text(one.title).section(QLatin1Char(' '), 0, 0), text(one.path));
            mapping_->setItemData(mapping_->count() - 1, asset_text(one.title), Qt::ToolTipRole);
        }
        mapping_->addItem(tr("Another mapping file …"), another_file);
    });
}

void TraceImportCard::choose_trace() {
    auto* dialog = new QFileDialog(this, tr("File of the recording"), path_->text());
    dialog->setObjectName(QStringLiteral("trace_file_dialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Recordings (*.csv *.txt *.tsv *.xml)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        path_->setText(QDir::toNativeSeparators(path));
        const bool is_xml = path.endsWith(QStringLiteral(".xml"), Qt::CaseInsensitive);
        for (int i = 0; is_xml && i < mapping_->count(); ++i)
            if (mapping_->itemData(i).toString().endsWith(QStringLiteral("perktutor.json")))
                mapping_->setCurrentIndex(mapping_before_ = i);
    });
    dialog->open();
}

void TraceImportCard::mapping_changed(int index) {
    forget();
    if (mapping_->itemData(index).toString() == another_file) {
        mapping_->setCurrentIndex(mapping_before_);
        choose_mapping();
    } else {
        mapping_before_ = index;
    }
}

void TraceImportCard::choose_mapping() {
    auto* dialog = new QFileDialog(this, tr("Mapping file"), path_->text());
    dialog->setObjectName(QStringLiteral("trace_mapping_dialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(tr("Mappings (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        int place = mapping_->findData(path);
        if (place < 0) {
            place = mapping_->count() - 1;  // before the line that asks for a file
            mapping_->insertItem(place, QFileInfo(path).fileName(), path);
            mapping_->setItemData(place, QDir::toNativeSeparators(path), Qt::ToolTipRole);
        }
        mapping_->setCurrentIndex(mapping_before_ = place);
        forget();
    });
    dialog->open();
}

void TraceImportCard::forget() {
    if (job_ != nullptr) stop();
    read_.reset();
    problem_->hide();
    details_->hide();
}

void TraceImportCard::show_problem(const QString& why) {
    problem_->show();
    announce_problem(problem_, why);
    bring(problem_);
}

void TraceImportCard::bring(QWidget* part) {
    QTimer::singleShot(0, part, [part] {
        for (QWidget* up = part->parentWidget(); up != nullptr; up = up->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(up)) area->ensureWidgetVisible(part);
    });
}

void TraceImportCard::set_busy(bool busy) {
    look_->setEnabled(!busy);
    import_->setEnabled(!busy);
}

void TraceImportCard::run(const QString& line, std::function<void(const Progress&)> work,
                          std::function<void()> done, std::function<void()> stopped) {
    set_busy(true);
    const auto end = [this] {
        job_ = nullptr;
        set_busy(false);
    };
    job_ = BackgroundJob::run(
        this, std::move(work),
        [end, done = std::move(done)] {
            end();
            done();
        },
        [this, end](const QString& why) {
            end();
            show_problem(why);
        });
    connect(job_, &BackgroundJob::ended, this, [this, end, stopped = std::move(stopped)] {
        if (job_ == nullptr) return;  // done or failed
        end();
        if (stopped) stopped();
    });
    bar_->watch(job_, line);
}

void TraceImportCard::look() {
    forget();
    const QString path = QDir::fromNativeSeparators(path_->text().trimmed());
    if (path.isEmpty()) {
        show_problem(tr("Choose the file that was recorded."));
        path_->setFocus();
        return;
    }
    const QString mapping = mapping_->currentData().toString();
    auto read = std::make_shared<ExternalTrace>();
    run(
        tr("Reading …"),
        [read, trace = plain(path),
         map = mapping == own_format ? std::string() : plain(mapping)](const Progress& progress) {
            *read = read_external_trace(trace, map, [&](double share) { return progress(share, {}); });
        },
        [this, read] {
            read_ = read;
            show_preview();
        });
}

void TraceImportCard::show_preview() {
    const nlohmann::json& document = read_->document;
    const QString rate = read_->rate_hz > 0 ? tr("%1 Hz").arg(figure(read_->rate_hz)) : tr("rate unknown");
    summary_->setText(QStringList{tr("%n samples", nullptr, static_cast<int>(read_->trace.t.size())), rate,
                                  clock_text(read_->trace.t.back() - read_->trace.t.front()),
                                  tr("%n metrics have a value", nullptr, static_cast<int>(read_->measured))}
                          .join(QStringLiteral(" · ")));
    QStringList notes;
    if (!document["ignored_columns"].empty())
        notes << tr("Not read: %1.").arg(names_of(document["ignored_columns"]));
    if (read_->left_out > 0)
        notes << tr("%n samples without a value were left out.", nullptr, static_cast<int>(read_->left_out));
    if (const auto gaps = static_cast<int>(document["gaps"].size()); gaps > 0)
        notes << tr("%n stretches of more than 0.1 s have no sample; nothing is measured across them.",
                    nullptr, gaps);
    notes_->setText(notes.join(QLatin1Char(' ')));
    notes_->setVisible(!notes.isEmpty());
    columns_->setRowCount(static_cast<int>(read_->columns.size()));
    for (int row = 0; row < columns_->rowCount(); ++row) {
        const ReadColumn& column = read_->columns[static_cast<std::size_t>(row)];
        const std::string cells[] = {column.ours, column.unit, column.theirs, column.their_unit};
        for (int i = 0; i < 4; ++i) columns_->setItem(row, i, make_cell(text(cells[i])));
    }
    fit_columns(columns_, {1, 3});
    // As good a guess as there is; the person who imports it knows better.
    const QDateTime written = QFileInfo(QDir::fromNativeSeparators(path_->text().trimmed())).lastModified();
    const QDateTime now = QDateTime::fromMSecsSinceEpoch(context_.store().now());
    performed_->setText((written.isValid() ? std::min(written, now) : now).toString(time_format));
    details_->show();
    announce(details_, summary_->text());
    bring(details_);
    (person_->currentData().toString().isEmpty() ? static_cast<QWidget*>(person_) : exercise_)->setFocus();
}

void TraceImportCard::store() {
    if (job_ != nullptr || !read_) return;
    problem_->hide();
    const QString person = person_->currentData().toString();
    if (person.isEmpty()) {
        show_problem(tr("Choose the person who performed it."));
        person_->setFocus();
        return;
    }
    const QDateTime performed = QDateTime::fromString(performed_->text().trimmed(), time_format);
    if (!performed.isValid()) {
        show_problem(tr("Give the time at which it was performed as 2026-11-20 14:05."));
        performed_->setFocus();
        return;
    }
    auto attempt = std::make_shared<database::ExternalAttempt>(external_attempt(*read_));
    attempt->person_id = plain(person);
    attempt->exercise = plain(exercise_->text().trimmed());
    attempt->performed = performed.toMSecsSinceEpoch();
    attempt->utc_offset_min = performed.offsetFromUtc() / 60;
    auto id = std::make_shared<std::string>();
    run(
        tr("Storing …"),
        [attempt, id, session = context_.session(),
         path = context_.store().path()](const Progress& progress) {
            const database::Store store = database::Store::open(path);
            const database::ExternalAttempts imports(store);
            imports.check(session, *attempt);
            if (progress(0.5, {})) *id = imports.add(session, *attempt);
        },
        [this, id] {
            if (id->empty()) return;  // stopped before anything was stored
            path_->clear();           // forgets the preview
            exercise_->clear();
            emit imported(text(*id));
        },
        [this] { emit imported({}); });  // it may have been stored before the stop was seen
}

}  // namespace fulcrum::ui

#include "moc_trace_import_card.cpp"
