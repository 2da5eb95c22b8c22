// SPDX-License-Identifier: GPL-3.0-or-later
// The first screen where no programme exists: make one, join one, restore one, or look around in the demo.
#pragma once

#include "ui/page/context.h"

class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace fulcrum::ui {

class JobBar;
class JoinForm;

class FirstStartPage : public Page {
    Q_OBJECT
  public:
    explicit FirstStartPage(Context& context);
    void enter() override;
    /// A sign-out leaves this page as it is.
    QStringList begun_input(Ending ending) const override;
    /// There is a programme: what was typed to create or join one is for nothing.
    void forget_input();
    void look_around();

  signals:
    void restore_wanted();
    void programme_created();
    /// The programme of a server is here.
    void programme_joined();
    /// The demo store is the current one.
    void demo_opened();

  private:
    QWidget* build_choice();
    QWidget* build_form();
    QFrame* build_join();
    QWidget* build_recovery();
    void create();
    void open_demo();

    QStackedWidget* steps_;
    QLabel *problem_ = nullptr, *code_ = nullptr;
    QPushButton *create_ = nullptr, *back_ = nullptr, *continue_ = nullptr, *start_create_ = nullptr,
                *start_join_ = nullptr;
    QLineEdit *programme_ = nullptr, *name_ = nullptr, *login_ = nullptr, *password_ = nullptr,
              *repeat_ = nullptr;
    JoinForm* join_ = nullptr;
    JobBar *job_ = nullptr, *create_job_ = nullptr;
};

}  // namespace fulcrum::ui
