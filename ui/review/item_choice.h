// SPDX-License-Identifier: GPL-3.0-or-later
// One item of an observer form: its scale as a row of choices, and under it what they mean. Arrow keys move
// along the scale, a digit chooses, a click on the words chooses too.
#pragma once

#include <QWidget>
#include <optional>

#include "assessment/forms/observer_form.h"

class QButtonGroup;
class QGridLayout;

namespace fulcrum::ui {

class ItemChoice : public QWidget {
    Q_OBJECT
  public:
    /// `with_anchors`: without them where one legend serves all items of a form.
    ItemChoice(const FormItem& item, bool with_anchors, QWidget* parent = nullptr);
    /// `answered` without an answer: not seen.
    void set_answer(const std::optional<int>& answer, bool answered);
    std::optional<int> answer() const;
    bool answered() const;
    /// To the chosen point of the scale, or its first.
    void focus_scale();
    /// Puts its points behind a widget in the tabulator's order; returns the last.
    QWidget* follow(QWidget* before);

  signals:
    void chosen();

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void add_point(QGridLayout* grid, int number, int id, const QString& shown, const QString& meaning);
    QWidget* build_anchors();
    FormItem item_;
    QButtonGroup* group_;
};

}  // namespace fulcrum::ui
