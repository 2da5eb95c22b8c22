// SPDX-License-Identifier: GPL-3.0-or-later
// The first screen of a further station: address and token of the programme server, then its people come.
#pragma once

#include "ui/page/context.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

class JobBar;

class JoinForm : public QWidget {
    Q_OBJECT
  public:
    explicit JoinForm(Context& context);
    void begin();

  signals:
    void back();
    /// The store has the programme's people.
    void joined();

  private:
    void join();
    void update_button();

    Context& context_;
    QLineEdit *address_ = nullptr, *token_ = nullptr;
    QPushButton* join_ = nullptr;
    QLabel* problem_ = nullptr;
    JobBar* bar_ = nullptr;
    bool busy_ = false;
};

}  // namespace fulcrum::ui
