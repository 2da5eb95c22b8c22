// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/ratings_card.h"

#include <QComboBox>
#include <algorithm>
#include <map>
#include <set>

#include "assessment/assets/assets.h"
#include "ui/page/background_job.h"
#include "ui/reports/rating_words.h"
#include "ui/review/rating_editor.h"
#include "ui/review/rating_profile.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

using database::Operation;
using database::RatingRow;

RatingsCard::RatingsCard(Context& context, QWidget* parent) : QFrame(parent), context_(context) {
    setObjectName(QStringLiteral("ratings_card"));
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 14, 18, 14);
    title_ = make_label({}, "heading");
    layout->addWidget(title_);
    hidden_ = make_label({}, "muted");
    hidden_->setObjectName(QStringLiteral("ratings_hidden"));
    layout->addWidget(hidden_);
    reveal_ = make_button({}, "ratings_reveal", "link");
    connect(reveal_, &QPushButton::clicked, this, [this] {
        revealed_ = true;
        fill();
    });
    layout->addWidget(reveal_, 0, Qt::AlignLeft);
    list_ = new QVBoxLayout;
    layout->addLayout(list_);
    agreement_ = make_label({}, "muted");
    agreement_->setObjectName(QStringLiteral("rating_agreement"));
    layout->addWidget(agreement_);
    release_ = make_button(tr("Show the ratings to the trainee"), "ratings_release");
    connect(release_, &QPushButton::clicked, this, &RatingsCard::release);
    layout->addWidget(release_, 0, Qt::AlignLeft);
    build_begin();
    layout->addWidget(begin_row_);
    editor_ = new RatingEditor(context);
    layout->addWidget(editor_);
    connect(editor_, &RatingEditor::handed_in, this, [this] {
        context_.say(tr("The rating is handed in."));
        emit context_.rating_handed_in(text(attempt_.meta.id));
        emit handed_in();
    });
    connect(editor_, &RatingEditor::discarded, this, [this] {
        fill();
        begin_->setFocus();
    });
}

void RatingsCard::build_begin() {
    begin_row_ = new QWidget;
    auto* row = new FlowRow(begin_row_);
    form_ = new QComboBox;
    form_->setObjectName(QStringLiteral("rating_form"));
    form_->setAccessibleName(tr("Observer form"));
    form_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    row->add(form_);
    begin_ = make_button(tr("Rate with this form"), "rating_begin", "primary");
    connect(begin_, &QPushButton::clicked, this, &RatingsCard::begin);
    row->add(begin_);
}

void RatingsCard::open(const database::AttemptSummary& attempt, bool blind) {
    leave();
    attempt_ = attempt;
    blind_ = blind;
    revealed_ = false;
    fill();
}

void RatingsCard::keep() {
    editor_->keep();
}

void RatingsCard::leave() {
    keep();
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
}

int RatingsCard::hold_back(Rows& rows, bool may_rate) const {
    const std::string& self = context_.session().person_id();
    const bool rated = std::any_of(rows.begin(), rows.end(), [&](const RatingRow& row) {
        return row.rater_id == self && row.handed_in > 0;
    });
    if (!may_rate || rated || revealed_) return 0;
    const auto end = std::remove_if(rows.begin(), rows.end(), [&](const RatingRow& row) {
        return row.rater_id != self && (row.form.blind || blind_);
    });
    const auto held = static_cast<int>(rows.end() - end);
    rows.erase(end, rows.end());
    return held;
}

void RatingsCard::fill() {
    clear_layout(list_);
    agreement_->hide();
    database::AttemptRatings ratings;
    context_.guarded([&] {
        ratings = database::Ratings(context_.store()).of_attempt(context_.session(), attempt_.meta.id);
    });
    const database::Subject subject = database::Subject::person(attempt_.meta.person_id);
    const bool may_rate = attempt_.state != AttemptState::voided && attempt_.state != AttemptState::running &&
                          context_.allowed(Operation::rate, subject);
    const int held = hold_back(ratings.rows, may_rate);
    Rows shown, own;
    std::optional<RatingRow> draft;
    for (RatingRow& row : ratings.rows) {
        if (row.rater_id == context_.session().person_id()) own.push_back(row);
        if (row.handed_in == 0) {
            draft = row;
        } else {
            shown.push_back(row);
        }
    }
    const bool trainee = context_.session().role() == database::Role::trainee;
    const int hidden = trainee ? 0 : ratings.hidden + held;
    setVisible(may_rate || !shown.empty() || hidden > 0);
    title_->setText(shown.empty() ? tr("Ratings") : tr("Ratings (%1)").arg(shown.size()));
    hidden_->setText(
        may_rate ? tr("Ratings by others: %1. You will see them when you have handed in yours.").arg(hidden)
                 : tr("Ratings that are not shown to you: %1.").arg(hidden));
    hidden_->setVisible(hidden > 0);
    reveal_->setText(tr("Show those that the trainee sees, without rating (%1)").arg(held));
    reveal_->setAccessibleName(reveal_->text());
    reveal_->setVisible(held > 0 && !draft && !blind_);
    std::map<std::string, Rows> by_form;
    for (const RatingRow& row : shown) by_form[row.form.name()].push_back(row);
    for (const auto& [name, rows] : by_form) show_form(rows);
    const bool unreleased =
        std::any_of(shown.begin(), shown.end(), [](const RatingRow& row) { return row.released == 0; });
    release_->setVisible(unreleased && !draft && context_.allowed(Operation::release_ratings, subject));
    begin_row_->setVisible(false);
    if (may_rate && !draft) offer_forms(own);
    editor_->open(may_rate ? draft : std::nullopt);
    if (may_rate && !shown.empty() && !draft) ask_agreement(shown);
}

