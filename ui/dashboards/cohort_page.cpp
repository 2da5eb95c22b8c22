// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/cohort_page.h"

#include <QComboBox>
#include <QHeaderView>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>
#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "database/records/people.h"
#include "ui/dashboards/cohort_grid.h"
#include "ui/dashboards/concern_words.h"
#include "ui/dashboards/overview_view.h"
#include "ui/dashboards/practice_view.h"
#include "ui/page/background_job.h"
#include "ui/page/station_note.h"
#include "ui/page/store_reading.h"
#include "ui/reports/export_row.h"
#include "ui/reports/not_here_words.h"
#include "ui/reports/report_export.h"
#include "ui/style/flow_row.h"
#include "ui/style/kept_places.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int attention_tab = 3;
constexpr int more_classes_role = Qt::UserRole + 1;

/// A cell has room for one of the device classes: the one used last, of those with attempts that count where
/// there are any.
bool is_shown_rather(const database::CohortRow& row, const database::CohortRow& than) {
    const auto rank = [](const database::CohortRow& one) {
        return std::make_pair(one.state != database::TaskState::open, one.last_attempt);
    };
    return rank(row) > rank(than);
}

Tint tint_of(database::TaskState state) {
    return state == database::TaskState::passed ? Tint::good
           : state == database::TaskState::open ? Tint::muted
                                                : Tint::none;
}

}  // namespace

QString cohort_cell_text(const database::CohortRow& row) {
    QString state;
    switch (row.state) {
        case database::TaskState::passed:
            state = row.provisional ? CohortPage::tr("✓ passed (provisional)") : CohortPage::tr("✓ passed");
            break;
        case database::TaskState::attempted:
            state = CohortPage::tr("attempted");
            break;
        case database::TaskState::open:
            state = CohortPage::tr("not attempted");  // the grid shows whether it is locked
            break;
    }
    if (!row.device_class) return state;
    QString line = CohortPage::tr("%1 · attempts %2").arg(state).arg(row.attempts);
    if (row.best_points) line += CohortPage::tr(" · best %1").arg(points_text(*row.best_points));
    return line + QStringLiteral("\n") + device_class_text(*row.device_class);
}

QString cohort_cell_mark(const database::CohortRow& row) {
    // Practice alone does not count.
    if (row.state == database::TaskState::open) return QStringLiteral("–");
    const QString state = row.state != database::TaskState::passed ? QStringLiteral("○")
                          : row.provisional                        ? QStringLiteral("(✓)")
                                                                   : QStringLiteral("✓");
    if (row.best_points)
        return QStringLiteral("%1 %2 · %3").arg(state, points_figure(row.best_points)).arg(row.attempts);
    return QStringLiteral("%1 %2").arg(state).arg(row.attempts);
}

CohortPage::CohortPage(Context& context) : Page(context, "cohort_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    layout->addWidget(make_label(tr("Cohort"), "title"));
    note_ = new StationNote;
    layout->addWidget(note_);
    auto* row = new FlowRow;
    row->setSpacing(24);
    cohort_ = new QComboBox;
    cohort_->setObjectName(QStringLiteral("cohort_choice"));
    cohort_->setAccessibleName(tr("Cohort"));
    cohort_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    cohort_->setMinimumContentsLength(18);
    row->add(cohort_, 1, 240);
    export_ = new ExportRow("export_cohort");
    row->add(export_, 1, 560);
    layout->addLayout(row);
    job_ = new JobBar;
    layout->addWidget(job_);
    summary_ = make_label({}, "muted");
    summary_->setObjectName(QStringLiteral("cohort_summary"));
    layout->addWidget(summary_);
    layout->addWidget(make_views(), 1);
    foot_ = make_label(
        tr("✓ passed, (✓) passed with provisional limits, ○ attempted, – not attempted. Then the best points "
           "and the number of attempts that count, with the type of device used last of those that have any; "
           "+1: with one type of device more. *: proficient by decision of an educator. The tool tip shows "
           "all, "
           "also where the arrow keys lead."),
        "muted");
    layout->addWidget(foot_);
    unknown_ = make_label(tr("?: the standing is not known here."), "muted");
    unknown_->setObjectName(QStringLiteral("unknown_note"));
    layout->addWidget(unknown_);
    show_versions_ = make_button(tr("Show versions of limits and metrics"), "show_versions", "link");
    layout->addWidget(show_versions_, 0, Qt::AlignLeft);
    versions_ = make_label({}, "muted");
    versions_->setObjectName(QStringLiteral("cohort_versions"));
    versions_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    versions_->hide();
    layout->addWidget(versions_);
    connect(show_versions_, &QPushButton::clicked, this, [this] {
        versions_->setVisible(!versions_->isVisible());
        show_versions_->setText(versions_->isVisible() ? tr("Hide versions of limits and metrics")
                                                       : tr("Show versions of limits and metrics"));
    });
    connect(cohort_, QOverload<int>::of(&QComboBox::activated), this, &CohortPage::load);
    connect(export_, &ExportRow::save_wanted, this,
            [this](const QString& path) { export_to(path, report_format_of(path)); });
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
    reading_ = new StoreReading(context, this);
    show_begun_reports(context, this, job_);
}

