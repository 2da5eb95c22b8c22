// SPDX-License-Identifier: GPL-3.0-or-later
// The comments on an attempt: each at a moment; educators write (drafts stay theirs until sent), the trainee
// reads.
#pragma once

#include <QFrame>
#include <string>

#include "ui/page/context.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QVBoxLayout;

namespace fulcrum::ui {

class CommentsCard : public QFrame {
    Q_OBJECT
  public:
    explicit CommentsCard(Context& context, QWidget* parent = nullptr);
    /// `person_id`: whose attempt it is.
    void open(const std::string& attempt_id, const std::string& person_id);
    /// Where the next comment goes.
    void set_moment(double time);
    /// What was typed and not sent becomes a draft of its author.
    void keep_unsent();
    /// Reads the comments again; what is being typed stays.
    void refresh() { fill(); }

  signals:
    void time_chosen(double time);
    void draft_deleted(const std::string& id);

  private:
    void fill();
    void leave_line();
    void write(bool send);
    Context& context_;
    std::string attempt_id_, person_id_;
    double moment_ = 0;
    QVBoxLayout* list_;
    QWidget* composer_;
    QPlainTextEdit* text_;
    QPushButton *send_, *draft_;
    QLabel* title_;
};

}  // namespace fulcrum::ui
