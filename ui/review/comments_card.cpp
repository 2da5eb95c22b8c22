// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/comments_card.h"

#include <QPlainTextEdit>

#include "database/records/reviews.h"
#include "ui/review/error_review_bar.h"
#include "ui/style/kept_focus.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

CommentsCard::CommentsCard(Context& context, QWidget* parent) : QFrame(parent), context_(context) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 14, 18, 14);
    title_ = make_label(tr("Comments"), "heading");
    layout->addWidget(title_);
    list_ = new QVBoxLayout;
    layout->addLayout(list_);
    composer_ = new QWidget;
    auto* compose = new QVBoxLayout(composer_);
    compose->setContentsMargins(0, 6, 0, 0);
    text_ = new QPlainTextEdit;
    text_->setObjectName(QStringLiteral("comment_text"));
    text_->setAccessibleName(tr("Comment"));
    text_->setPlaceholderText(tr("What happens here, and one thing to try"));
    text_->setTabChangesFocus(true);
    text_->setMaximumHeight(with_text(84));
    compose->addWidget(text_);
    auto* row = new QHBoxLayout;
    send_ = make_button({}, "comment_send", "primary");
    draft_ = make_button(tr("Keep as draft"), "comment_draft");
    row->addWidget(send_);
    row->addWidget(draft_);
    row->addStretch();
    compose->addLayout(row);
    layout->addWidget(composer_);
    layout->addStretch();
    connect(send_, &QPushButton::clicked, this, [this] { write(true); });
    connect(draft_, &QPushButton::clicked, this, [this] { write(false); });
    set_moment(0);
}

void CommentsCard::open(const std::string& attempt_id, const std::string& person_id) {
    attempt_id_ = attempt_id;
    person_id_ = person_id;
    text_->clear();
    composer_->setVisible(
        context_.allowed(database::Operation::comment, database::Subject::person(person_id)));
    fill();
}

void CommentsCard::set_moment(double time) {
    moment_ = time;
    send_->setText(tr("Comment at %1").arg(clock_text(time)));
}

/// Not on to the button that sends or deletes the next draft.
void CommentsCard::leave_line() {
    if (text_->isVisible()) text_->setFocus();
}

void CommentsCard::fill() {
    const KeptFocus focus(this, text_);
    clear_layout(list_);
    std::vector<database::Comment> comments;
    context_.guarded(
        [&] { comments = database::Reviews(context_.store()).comments(context_.session(), attempt_id_); });
    title_->setText(comments.empty() ? tr("Comments") : tr("Comments (%1)").arg(comments.size()));
    if (comments.empty() && composer_->isHidden())
        list_->addWidget(make_label(tr("No comments yet."), "muted"));
    const bool own = context_.session().person_id() == person_id_;
    for (const database::Comment& comment : comments) {
        const bool draft = comment.sent == 0;
        QString head = tr("%1 · %2").arg(clock_text(comment.time_s), text(comment.author_name));
        const bool reason = database::is_begun_reason(comment);
        if (draft)
            head += reason ? tr(" · reason for an error, not given yet, visible only to you")
                           : tr(" · draft, visible only to you");
        if (!draft && own && comment.read == 0) head += tr(" · new");
        QPushButton* jump = make_button(head, "comment_moment", "link");
        connect(jump, &QPushButton::clicked, this, [this, time = comment.time_s] { emit time_chosen(time); });
        list_->addWidget(jump, 0, Qt::AlignLeft);
        QLabel* words =
            make_label(text(reason ? database::begun_reason_mark + begun_words(comment) : comment.text));
        words->setObjectName(QStringLiteral("comment_words"));
        words->setContentsMargins(6, 0, 0, 6);
        list_->addWidget(words);
        if (draft && comment.author_id == context_.session().person_id()) {
            auto* row = new QHBoxLayout;
            QPushButton* send = make_button(tr("Send"), "draft_send");
            send->setHidden(reason);  // it is given with the error
            QPushButton* remove = make_button(tr("Delete"), "draft_delete");
            connect(send, &QPushButton::clicked, this, [this, id = comment.id] {
                context_.guarded([&] { database::Reviews(context_.store()).send(context_.session(), id); });
                fill();
                leave_line();
            });
            connect(remove, &QPushButton::clicked, this, [this, id = comment.id] {
                if (context_.guarded(
                        [&] { database::Reviews(context_.store()).delete_draft(context_.session(), id); }))
                    emit draft_deleted(id);
                fill();
                leave_line();
            });
            row->addWidget(send);
            row->addWidget(remove);
            row->addStretch();
            list_->addLayout(row);
        }
        // Shown is read.
        if (own && !draft && comment.read == 0 &&
            context_.allowed(database::Operation::mark_comment_read,
                             database::Subject::person(context_.session().person_id()))) {
            context_.guarded(
                [&] { database::Reviews(context_.store()).mark_read(context_.session(), comment.id); });
        }
    }
}

void CommentsCard::keep_unsent() {
    if (attempt_id_.empty() || composer_->isHidden() || !context_.signed_in() ||
        text_->toPlainText().trimmed().isEmpty())
        return;
    write(false);
    // Where the store refuses it the problem is shown, and the words stay as long as the page does.
    if (text_->toPlainText().isEmpty())
        context_.say(tr("Your comment was kept as a draft of %1.").arg(clock_text(moment_)));
}

void CommentsCard::write(bool send) {
    const std::string words = plain(text_->toPlainText().trimmed());
    if (words.empty()) {
        text_->setFocus();
        return;
    }
    if (context_.guarded([&] {
            database::Reviews(context_.store()).write(context_.session(), attempt_id_, moment_, words, send);
        })) {
        text_->clear();
    }
    fill();
}

}  // namespace fulcrum::ui

#include "moc_comments_card.cpp"
