// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/rating_editor.h"

#include <QPlainTextEdit>
#include <algorithm>

#include "ui/reports/rating_words.h"
#include "ui/review/item_choice.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int pause_ms = 600;

/// Whether one legend serves all items: each has the same scale with the same words.
bool has_one_legend(const ObserverForm& form) {
    const auto same = [&](const FormItem& item) {
        const FormItem& first = form.items.front();
        return item.lowest == first.lowest && item.highest == first.highest &&
               std::equal(item.anchors.begin(), item.anchors.end(), first.anchors.begin(),
                          first.anchors.end(), [](const FormAnchor& a, const FormAnchor& b) {
                              return a.rating == b.rating && a.text == b.text;
                          });
    };
    return form.items.size() > 1 && std::all_of(form.items.begin(), form.items.end(), same);
}

}  // namespace

RatingEditor::RatingEditor(Context& context, QWidget* parent) : QWidget(parent), context_(context) {
    setObjectName(QStringLiteral("rating_editor"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 0);
    title_ = make_label({}, "heading");
    layout->addWidget(title_);
    legend_ = make_label({}, "muted");
    legend_->setObjectName(QStringLiteral("rating_legend"));
    layout->addWidget(legend_);
    list_ = new QVBoxLayout;
    list_->setSpacing(0);
    layout->addLayout(list_);
    total_ = make_label({}, "heading");
    total_->setObjectName(QStringLiteral("rating_total"));
    layout->addWidget(total_);
    remark_ = new QPlainTextEdit;
    remark_->setObjectName(QStringLiteral("rating_remark"));
    remark_->setAccessibleName(tr("Notes on this rating"));
    remark_->setPlaceholderText(tr("Notes: what you saw, and one thing to try"));
    remark_->setTabChangesFocus(true);
    remark_->setMaximumHeight(with_text(84));
    layout->addWidget(remark_);
    auto* row = new FlowRow;
    hand_in_ = make_button(tr("Hand in the rating"), "rating_hand_in", "primary");
    discard_ = make_button(tr("Discard the draft"), "rating_discard");
    discard_sure_ = make_button(tr("Discard it for good"), "rating_discard_sure", "primary");
    for (QPushButton* button : {hand_in_, discard_, discard_sure_}) row->add(button);
    row->add(make_label(tr("The draft is saved. After you hand in a rating, it cannot be changed."), "muted"),
             1, with_text(200));
    layout->addLayout(row);
    pause_.setSingleShot(true);
    pause_.setInterval(pause_ms);
    connect(&pause_, &QTimer::timeout, this, &RatingEditor::keep);
    connect(remark_, &QPlainTextEdit::textChanged, this, [this] {
        kept_ = false;
        discard_sure_->hide();  // the draft is another one now
        pause_.start();
    });
    connect(hand_in_, &QPushButton::clicked, this, &RatingEditor::hand_in);
    ask_twice(discard_, discard_sure_);
    connect(discard_sure_, &QPushButton::clicked, this, &RatingEditor::discard);
    hide();
}

void RatingEditor::open(const std::optional<database::RatingRow>& draft) {
    draft_ = draft;
    rater_.reset();
    items_.clear();
    clear_layout(list_);
    setVisible(draft_.has_value());
    if (draft_) {
        rater_ = context_.session();
        title_->setText(form_text(draft_->form.title));
        build_items();
        remark_->setPlainText(text(draft_->remark));
        show_total();
    }
    discard_sure_->hide();
    pause_.stop();
    kept_ = true;
}

void RatingEditor::build_items() {
    const ObserverForm& form = draft_->form;
    const bool one_legend = has_one_legend(form);
    QStringList lines;
    if (one_legend)
        for (const FormAnchor& anchor : form.items.front().anchors)
            lines << QStringLiteral("%1 · %2").arg(anchor.rating).arg(form_text(anchor.text));
    legend_->setText(lines.join(QLatin1Char('\n')));
    legend_->setVisible(one_legend);
    QWidget* before = remark_->previousInFocusChain();
    while (before->focusPolicy() == Qt::NoFocus && before != remark_) before = before->previousInFocusChain();
    for (std::size_t i = 0; i < form.items.size(); ++i) {
        auto* item = new ItemChoice(form.items[i], !one_legend);
        item->set_answer(draft_->answers[i], draft_->answered[i]);
        connect(item, &ItemChoice::chosen, this, [this] {
            kept_ = false;
            discard_sure_->hide();
            keep();
            show_total();
        });
        list_->addWidget(item);
        before = item->follow(before);
        items_.push_back(item);
    }
}

void RatingEditor::show_total() {
    const std::vector<bool> done = answered();
    const auto left = std::count(done.begin(), done.end(), false);
    const QString sum = rating_sum_text(draft_->form, answers());
    total_->setText(left == 0 ? tr("Total: %1").arg(sum)
                              : tr("Total so far: %1 · items left: %2").arg(sum).arg(left));
}

FormAnswers RatingEditor::answers() const {
    FormAnswers all;
    for (const ItemChoice* item : items_) all.push_back(item->answer());
    return all;
}

std::vector<bool> RatingEditor::answered() const {
    std::vector<bool> all;
    for (const ItemChoice* item : items_) all.push_back(item->answered());
    return all;
}

void RatingEditor::keep() {
    pause_.stop();
    if (!draft_ || kept_) return;
    kept_ = true;
    context_.guarded([&] {
        database::Ratings(context_.store())
            .answer(*rater_, draft_->id, answers(), answered(), plain(remark_->toPlainText().trimmed()));
    });
}

void RatingEditor::focus_first() {
    const std::vector<bool> done = answered();
    const auto first = std::find(done.begin(), done.end(), false);
    if (first == done.end()) {
        hand_in_->setFocus();
    } else {
        items_[static_cast<std::size_t>(first - done.begin())]->focus_scale();
    }
}

void RatingEditor::hand_in() {
    keep();
    if (const auto left = first_unanswered(draft_->form, answers(), answered())) {
        context_.complain(tr("Not rated yet: %1.").arg(form_text(draft_->form.items[*left].title)));
        items_[*left]->focus_scale();
        return;
    }
    if (context_.guarded([&] { database::Ratings(context_.store()).hand_in(*rater_, draft_->id); })) {
        draft_.reset();
        emit handed_in();
    }
}

void RatingEditor::discard() {
    if (context_.guarded([&] { database::Ratings(context_.store()).discard(*rater_, draft_->id); })) {
        draft_.reset();
        emit discarded();
    } else {
        discard_->setFocus();
        discard_sure_->hide();
    }
}

}  // namespace fulcrum::ui

#include "moc_rating_editor.cpp"
