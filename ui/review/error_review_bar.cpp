// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/error_review_bar.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "sim_core/telemetry/event_errors.h"
#include "ui/review/attempt_model.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

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

void ErrorReviewBar::open(const std::string& attempt_id, const std::string& person_id) {
    attempt_id_ = attempt_id;
    reason_->clear();
    clear();
    setVisible(context_.allowed(database::Operation::review_error, database::Subject::person(person_id)));
}

void ErrorReviewBar::clear() {
    event_.reset();
    chosen_->setText(tr("Choose an error in the list to confirm or strike it."));
    confirm_->setEnabled(false);
    strike_->setEnabled(false);
}

void ErrorReviewBar::choose(const EventLine& line) {
    if (!is_error(line.event.kind)) {
        clear();
        return;
    }
    event_ = line.event;
    chosen_->setText(tr("Chosen: %1, %2").arg(clock_text(line.time), line.words));
    confirm_->setEnabled(true);
    strike_->setEnabled(true);
}

void ErrorReviewBar::add(database::ErrorVerdict verdict) {
    const std::string reason = plain(reason_->text().trimmed());
    if (!event_) return;
    if (reason.empty()) {
        chosen_->setText(tr("Give a reason first: the trainee reads it."));
        reason_->setFocus();
        return;
    }
    if (!context_.guarded([&] {
            database::ErrorReviews(context_.store())
                .add(context_.session(), attempt_id_, *event_, verdict, reason);
        }))
        return;  // the words stay
    reason_->clear();
    reason_->setFocus();  // a button that is disabled would hand it on to another card
    clear();
    emit reviewed();
}

}  // namespace fulcrum::ui

#include "moc_error_review_bar.cpp"