void RatingsCard::show_form(const Rows& rows) {
    list_->addWidget(make_label(form_text(rows.front().form.title)));
    std::vector<RatingLine> lines;
    std::vector<FormAnswers> answers;
    for (const RatingRow& row : rows) {
        lines.push_back({text(row.rater_name), static_cast<int>(lines.size()), row.answers});
        answers.push_back(row.answers);
    }
    list_->addWidget(new RatingProfile(rows.front().form, std::move(lines)));
    for (std::size_t i = 0; i < rows.size(); ++i) show_row(rows[i], static_cast<int>(i));
    const QString spread = rating_spread_text(rows.front().form, answers);
    if (spread.isEmpty()) return;
    QLabel* line = make_label(spread);
    line->setObjectName(QStringLiteral("rating_spread"));
    list_->addWidget(line);
}

void RatingsCard::show_row(const RatingRow& row, int mark) {
    const bool trainee = context_.session().role() == database::Role::trainee;
    QString seen;
    if (!trainee) seen = row.released > 0 ? tr("shown to the trainee") : tr("not shown to the trainee");
    auto* line = new QHBoxLayout;
    line->addWidget(new RaterMark(mark), 0, Qt::AlignTop);
    QLabel* words =
        make_label(join_with_dots({text(row.rater_name), rating_sum_text(row.form, row.answers),
                                   local_time(row.handed_in), blinding_text(row.blinding), seen}));
    words->setObjectName(QStringLiteral("rating_shown"));
    line->addWidget(words, 1);
    list_->addLayout(line);
    if (row.remark.empty()) return;
    QLabel* remark = make_label(text(row.remark));
    remark->setObjectName(QStringLiteral("rating_shown_remark"));
    remark->setContentsMargins(26, 0, 0, 6);
    list_->addWidget(remark);
}

void RatingsCard::offer_forms(const Rows& own) {
    forms_.clear();
    context_.guarded([&] { forms_ = newest_forms(load_forms(asset_path("forms"))); });
    const auto used = [&](const ObserverForm& form) {
        return std::any_of(own.begin(), own.end(),
                           [&](const RatingRow& row) { return row.form.id == form.id; });
    };
    forms_.erase(std::remove_if(forms_.begin(), forms_.end(), used), forms_.end());
    form_->clear();
    for (const ObserverForm& form : forms_) form_->addItem(form_text(form.title), text(form.id));
    form_->setCurrentIndex(std::max(0, form_->findData(QStringLiteral("goals"))));
    begin_row_->setVisible(!forms_.empty());
}

void RatingsCard::begin() {
    const int chosen = form_->currentIndex();
    if (chosen < 0) return;
    if (context_.guarded([&] {
            database::Ratings(context_.store())
                .begin(context_.session(), attempt_.meta.id, forms_[static_cast<std::size_t>(chosen)]);
        })) {
        fill();
        editor_->focus_first();
    }
}

void RatingsCard::release() {
    int released = 0;
    if (context_.guarded([&] {
            released = database::Ratings(context_.store()).release(context_.session(), attempt_.meta.id);
        }))
        context_.say(tr("Ratings that the trainee sees from now on: %1.").arg(released));
    fill();
}

void RatingsCard::ask_agreement(const Rows& shown) {
    if (job_ != nullptr) job_->cancel();
    std::set<std::string> forms;
    for (const RatingRow& row : shown) forms.insert(row.form.name());
    auto found = std::make_shared<std::vector<database::FormAgreement>>();
    job_ = BackgroundJob::run(
        this,
        [found, path = context_.store().path(), session = context_.session()](const Progress&) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(path, options);
            *found = database::Ratings(store).agreement(session);
        },
        [this, found, forms] {
            job_ = nullptr;
            QStringList lines;
            for (const database::FormAgreement& one : *found)
                if (forms.count(one.form) > 0) lines << rater_agreement_text(one);
            agreement_->setText(lines.join(QLatin1Char('\n')));
            agreement_->setVisible(!lines.isEmpty());
        },
        [this](const QString& why) {
            job_ = nullptr;
            context_.complain(why);
        });
}

}  // namespace fulcrum::ui

#include "moc_ratings_card.cpp"
