// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/to_rate_page.h"

#include <QCheckBox>
#include <algorithm>
#include <iterator>
#include <memory>

#include "ui/page/store_reading.h"
#include "ui/style/kept_places.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

using database::RatableAttempt;

namespace {

constexpr int awaited_column = 1, recorded_column = 4;

/// Of a rating that this rater would begin now, for the curriculum.
bool would_not_count(const RatableAttempt& one) {
    return one.awaited && one.wants_blind && !one.blind && one.own_handed_in == 0 && !one.own_draft;
}

}  // namespace

ToRatePage::ToRatePage(Context& context) : Page(context, "to_rate_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(12);
    layout->addWidget(make_label(tr("Rate attempts"), "title"));
    layout->addWidget(
        make_label(tr("Names and scores are hidden here. Your rating is blind if you have not opened the "
                      "attempt's name and score. Attempts that the curriculum needs ratings of come first."),
                   "muted"));
    auto* row = new QHBoxLayout;
    rated_ = new QCheckBox(tr("Include attempts that I have rated"));
    rated_->setObjectName(QStringLiteral("to_rate_rated"));
    connect(rated_, &QCheckBox::toggled, this, [this] {
        if (!reading_->reads()) fill();
    });
    row->addWidget(rated_);
    row->addStretch();
    count_ = make_label({}, "muted");
    count_->setObjectName(QStringLiteral("to_rate_count"));
    count_->setWordWrap(false);
    row->addWidget(count_);
    layout->addLayout(row);
    table_ = make_table({tr("Task"), tr("Needed"), tr("Variant"), tr("Started"), tr("Recorded"),
                         tr("Ratings"), tr("Yours"), tr("Blind")},
                        "to_rate_table");
    table_->setAccessibleName(tr("Rate attempts"));
    table_->setMinimumHeight(360);
    layout->addWidget(table_, 1);
    connect(table_, &QTableWidget::itemActivated, this,
            [this](QTableWidgetItem* item) { open_row(item->row()); });
    open_ = make_button(tr("Rate this attempt"), "to_rate_open", "primary");
    connect(open_, &QPushButton::clicked, this, [this] { open_row(table_->currentRow()); });
    layout->addWidget(open_, 0, Qt::AlignLeft);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
    reading_ = new StoreReading(context, this);
    connect(&context, &Context::rating_handed_in, this,
            [this](const QString& attempt_id) { note_handed_in(plain(attempt_id)); });
    connect(&context, &Context::attempt_voided, this,
            [this](const QString& attempt_id) { note_voided(plain(attempt_id)); });
}

void ToRatePage::enter() {
    load();
    table_->setFocus();
}

void ToRatePage::leave() {
    reading_->stop();
}

// In a narrow window what decides what to rate stays.
void ToRatePage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    table_->setColumnHidden(recorded_column, width() < 130 * fontMetrics().averageCharWidth());
}

void ToRatePage::load() {
    if (!reading_->read_in_this_role()) {
        all_.clear();
        fill();
    }
    count_->setText(tr("Reading the attempts …"));
    // Another version may be published while it is read.
    const auto curriculum = std::make_shared<const Curriculum>(context().services().curriculum());
    reading_->begin(
        [curriculum](const database::Store& store, const database::Session& session) {
            return database::Ratings(store).to_rate(session, curriculum.get());
        },
        [this](std::vector<RatableAttempt> found) {
            all_ = std::move(found);
            failed_.clear();
            fill();
        },
        [this](const QString& why) {
            all_.clear();
            failed_ = why;
            fill();
        });
}

void ToRatePage::fill() {
    const KeptPlaces places(this);
    attempts_.clear();
    std::copy_if(all_.begin(), all_.end(), std::back_inserter(attempts_),
                 [this](const RatableAttempt& one) { return rated_->isChecked() || one.own_handed_in == 0; });
    table_->setRowCount(static_cast<int>(attempts_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const RatableAttempt& one = attempts_[static_cast<std::size_t>(row)];
        QString own = one.own_handed_in > 0 ? QString::number(one.own_handed_in) : QStringLiteral("–");
        if (one.own_draft) own = tr("draft");
        const QString cells[] = {context().task_title(one.task_id),
                                 would_not_count(one) ? tr("● yes, by others")
                                 : one.awaited        ? tr("● yes")
                                                      : QStringLiteral("–"),
                                 context().variant_title(one.task_id, one.variant),
                                 local_time(one.started),
                                 clock_text(one.duration_s),
                                 QString::number(one.handed_in),
                                 own,
                                 one.blind ? tr("yes") : tr("no")};
        for (int column = 0; column < table_->columnCount(); ++column) {
            const bool number = column == 4 || column == 5;
            table_->setItem(
                row, column,
                make_cell(cells[column], (number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
        }
    }
    for (int row = 0; row < table_->rowCount(); ++row) {
        const RatableAttempt& one = attempts_[static_cast<std::size_t>(row)];
        table_->item(row, 0)->setData(Qt::UserRole, text(one.attempt_id));
        if (one.awaited)
            table_->item(row, awaited_column)
                ->setToolTip(
                    would_not_count(one)
                        ? tr("The curriculum needs blind ratings of this attempt. You have seen name or "
                             "score: yours would not count.")
                        : tr("The curriculum needs ratings of this attempt."));
    }
    fit_columns(table_, {awaited_column, 3, recorded_column, 5});
    if (table_->rowCount() > 0) table_->setCurrentCell(0, 0);
    open_->setEnabled(table_->rowCount() > 0);
    const auto awaited = std::count_if(attempts_.begin(), attempts_.end(),
                                       [](const RatableAttempt& one) { return one.awaited; });
    if (!failed_.isEmpty())
        count_->setText(failed_);
    else if (awaited == 0)
        count_->setText(tr("%n attempts", nullptr, table_->rowCount()));
    else
        count_->setText(tr("%n attempts, %1 awaiting rating", nullptr, table_->rowCount()).arg(awaited));
}

void ToRatePage::note_handed_in(const std::string& attempt_id) {
    for (RatableAttempt& one : all_) {
        if (one.attempt_id != attempt_id) continue;
        ++one.handed_in;
        ++one.own_handed_in;
        one.own_draft = one.blind = false;  // name and score are shown from then on
    }
    fill();
}

void ToRatePage::note_voided(const std::string& attempt_id) {
    all_.erase(std::remove_if(all_.begin(), all_.end(),
                              [&](const RatableAttempt& one) { return one.attempt_id == attempt_id; }),
               all_.end());
    fill();
}

void ToRatePage::open_row(int row) {
    if (row < 0 || row >= table_->rowCount()) return;
    const RatableAttempt& one = attempts_[static_cast<std::size_t>(row)];
    const QString id = text(one.attempt_id);
    if (one.blind) {
        emit context().rating_wanted(id);
    } else {
        emit context().debrief_wanted(id, -1);
    }
}

}  // namespace fulcrum::ui

#include "moc_to_rate_page.cpp"
