// SPDX-License-Identifier: GPL-3.0-or-later
// The page *Rate* while it is read: what was rated or voided here a moment ago is not offered again.
#include <QCheckBox>
#include <QPushButton>
#include <QTableWidget>

#include "database/rows/connection.h"
#include "tests/ui/held_work.h"
#include "tests/ui/screens.h"

namespace fulcrum::ui::window_test {
namespace {

class ToRate : public Screens {
  protected:
    /// The educator's list, with the trainee's attempt.
    void open_list() {
        open({1280, 800});
        ASSERT_TRUE(become_active(*window));
        attempt = perform();
        sign_in(Role::educator);
        go_to("rail_rate");
        ASSERT_EQ(rows(), 1);
    }
    int rows() { return find<QTableWidget>(*window, "to_rate_table")->rowCount(); }
    std::string attempt;
};

TEST_F(ToRate, AnAttemptThatWasRatedIsGoneAtOnce) {
    open_list();
    click(*window, "to_rate_open");
    wait_for_debrief();
    find<QPushButton>(*window, "rating_begin")->setFocus();
    QTest::keyClick(window->focusWidget(), Qt::Key_Return);
    QCoreApplication::processEvents();  // the form appears
    ASSERT_EQ(window->focusWidget()->objectName(), "rate_depth_perception_1");
    for (int item = 0; item < 5; ++item) {
        QTest::keyClick(window->focusWidget(), Qt::Key_4);
        QTest::keyClick(window->focusWidget(), Qt::Key_Tab);
    }
    click(*window, "rating_hand_in");
    settle();
    HeldWork held;
    go_to_now("rail_rate");
    EXPECT_EQ(rows(), 0) << "before it is read again";
    EXPECT_FALSE(find<QPushButton>(*window, "to_rate_open")->isEnabled());
    held.release();
    settle();
    EXPECT_EQ(rows(), 0);
    check(*window, "to_rate_rated");
    ASSERT_EQ(rows(), 1);
    EXPECT_EQ(find<QTableWidget>(*window, "to_rate_table")->item(0, 6)->text(), "1");
}

TEST_F(ToRate, AListThatCouldNotBeReadIsNotAnEmptyOne) {
    open_list();
    const auto count = [&] { return find<QLabel>(*window, "to_rate_count")->text(); };
    services.store()->connection().execute("ALTER TABLE rating RENAME TO rating_away");
    go_to("rail_rate");
    EXPECT_EQ(rows(), 0);
    const QString why = count();
    EXPECT_FALSE(why.contains("0 attempts")) << why.toStdString();
    check(*window, "to_rate_rated");
    EXPECT_EQ(count(), why) << "the choice reads nothing";
    services.store()->connection().execute("ALTER TABLE rating_away RENAME TO rating");
    go_to("rail_rate");
    EXPECT_EQ(rows(), 1);
    EXPECT_NE(count(), why);
}

TEST_F(ToRate, AnAttemptThatWasVoidedIsGoneAtOnce) {
    open_list();
    emit window->context().debrief_wanted(text(attempt), -1);
    wait_for_debrief();
    choose_tab(*window, "debrief_tabs", "Corrections");
    type(*window, "action_reason", "the camera was off");
    click(*window, "void_attempt");
    click(*window, "void_attempt_sure");
    wait_for_debrief();
    HeldWork held;
    go_to_now("rail_rate");
    EXPECT_EQ(rows(), 0) << "before it is read again";
    held.release();
    settle();
    EXPECT_EQ(rows(), 0);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
