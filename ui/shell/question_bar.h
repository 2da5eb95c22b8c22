// SPDX-License-Identifier: GPL-3.0-or-later
// A question of the window above its pages, and above the lock: what would happen, a button that does it and
// one that leaves all as it is. Nothing happens until it is answered, and the pages stay usable.
#pragma once

#include <QFrame>
#include <QPointer>
#include <functional>

class QLabel;
class QPushButton;

namespace fulcrum::ui {

struct Question {
    QString words, yes, no;
    std::function<void()> on_yes, on_no = {};
};

class QuestionBar : public QFrame {
  public:
    /// Whether the keyboard goes to the button that leaves all as it is, and back to where it was afterwards.
    enum class Keyboard { stays, comes };
    QuestionBar();
    /// An earlier question is taken back.
    void ask(const Question& question, Keyboard keyboard);
    /// As if it had been answered with no; nothing where there is none.
    void take_back();

  private:
    void answer(bool yes);
    Question question_;
    QPointer<QWidget> used_;  ///< had the keyboard before
    QLabel* words_;
    QPushButton *yes_, *no_;
};

}  // namespace fulcrum::ui
