// SPDX-License-Identifier: GPL-3.0-or-later
// An observer form while it is filled in: its items, the total so far, notes. Every answer is kept as a draft
// at once, notes after a short pause.
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "database/records/ratings.h"
#include "ui/page/context.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class ItemChoice;

class RatingEditor : public QWidget {
    Q_OBJECT
  public:
    explicit RatingEditor(Context& context, QWidget* parent = nullptr);
    /// A draft of who is signed in; without one the editor hides.
    void open(const std::optional<database::RatingRow>& draft);
    /// Keeps what was typed, also when its rater has just signed out.
    void keep();
    void focus_first();

  signals:
    void handed_in();
    void discarded();

  private:
    void build_items();
    void show_total();
    FormAnswers answers() const;
    std::vector<bool> answered() const;
    void hand_in();
    void discard();

    Context& context_;
    std::optional<database::RatingRow> draft_;
    std::optional<database::Session> rater_;
    bool kept_ = true;
    QTimer pause_;
    QLabel *title_, *legend_, *total_;
    QVBoxLayout* list_;
    std::vector<ItemChoice*> items_;
    QPlainTextEdit* remark_;
    QPushButton *hand_in_, *discard_, *discard_sure_;
};

}  // namespace fulcrum::ui
