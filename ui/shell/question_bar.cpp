// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/question_bar.h"

#include <QShortcut>
#include <utility>

#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

QuestionBar::QuestionBar() {
    setObjectName(QStringLiteral("question"));
    setProperty("role", "message");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(18, 8, 18, 8);
    column->setSpacing(6);
    words_ = make_label({});
    words_->setObjectName(QStringLiteral("question_words"));
    column->addWidget(words_);
    auto* row = new FlowRow;
    no_ = make_button({}, "question_no");
    yes_ = make_button({}, "question_yes", "primary");
    row->add(no_);
    row->add(yes_);
    column->addLayout(row);
    connect(no_, &QPushButton::clicked, this, [this] { answer(false); });
    connect(yes_, &QPushButton::clicked, this, [this] { answer(true); });
    auto* back = new QShortcut(Qt::Key_Escape, this, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
    connect(back, &QShortcut::activated, this, [this] { answer(false); });
    hide();
}

void QuestionBar::ask(const Question& question, Keyboard keyboard) {
    take_back();
    question_ = question;
    words_->setText(question.words);
    yes_->setText(button_text(question.yes));
    no_->setText(button_text(question.no));
    used_ = window()->focusWidget();
    show();
    if (keyboard == Keyboard::comes) no_->setFocus();
    announce(this, question.words);
}

void QuestionBar::take_back() {
    if (!isHidden()) answer(false);
}

// What follows may ask the next question, or end the window.
void QuestionBar::answer(bool yes) {
    const Question question = std::exchange(question_, {});
    QWidget* const focused = window()->focusWidget();
    if (focused != nullptr && isAncestorOf(focused) && used_ != nullptr) used_->setFocus();
    hide();
    const std::function<void()>& then = yes ? question.on_yes : question.on_no;
    if (then) then();
}

}  // namespace fulcrum::ui