QWidget* CohortPage::make_views() {
    views_ = new QTabWidget;
    views_->setObjectName(QStringLiteral("cohort_views"));
    views_->setAccessibleName(tr("Views of the cohort"));
    grid_ = new CohortGrid;
    overview_ = new OverviewView;
    practice_ = new PracticeView;
    const auto open_progress = [this](const QString& person, const QString& task) {
        emit context().progress_wanted(person, task);
    };
    connect(grid_, &CohortGrid::person_wanted, this, open_progress);
    connect(practice_, &PracticeView::person_wanted, this, open_progress);
    concerns_ = make_table({tr("Person"), tr("Reason")}, "cohort_concerns");
    concerns_->setAccessibleName(tr("Needs attention"));
    concerns_->setWordWrap(true);
    concerns_->setMinimumHeight(300);
    connect(concerns_, &QTableWidget::itemActivated, this, [this, open_progress](QTableWidgetItem* item) {
        const QTableWidgetItem* name = concerns_->item(item->row(), 0);
        const QTableWidgetItem* reason = concerns_->item(item->row(), 1);
        open_progress(name->data(Qt::UserRole).toString(), reason->data(Qt::UserRole).toString());
    });
    table_ = make_table({}, "cohort_table");
    table_->setAccessibleName(tr("Table"));
    table_->setSelectionBehavior(QAbstractItemView::SelectItems);
    table_->setMinimumHeight(380);
    table_->setWordWrap(false);
    QHeaderView* heads = table_->horizontalHeader();
    heads->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter |
                               static_cast<Qt::Alignment>(Qt::TextWordWrap));
    // Once for all columns that change their width together.
    auto* resized = new QTimer(this);
    resized->setSingleShot(true);
    connect(heads, &QHeaderView::sectionResized, resized, [resized] { resized->start(0); });
    connect(resized, &QTimer::timeout, this, &CohortPage::fit);
    connect(table_, &QTableWidget::itemActivated, this, [this](QTableWidgetItem* item) {
        const QString person = table_->item(item->row(), 0)->data(Qt::UserRole).toString();
        const QString task = item->column() == 0 ? QString() : item->data(Qt::UserRole).toString();
        emit context().progress_wanted(person, task);
    });
    views_->addTab(grid_, tr("Grid"));
    views_->addTab(overview_, tr("Tasks"));
    views_->addTab(practice_, tr("Days of practice"));
    views_->addTab(concerns_, QString());
    views_->addTab(table_, tr("Table"));
    // A tab's widget may be narrower or of another font when it is first shown.
    connect(views_, &QTabWidget::currentChanged, this, [this] {
        fit();
        show_foot();
    });
    return views_;
}

void CohortPage::enter() {
    note_->look(context());
    const QString before = cohort_->currentData().toString();
    cohort_->clear();
    context().guarded([&] {
        for (const database::Cohort& cohort :
             database::People(context().store()).cohorts(context().session())) {
            cohort_->addItem(text(cohort.name), text(cohort.id));
        }
    });
    cohort_->setCurrentIndex(std::max(0, cohort_->findData(before)));
    load();
    (cohort_->count() > 1 ? static_cast<QWidget*>(cohort_) : views_->currentWidget())->setFocus();
}

void CohortPage::leave() {
    reading_->stop();
}

void CohortPage::clear() {
    data_.reset();
    table_->setRowCount(0);
    table_->setColumnCount(0);
    concerns_->setRowCount(0);
    views_->setTabText(attention_tab, tr("Needs attention"));
    grid_->show_table({}, {});
    overview_->show_table({}, {});
    practice_->show_table({});
}

