// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/error_review_bar.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "database/records/reviews.h"
#include "sim_core/telemetry/event_types.h"
#include "ui/review/attempt_model.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr std::size_t begun_mark_size = sizeof(database::begun_reason_mark) - 1;

/// What a reason that was begun begins with: the mark, what names the error, the mark. Several errors can be
/// of one moment.
std::string begin_of_draft(const Event& error) {
    std::string begin = database::begun_reason_mark;
    for (const std::int64_t number :
         {static_cast<std::int64_t>(error.kind), std::int64_t{error.tick}, std::int64_t{error.hand},
          std::int64_t{error.tissue}, std::int64_t{error.detail}})
        begin += std::to_string(number) + " ";
    return begin + database::begun_reason_mark;
}

}  // namespace

std::string begun_words(const database::Comment& draft) {
    const std::string& kept = draft.text;
    const std::size_t named = kept.find_first_not_of("0123456789- ", begun_mark_size);
    const bool names_error = named != std::string::npos && named > begun_mark_size &&
                             kept.compare(named, begun_mark_size, database::begun_reason_mark) == 0;
    return kept.substr(names_error ? named + begun_mark_size : begun_mark_size);
}

QString review_words(const database::ErrorReview& review) {
    return (review.verdict == database::ErrorVerdict::struck ? ErrorReviewBar::tr("struck by %1: %2")
                                                             : ErrorReviewBar::tr("confirmed by %1: %2"))
        .arg(text(review.author_name), text(review.reason));
}

ErrorReviewBar::ErrorReviewBar(Context& context, QWidget* parent) : QWidget(parent), context_(context) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    chosen_ = make_label({}, "muted");
    chosen_->setObjectName(QStringLiteral("review_error_chosen"));
    layout->addWidget(chosen_);
    auto* row = new FlowRow;
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("review_error_reason"));
    reason_->setAccessibleName(tr("Reason for confirming or striking the error"));
    reason_->setPlaceholderText(tr("Reason"));
    reason_->setMaxLength(1000);
    row->add(reason_, 1, with_text(120));
    confirm_ = make_button(tr("Confirm"), "review_error_confirm");
    confirm_->setAccessibleName(tr("Confirm the chosen error"));
    strike_ = make_button(tr("Strike"), "review_error_strike");
    strike_->setAccessibleName(tr("Strike the chosen error"));
    row->add(confirm_);
    row->add(strike_);
    layout->addLayout(row);
    connect(confirm_, &QPushButton::clicked, this, [this] { add(database::ErrorVerdict::confirmed); });
    connect(strike_, &QPushButton::clicked, this, [this] { add(database::ErrorVerdict::struck); });
    clear();
}

void ErrorReviewBar::open(const std::string& attempt_id, const std::string& person_id,
                          const std::vector<EventLine>& events) {
    attempt_id_ = attempt_id;
    person_id_ = person_id;
    author_id_ = context_.session().person_id();
    draft_id_.clear();
    reason_->clear();
    clear();
    forget_error();
    setVisible(may_review());
    if (!isHidden()) take_up_draft(events);
}

bool ErrorReviewBar::may_review() const {
    return context_.allowed(database::Operation::review_error, database::Subject::person(person_id_));
}

void ErrorReviewBar::take_up_draft(const std::vector<EventLine>& events) {
    std::vector<database::Comment> comments;
    if (!context_.guarded([&] {
            comments = database::Reviews(context_.store()).comments(context_.session(), attempt_id_);
        }))
        return;
    const auto draft = std::find_if(comments.begin(), comments.end(), database::is_begun_reason);
    if (draft == comments.end()) return;
    draft_id_ = draft->id;
    const std::string words = begun_words(*draft);
    about_ = draft->text.substr(0, draft->text.size() - words.size());
    time_ = draft->time_s;
    // One that names no error (an older program wrote it) is about the only error of its moment, if it is
    // one.
    const bool names_error = about_ != database::begun_reason_mark;
    std::vector<EventLine> meant;
    for (const EventLine& line : events)
        if (is_error(line.event.kind) &&
            (names_error ? begin_of_draft(line.event) == about_ : std::abs(line.time - draft->time_s) < 1e-6))
            meant.push_back(line);
    if (meant.size() == 1) choose(meant.front());
    reason_->setText(text(words));
}

