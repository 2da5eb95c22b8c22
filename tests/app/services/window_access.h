// SPDX-License-Identifier: GPL-3.0-or-later
// The window of a programme in which everyone has an attempt, for tests of the access table.
#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <set>

#include "app/services/application.h"
#include "tests/app/access_programme.h"
#include "tests/app/services/places.h"
#include "tests/ui/hands.h"
#include "ui/shell/main_window.h"

namespace fulcrum::app::program_test {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

inline constexpr Role people_roles[] = {Role::trainee, Role::educator, Role::director, Role::administrator};

class WindowAccess : public ::testing::Test {
  protected:
    WindowAccess() {
        programme.store.reset();
        services = make_services(programme.folder.path().toStdString());
        window = std::make_unique<MainWindow>(*services);
        window->resize(1280, 800);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
    }
    ~WindowAccess() override {
        if (window->context().signed_in()) window->context().sign_out();
    }
    /// Handles pending events: widgets appear and disappear in the next turn of the event loop.
    static void settle() {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void act_as(const Session& session) {
        window->context().set_session(session);
        settle();
    }
    bool allowed(Operation operation, const Target& target) const {
        return expected_allowed(operation, role(), programme.relation(role(), target));
    }
    bool cohort_allowed(Operation operation, const Target& target) const {
        return expected_allowed(operation, role(), AccessProgramme::cohort_relation(role(), target));
    }
    bool allowed_at_all(Operation operation) const {
        return expected_scope(operation, role()) != Scope::none;
    }
    Role role() const { return window->context().session().role(); }
    QString complaint() { return find<QLabel>(*window, "message_text")->text(); }
    bool refused() { return sees(*window, "message_text") && complaint().startsWith("You may not"); }
    static bool offers(const QComboBox* box, const std::string& id) {
        return box->findData(QString::fromStdString(id)) >= 0;
    }
    template <typename P>
    P* page(const char* button) {
        click(*window, button);
        return static_cast<P*>(window->current_page());
    }
    void look_everywhere(std::set<std::string>& seen);
    /// An attempt of Ann's whose program ended; found when the window opens the store next.
    void record_interrupted() {
        {
            Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                              programme.clock.options());
            Programme::append_second(recorder);
            recorder.flush();
        }
        window->start();
        settle();
    }
    void expect_debrief(const Target& target, const std::string& cell);
    void expect_progress(const Target& target, const std::string& cell, const QString& folder);

    AccessProgramme programme;
    std::unique_ptr<ApplicationServices> services;
    std::unique_ptr<MainWindow> window;
};

}  // namespace fulcrum::app::program_test