void CohortPage::load() {
    reading_->stop();
    const std::string id = plain(cohort_->currentData().toString());
    if (!data_ || data_->cohort_id != id || !reading_->read_in_this_role()) clear();
    show_foot();
    export_->setVisible(!id.empty() &&
                        context().allowed(database::Operation::export_cohort, database::Subject::cohort(id)));
    if (id.empty()) {
        summary_->setText(
            tr("There is no cohort yet. A director creates cohorts on the page \"Assign cohorts\"."));
        return;
    }
    export_->propose(cohort_->currentText());
    summary_->setText(tr("Reading the cohort …"));
    // Another version may be published while it is read.
    const auto curriculum = std::make_shared<const Curriculum>(context().services().curriculum());
    database::CohortTableOptions options;
    for (const TaskDefinition& task : context().services().tasks()) options.tasks.push_back(task.id);
    options.curriculum = curriculum.get();
    reading_->begin(
        [id, options, curriculum](const database::Store& store, const database::Session& session) {
            return database::Reports(store).cohort_table(session, id, options);
        },
        [this, curriculum](database::CohortTable table) { show_table(std::move(table), *curriculum); },
        [this](const QString& why) {
            clear();
            show_foot();
            summary_->setText(why);
        });
}

void CohortPage::show_table(database::CohortTable table, const Curriculum& curriculum) {
    const KeptPlaces places(this);
    clear();
    data_ = std::move(table);
    QStringList titles;
    for (const CurriculumTask& task : curriculum.tasks) titles << context().task_title(task.task);
    grid_->show_table(*data_, titles);
    overview_->show_table(*data_, titles);
    practice_->show_table(*data_);
    show_concerns();
    show_rows();
    QString line_text = tr("%n people", nullptr, static_cast<int>(data_->people));
    if (data_->deactivated > 0) line_text += tr(" · deactivated: %1").arg(data_->deactivated);
    if (data_->left_out_synthetic > 0) {
        line_text += tr(" · synthetic left out: %1").arg(data_->left_out_synthetic);
    }
    line_text += tr(" · Only attempts that count. Types of device are not combined.");
    const QString not_here = not_here_line(data_->standings);
    summary_->setText(not_here.isEmpty() ? line_text : line_text + QStringLiteral("\n▲ ") + not_here);
    QStringList sets;
    for (const std::string& set : data_->benchmark_sets) sets << text(set);
    versions_->setText(tr("Benchmark sets: %1\nMetrics: %2")
                           .arg(sets.isEmpty() ? QStringLiteral("–") : sets.join(QStringLiteral(", ")),
                                versions_in_short(data_->metric_versions)));
    show_foot();
}

/// Only the table has signs that need words.
void CohortPage::show_foot() {
    const bool in_table = data_.has_value() && views_->currentWidget() == table_;
    foot_->setVisible(in_table);
    unknown_->setVisible(in_table &&
                         std::any_of(data_->standings.begin(), data_->standings.end(),
                                     [](const database::PersonStandings& one) { return one.not_here; }));
    show_versions_->setVisible(data_.has_value());
    if (!data_) versions_->hide();
}

void CohortPage::show_rows() {
    QStringList titles{tr("Person")};
    for (const std::string& task : data_->tasks) titles << context().task_title(task);
    table_->setColumnCount(titles.size());
    table_->setHorizontalHeaderLabels(titles);
    std::string person;
    int line = -1;
    std::map<QTableWidgetItem*, const database::CohortRow*> shown;
    for (const database::CohortRow& row : data_->rows) {
        if (row.person_id != person || line < 0) {
            person = row.person_id;
            line = table_->rowCount();
            table_->insertRow(line);
            auto* name = make_cell(account_text(row.name, row.active));
            name->setData(Qt::UserRole, text(row.person_id));
            table_->setItem(line, 0, name);
        }
        for (std::size_t t = 0; t < data_->tasks.size(); ++t) {
            if (data_->tasks[t] != row.task_id) continue;
            const int column = static_cast<int>(t) + 1;
            QTableWidgetItem* cell = table_->item(line, column);
            if (cell == nullptr) {
                cell = make_cell({});
                cell->setData(Qt::UserRole, text(row.task_id));
                cell->setToolTip(cohort_cell_text(row));
                table_->setItem(line, column, cell);
            } else {
                cell->setToolTip(cell->toolTip() + QStringLiteral("\n") + cohort_cell_text(row));
                cell->setData(more_classes_role, cell->data(more_classes_role).toInt() + 1);
            }
            cell->setData(Qt::AccessibleTextRole, cell->toolTip());
            const database::CohortRow*& in_cell = shown[cell];
            if (in_cell != nullptr && !is_shown_rather(row, *in_cell)) continue;
            in_cell = &row;
            cell->setText(cohort_cell_mark(row));
            set_tint(cell, tint_of(row.state));
        }
    }
    for (int line_of = 0; line_of < table_->rowCount(); ++line_of)
        for (int column = 1; column < table_->columnCount(); ++column)
            if (QTableWidgetItem* cell = table_->item(line_of, column))
                if (const int more = cell->data(more_classes_role).toInt(); more > 0)
                    cell->setText(cell->text() + QStringLiteral(" +%1").arg(more));
    mark_decisions();
    mark_unknown();
    // No column is narrower than a word of its heading: with many tasks the table scrolls sideways.
    QFont bold = table_->font();
    bold.setWeight(QFont::DemiBold);
    int longest = 0;
    for (const QString& title : titles)
        for (const QString& word : title.split(QLatin1Char(' ')))
            longest = std::max(longest, QFontMetrics(bold).horizontalAdvance(word));
    table_->horizontalHeader()->setMinimumSectionSize(longest + 26);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    fit();
}

