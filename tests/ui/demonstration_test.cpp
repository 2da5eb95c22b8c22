// SPDX-License-Identifier: GPL-3.0-or-later
// The demonstration, looked at as each of its people.
#include <gtest/gtest.h>

#include <QTableWidget>

#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/main_window.h"
#include "ui/shell/page_table.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::ui::window_test {
namespace {

/// Looks around as one person of the demonstration.
class Demonstration : public ::testing::Test {
  protected:
    Demonstration() : window(services) {
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        click(window, "look_around");
        EXPECT_TRUE(wait_for([&] { return sees(window, "pick_demo_person"); }));
    }
    void pick(const char* name) {
        ASSERT_TRUE(wait_for([&] { return sees(window, "pick_demo_person"); }));
        for (QAbstractButton* button : window.findChildren<QAbstractButton*>("pick_demo_person")) {
            if (button->isVisible() && button->text().startsWith(name)) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        FAIL() << name;
    }
    bool shows_error() {
        auto* line = window.findChild<QLabel*>("message_text");
        return line->isVisible() && line->parentWidget()->property("role").toString() == "error";
    }
    FakeServices services;
    MainWindow window;
};

TEST_F(Demonstration, NoPageOfAnyRoleReportsAnError) {
    for (const char* name : {"Nova", "Iris", "Dora"}) {
        pick(name);
        ASSERT_TRUE(wait_for([&] { return window.context().signed_in(); }));
        for (const PageEntry* entry : pages_of(window.context())) {
            click(window, entry->name);
            QTest::qWait(50);
            EXPECT_FALSE(shows_error()) << name << ", " << entry->name << ": "
                                        << window.findChild<QLabel*>("message_text")->text().toStdString();
        }
        click(window, "switch_user");
    }
}

TEST_F(Demonstration, AttemptByMouseIsNotCalledSimulatedAndNamesAreMarkedOnce) {
    pick("Nova");
    ASSERT_TRUE(wait_for([&] { return sees(window, "briefing_A2"); }));
    emit window.context().attempt_wanted("A2", false, 0, false);
    auto* theatre = static_cast<TheatrePage*>(window.current_page());
    ASSERT_TRUE(wait_for([&] {
        return theatre->session() != nullptr && theatre->session()->phase() == AttemptPhase::running;
    }));
    QTest::qWait(200);
    services.control.complete = true;
    ASSERT_TRUE(wait_for([&] { return window.current_page()->objectName() == "debrief_page"; }));
    auto* debrief = static_cast<DebriefPage*>(window.current_page());
    ASSERT_TRUE(wait_for([&] { return debrief->is_ready(); }));
    const QString notes = window.findChild<QLabel*>("debrief_notes")->text();
    EXPECT_FALSE(notes.contains("simulated operator")) << notes.toStdString();
    click(window, "rail_attempts");
    int tables = 0;
    for (QTableWidget* table : window.findChildren<QTableWidget*>("attempts_table")) {
        if (!table->isVisible()) continue;
        ++tables;
        ASSERT_GT(table->rowCount(), 0);
        EXPECT_EQ(table->item(0, 0)->text().count("(synthetic)"), 1);
    }
    EXPECT_EQ(tables, 1);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
