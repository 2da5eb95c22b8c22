// SPDX-License-Identifier: GPL-3.0-or-later
// The window on a programme with one person of each role, a cohort and one attempt, for tests that look at
// every screen.
#pragma once

#include <gtest/gtest.h>

#include <QLabel>
#include <map>
#include <memory>

#include "database/access/access.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/language/language.h"
#include "ui/shell/main_window.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {

using database::Role;

class Screens : public ::testing::Test {
  protected:
    Screens();
    ~Screens() override;

    void open(QSize size);
    /// For the window that is opened next. Each of the three would make all pages of an open one again.
    void close_and_look(Theme theme, Language language, int percent) {
        window.reset();
        apply_theme(*qApp, theme);
        use_language(language);
        apply_text_size(*qApp, percent);
    }
    void sign_in(Role role) {
        window->context().set_session(sessions.at(role));
        settle();
    }
    /// Handles what is due, and waits for the work that the page does in the background.
    void settle();
    /// Names of the rail's pages for the role.
    std::vector<const char*> rail();
    void go_to(const char* name) {
        choose_page(*window, name);
        settle();
    }
    /// Without waiting for what the page reads in the background.
    void go_to_now(const char* name) {
        choose_page(*window, name);
        QCoreApplication::processEvents();
    }
    /// The trainee's attempt A2, by mouse, with too much force; its id.
    std::string perform();
    void wait_for_debrief();
    QString error_shown();
    /// The page has the space that it needs, and the window has kept its size.
    void expect_fits(const QString& screen);
    /// No visible text has less room than it needs; how many there are. `within`: of this widget alone.
    int expect_whole(const QString& screen, QWidget* within = nullptr);
    /// Shows each other tab of the page's tabs, calls `look` and comes back to the one that was there.
    void each_tab(const QString& screen, const std::function<void(const QString&)>& look);
    /// Stores a picture in the folder FULCRUM_PICTURES.
    void keep(const QString& screen);
    /// With the name of what is shown.
    using Look = std::function<void(const QString&)>;
    /// Opens every screen of every role, and those that come before a sign-in, and calls `look`. What is the
    /// same for every role is opened for one.
    void visit(const std::string& attempt, const Look& look);
    /// Two hands of a device that gives force, with workspaces: in use, and read once it is opened.
    void use_touch();
    /// Calls `look` in a practice run that is drawn, and goes home.
    void theatre(const std::function<void()>& look);

  private:
    // Of visit(), in screens_states.cpp.
    /// The settings while a device is tried and while it is calibrated.
    void visit_device(const QString& who, const Look& look);
    /// Over the page that is shown; the trainee unlocks it.
    void visit_lock(const Look& look);
    /// In a practice run: while it runs, paused, with a device that is lost, and that is back.
    void visit_theatre(const QString& screen, const Look& look);
    /// An observer form on the debrief that is shown.
    void visit_rating(const QString& screen, const Look& look);
    /// With a store that is damaged, and with none.
    void visit_first_pages(const Look& look);

  protected:
    FakeServices services;
    std::map<Role, database::Session> sessions;
    std::unique_ptr<MainWindow> window;
    QSize size_;
};

}  // namespace fulcrum::ui::window_test
