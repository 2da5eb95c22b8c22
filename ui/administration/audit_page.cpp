// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/audit_page.h"

#include <QComboBox>
#include <QDateEdit>
#include <algorithm>

#include "database/records/people.h"
#include "ui/administration/audit_words.h"
#include "ui/page/background_job.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// Days back that a choice of the period means; those of one's own choosing and all time have none.
constexpr int all_time = -1, chosen_days = -2;
constexpr int beside_page = 80;  ///< px left and right of a page's body

QComboBox* make_choice(const QString& label, const char* name) {
    auto* box = new QComboBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setAccessibleName(label);
    box->setMinimumWidth(170);
    return box;
}

QDateEdit* make_day(const QString& label, const char* name) {
    auto* day = new QDateEdit(QDate::currentDate());
    day->setObjectName(QString::fromLatin1(name));
    day->setAccessibleName(label);
    day->setCalendarPopup(true);
    day->setDisplayFormat(day_format());
    return day;
}

/// The choice stays what it was.
void refill(QComboBox* box, const QString& all, const std::vector<std::pair<QString, QString>>& rows) {
    const QString before = box->currentData().toString();
    box->clear();
    box->addItem(all, QString());
    for (const auto& [shown, id] : rows) box->addItem(shown, id);
    box->setCurrentIndex(std::max(0, box->findData(before)));
}

struct LogState {
    std::vector<Sentence> problems;
    std::int64_t rows = 0;
    std::string head;
    std::vector<std::string> kinds;
};

}  // namespace

AuditPage::AuditPage(Context& context) : Page(context, "audit_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    layout->addWidget(make_label(tr("Audit log"), "title"));
    chain_ = make_label({});
    chain_->setObjectName(QStringLiteral("audit_chain"));
    chain_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    layout->addWidget(chain_);
    layout->addWidget(build_filters());
    table_ =
        make_table({tr("Time"), tr("Person"), tr("Role"), tr("Operation"), tr("Concerning"), tr("Details")},
                   "audit_table");
    table_->setAccessibleName(tr("Audit log"));
    table_->setMinimumHeight(380);
    table_->setWordWrap(false);  // a line each
    layout->addWidget(table_, 1);
    older_ = make_button(tr("Show older entries"), "audit_older");
    connect(older_, &QPushButton::clicked, this, &AuditPage::load_older);
    layout->addWidget(older_, 0, Qt::AlignLeft);
    layout->addWidget(
        make_label(tr("Comments and reasons about an attempt are not shown here; people who may open the "
                      "attempt see them there. A person who can write to the store's file could rewrite the "
                      "whole log: compare the newest hash above with the one printed in a report."),
                   "muted"));
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
}

QWidget* AuditPage::build_filters() {
    auto* filters = new QWidget;
    auto* row = new FlowRow(filters);
    person_ = make_choice(tr("Person"), "audit_person");
    kind_ = make_choice(tr("Kind"), "audit_kind");
    kind_->addItem(tr("Everything"), QString());  // until the log was read
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    period_ = make_choice(tr("Period"), "audit_period");
    period_->addItem(tr("All time"), all_time);
    period_->addItem(tr("Today"), 0);
    period_->addItem(tr("Last 7 days"), 7);
    period_->addItem(tr("Last 30 days"), 30);
    period_->addItem(tr("From … to …"), chosen_days);
    days_ = new QWidget;
    auto* days = new QHBoxLayout(days_);
    days->setContentsMargins(0, 0, 0, 0);
    from_ = make_day(tr("From"), "audit_from");
    until_ = make_day(tr("To"), "audit_until");
    for (QDateEdit* day : {from_, until_}) {
        days->addWidget(day);
        connect(day, &QDateEdit::dateChanged, this, &AuditPage::load);
    }
    for (QComboBox* box : {person_, kind_, period_}) {
        row->add(box);
        connect(box, QOverload<int>::of(&QComboBox::activated), this, &AuditPage::load);
    }
    row->add(days_);
    count_ = make_label({}, "muted");
    count_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->add(count_, 1, with_text(120));
    return filters;
}

void AuditPage::enter() {
    fill_people();
    load();
    verify();
    table_->setFocus();
}

void AuditPage::leave() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
}

void AuditPage::fill_people() {
    std::vector<std::pair<QString, QString>> people;
    context().guarded([&] {
        for (const database::Person& person : database::People(context().store()).list(context().session()))
            people.emplace_back(text(person.display_name), text(person.id));
    });
    refill(person_, tr("Everyone"), people);
}

