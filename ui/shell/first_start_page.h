// SPDX-License-Identifier: GPL-3.0-or-later
// The first screen where no programme exists: make one, join one, or look around in the demo. Also shows what
// went wrong with a store and the way on.
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
    /// A store is there but cannot be used.
    void show_trouble(const QString& problem, const QString& hint);

  signals:
    void try_again();
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
    void look_around();
    void open_demo();

    QStackedWidget* steps_;
    QLabel *trouble_ = nullptr, *problem_ = nullptr, *code_ = nullptr;
    QPushButton *again_ = nullptr, *create_ = nullptr, *continue_ = nullptr, *start_create_ = nullptr,
                *start_join_ = nullptr;
    QLineEdit *programme_ = nullptr, *name_ = nullptr, *login_ = nullptr, *password_ = nullptr,
              *repeat_ = nullptr;
    JoinForm* join_ = nullptr;
    JobBar *job_ = nullptr, *create_job_ = nullptr;
};

}  // namespace fulcrum::ui