const database::Comment* ErrorReviewBar::find_draft(const std::vector<database::Comment>& comments) const {
    const auto draft = std::find_if(comments.begin(), comments.end(), [this](const database::Comment& one) {
        return one.id == draft_id_ && one.sent == 0;
    });
    return draft == comments.end() ? nullptr : &*draft;
}

void ErrorReviewBar::keep_unsent() {
    if (attempt_id_.empty() || !context_.signed_in() || context_.session().person_id() != author_id_ ||
        !may_review())
        return;
    const std::string reason = plain(reason_->text().trimmed());
    if (reason.empty() && draft_id_.empty()) return;
    bool written = false;
    context_.guarded([&] {
        const database::Reviews reviews(context_.store());
        const std::vector<database::Comment> comments = reviews.comments(context_.session(), attempt_id_);
        const database::Comment* draft = find_draft(comments);
        const std::string kept = about_ + reason;
        if (reason.empty()) {
            if (draft != nullptr) reviews.delete_draft(context_.session(), draft_id_);
            draft_id_.clear();
        } else if (draft == nullptr) {
            draft_id_ = reviews.write(context_.session(), attempt_id_, time_, kept, false);
            written = true;
        } else if (draft->text != kept || draft->time_s != time_) {
            reviews.edit_draft(context_.session(), draft_id_, time_, kept);
            written = true;
        }
    });
    if (written) context_.say(tr("Your reason was kept as a draft of %1.").arg(clock_text(time_)));
}

void ErrorReviewBar::forget(const std::string& draft_id) {
    if (draft_id_ != draft_id) return;
    draft_id_.clear();
    reason_->clear();
    if (!event_) forget_error();
}

void ErrorReviewBar::forget_error() {
    about_ = database::begun_reason_mark;
    time_ = 0;
}

void ErrorReviewBar::clear() {
    event_.reset();
    chosen_->setText(tr("Choose an error in the list to confirm or strike it."));
    confirm_->setEnabled(false);
    strike_->setEnabled(false);
}

void ErrorReviewBar::choose(const EventLine& line) {
    if (!is_error(line.event.kind)) {
        clear();  // a reason that was begun stays with its error
        if (reason_->text().trimmed().isEmpty()) forget_error();
        return;
    }
    event_ = line.event;
    about_ = begin_of_draft(line.event);
    time_ = line.time;
    chosen_->setText(tr("Chosen: %1, %2").arg(clock_text(line.time), line.words));
    confirm_->setEnabled(true);
    strike_->setEnabled(true);
}

void ErrorReviewBar::add(database::ErrorVerdict verdict) {
    const std::string reason = plain(reason_->text().trimmed());
    if (!event_) return;
    if (reason.empty()) {
        announce_problem(chosen_, tr("Give a reason first: the trainee reads it."));
        reason_->setFocus();
        return;
    }
    if (!context_.guarded([&] {
            database::ErrorReviews(context_.store())
                .add(context_.session(), attempt_id_, *event_, verdict, reason);
        }))
        return;  // the words stay
    context_.guarded([&] {
        const database::Reviews reviews(context_.store());
        const auto comments = reviews.comments(context_.session(), attempt_id_);
        if (find_draft(comments) != nullptr) reviews.delete_draft(context_.session(), draft_id_);
    });
    draft_id_.clear();
    reason_->clear();
    reason_->setFocus();  // a button that is disabled would hand it on to another card
    clear();
    forget_error();
    emit reviewed();
}

}  // namespace fulcrum::ui

#include "moc_error_review_bar.cpp"