void AuditPage::fill_kinds(const std::vector<std::string>& found) {
    std::vector<std::pair<QString, QString>> kinds;
    QString group;
    for (const std::string& kind : found) {
        const QString name = text(kind), front = name.section(QLatin1Char('.'), 0, 0);
        if (front != group && name.contains(QLatin1Char('.')))
            kinds.emplace_back(audit_group_text(plain(front)), front);
        group = front;
        kinds.emplace_back(audit_operation_text(kind), name);
    }
    refill(kind_, tr("Everything"), kinds);
}

database::AuditFilter AuditPage::filter() const {
    database::AuditFilter filter;
    filter.person_id = plain(person_->currentData().toString());
    filter.kind = plain(kind_->currentData().toString());
    filter.limit = at_once;
    const int back = period_->currentData().toInt();
    if (back == chosen_days) {
        filter.from = from_->date().startOfDay().toMSecsSinceEpoch();
        filter.until = until_->date().addDays(1).startOfDay().toMSecsSinceEpoch();
    } else if (back != all_time) {
        filter.from = QDate::currentDate().addDays(-back).startOfDay().toMSecsSinceEpoch();
    }
    return filter;
}

void AuditPage::load() {
    days_->setVisible(period_->currentData().toInt() == chosen_days);
    table_->setRowCount(0);
    oldest_ = -1;
    load_older();
}

void AuditPage::load_older() {
    std::vector<database::AuditEntry> entries;
    context().guarded([&] {
        database::AuditFilter wanted = filter();
        wanted.before_sequence = oldest_;
        entries = database::Audit(context().store()).entries(context().session(), wanted);
    });
    show_entries(entries);
    const bool more = static_cast<int>(entries.size()) == at_once;
    if (!more && older_->hasFocus()) table_->setFocus();
    older_->setVisible(more);
    count_->setText(tr("%n entries shown", nullptr, table_->rowCount()));
}

void AuditPage::show_entries(const std::vector<database::AuditEntry>& entries) {
    table_->setUpdatesEnabled(false);
    for (const database::AuditEntry& entry : entries) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        const QString actor = entry.actor_id == entry.station_id ? tr("Station") : text(entry.actor_name);
        const QString cells[] = {local_time(entry.time),  actor,
                                 role_text(entry.role),   audit_operation_text(entry.operation),
                                 text(entry.person_name), audit_details_text(entry.operation, entry.payload)};
        for (int column = 0; column < 6; ++column) table_->setItem(row, column, make_cell(cells[column]));
        table_->item(row, 1)->setToolTip(join_with_dots({cells[1], cells[2]}));
        table_->item(row, 5)->setToolTip(cells[5] + QLatin1Char('\n') +
                                         tr("Row %1, object %2, hash %3")
                                             .arg(entry.sequence)
                                             .arg(text(entry.object_id), text(entry.hash)));
        oldest_ = entry.sequence;
    }
    table_->setUpdatesEnabled(true);
    fit_columns(table_, {0});
}

// In a narrow window the details need the room more than the role, which the tool tip of the person has.
void AuditPage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    table_->setColumnHidden(2, width() < 130 * fontMetrics().averageCharWidth());
}

void AuditPage::verify() {
    leave();
    chain_->setText(tr("Checking the audit log …"));
    chain_->setStyleSheet({});
    auto state = std::make_shared<LogState>();
    job_ = BackgroundJob::run(
        this,
        [state, session = context().session(), path = context().store().path()](const Progress&) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(path, options);
            const database::Audit audit(store);
            *state = {audit.verify(), audit.count(), audit.head(), audit.kinds(session)};
        },
        [this, state] {
            job_ = nullptr;
            fill_kinds(state->kinds);
            const bool holds = state->problems.empty();
            QString line = holds ? tr("✓ The audit log is intact: %1 rows.\nNewest hash: %2")
                                 : tr("✕ The audit log is damaged: %1 rows.\nNewest hash: %2");
            line =
                line.arg(state->rows).arg(in_lines(text(state->head), fontMetrics(), width() - beside_page));
            for (std::size_t i = 0; i < std::min<std::size_t>(5, state->problems.size()); ++i)
                line += QLatin1Char('\n') + sentence_text(state->problems[i]);
            if (state->problems.size() > 5) line += tr("\nand %1 more").arg(state->problems.size() - 5);
            chain_->setText(line);
            set_tint(chain_, holds ? Tint::good : Tint::bad);
        },
        [this](const QString& why) {
            job_ = nullptr;
            chain_->setText(tr("The audit log could not be read: %1").arg(why));
        });
}

}  // namespace fulcrum::ui

#include "moc_audit_page.cpp"