/// Who is proficient by decision of an educator need not have passed at all.
void CohortPage::mark_decisions() {
    std::map<std::pair<QString, QString>, QString> decided;
    for (const database::PersonStandings& person : data_->standings)
        for (const auto* tasks : {&person.tasks, &person.own_tasks})
            for (const database::PersonTask& task : *tasks)
                if (task.standing.declared_by_decision())
                    decided[{text(person.person_id), text(task.standing.task)}] =
                        standing_name(task.standing);
    if (decided.empty()) return;
    for (int line = 0; line < table_->rowCount(); ++line) {
        const QString person = table_->item(line, 0)->data(Qt::UserRole).toString();
        for (int column = 1; column < table_->columnCount(); ++column) {
            QTableWidgetItem* cell = table_->item(line, column);
            if (cell == nullptr) continue;
            const auto found = decided.find({person, cell->data(Qt::UserRole).toString()});
            if (found == decided.end()) continue;
            cell->setText(QStringLiteral("* ") + cell->text());
            cell->setToolTip(found->second + QStringLiteral("\n") + cell->toolTip());
            cell->setData(Qt::AccessibleTextRole, cell->toolTip());
        }
    }
}

/// What a person performed is known, but not what the version says of it that the person follows.
void CohortPage::mark_unknown() {
    std::map<QString, QString> versions;
    for (const database::PersonStandings& person : data_->standings)
        if (person.not_here) versions[text(person.person_id)] = text(person.curriculum);
    if (versions.empty()) return;
    for (int line = 0; line < table_->rowCount(); ++line) {
        const QTableWidgetItem* name = table_->item(line, 0);
        const auto found = versions.find(name->data(Qt::UserRole).toString());
        if (found == versions.end()) continue;
        for (int column = 1; column < table_->columnCount(); ++column) {
            QTableWidgetItem* cell = table_->item(line, column);
            if (cell == nullptr) continue;
            const std::string task = plain(cell->data(Qt::UserRole).toString());
            cell->setText(QStringLiteral("? ") + cell->text());
            cell->setToolTip(unknown_cell_text(name->text(), context().task_title(task), found->second) +
                             QStringLiteral("\n") + cell->toolTip());
            cell->setData(Qt::AccessibleTextRole, cell->toolTip());
        }
    }
}

void CohortPage::show_concerns() {
    for (const database::PersonStandings& person : data_->standings) {
        for (const Concern& concern : person.concerns) {
            const int line = concerns_->rowCount();
            concerns_->insertRow(line);
            QTableWidgetItem* name = make_cell(text(person.name));
            name->setData(Qt::UserRole, text(person.person_id));
            concerns_->setItem(line, 0, name);
            const QString title = concern.task.empty() ? QString() : context().task_title(concern.task);
            QTableWidgetItem* reason = make_cell(concern_text(concern, title, data_->as_of));
            reason->setData(Qt::UserRole, text(concern.task));
            concerns_->setItem(line, 1, reason);
        }
    }
    views_->setTabText(attention_tab, tr("Needs attention (%1)").arg(concerns_->rowCount()));
    concerns_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    concerns_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
}

// Five tasks or more leave a column narrower than its words.
void CohortPage::fit() {
    fit_heads(table_);
    fit_rows(table_);
    fit_rows(concerns_);
}

void CohortPage::export_to(const QString& path, ReportFormat format) {
    ReportRequest request;
    request.cohort_id = plain(cohort_->currentData().toString());
    if (request.cohort_id.empty()) return;
    request.format = format;
    request.path = plain(path);
    export_report(context(), this, job_, request, [this](const QString& file) {
        export_->look();
        emit exported(file);
    });
}

}  // namespace fulcrum::ui

#include "moc_cohort_page.cpp"
