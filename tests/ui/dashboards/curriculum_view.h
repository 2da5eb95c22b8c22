// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the curriculum in a window, for its tests.
#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSlider>
#include <QTableWidget>
#include <functional>
#include <optional>

#include "database/records/people.h"
#include "tests/database/large_programme.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/dashboards/curriculum_page.h"
#include "ui/dashboards/pass_rule_chart.h"
#include "ui/shell/main_window.h"

namespace fulcrum::ui::window_test {

class CurriculumView : public ::testing::Test {
  protected:
    CurriculumView() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const auto programme = database::test::make_large_programme(*services.store(), 3, 2, 1, 7);
        window.resize(1024, 740);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        window.context().set_session(programme.director);
        open_page();
    }
    ~CurriculumView() override { apply_theme(*qApp, Theme::light); }
    void keep(const QString& name) {
        QCoreApplication::processEvents();
        if (!qEnvironmentVariableIsSet("FULCRUM_PICTURES")) return;
        window.grab().save(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES")) + "/" + name + ".png");
    }
    database::Session make_educator(const char* login, const char* name) {
        const database::People people(*services.store());
        const database::Session administrator = people.sign_in("administrator", "correct horse battery");
        const auto made = people.create(administrator, login, name, {database::Role::educator});
        const database::Session once = people.sign_in(login, made.one_time_password);
        return people.change_password(once, made.one_time_password, "a long password");
    }
    /// Signs out whoever is signed in, and opens the page for another session.
    void open_as(const database::Session& session) {
        window.context().sign_out();
        window.context().set_session(session);
        open_page();
    }
    void open_page() {
        click(window, "rail_curriculum");
        tasks = find<QListWidget>(window, "curriculum_tasks");
        table = window.current_page()->findChild<QTableWidget*>("rule_table");
        chart = window.current_page()->findChild<PassRuleChart*>("pass_rule_chart");
    }
    void be_educator() { open_as(make_educator("ed", "Ed Educator")); }
    CurriculumPage& page() { return *static_cast<CurriculumPage*>(window.current_page()); }
    /// Another educator publishes at the same time, in another window.
    void publish_elsewhere(const std::function<void(Curriculum&)>& change) {
        if (!colleague) colleague = make_educator("eve", "Eve Educator");
        services.publish_elsewhere(*colleague, change);
    }
    QString message() { return find<QLabel>(window, "message_text")->text(); }
    void choose(const char* task) {
        for (int row = 0; row < tasks->count(); ++row) {
            if (tasks->item(row)->data(Qt::UserRole).toString() != task) continue;
            tasks->setFocus();
            while (tasks->currentRow() != row)
                QTest::keyClick(tasks, tasks->currentRow() < row ? Qt::Key_Down : Qt::Key_Up);
        }
    }
    void step(const char* slider, int times, Qt::Key key) {
        auto* dial = find<QSlider>(window, slider);
        dial->setFocus();
        for (int i = 0; i < times; ++i) QTest::keyClick(dial, key);
    }
    const PassRule& rule_of(const char* task) { return services.curriculum().find(task)->rule; }

    FakeServices services;
    MainWindow window{services};
    std::optional<database::Session> colleague;
    QListWidget* tasks = nullptr;
    QTableWidget* table = nullptr;
    PassRuleChart* chart = nullptr;
};

}  // namespace fulcrum::ui::window_test
