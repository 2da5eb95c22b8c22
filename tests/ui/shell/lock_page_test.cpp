// SPDX-License-Identifier: GPL-3.0-or-later
// The lock covers all that a session has on the screen: no dialog and no open list stays usable over it.
#include <QComboBox>
#include <QPushButton>
#include <QTimer>

#include "tests/ui/held_work.h"
#include "tests/ui/screens.h"
#include "ui/page/background_job.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class LockWithDialogs : public Screens {
  protected:
    void open_as_administrator(const char* rail) {
        open({1280, 800});
        sign_in(Role::administrator);
        go_to(rail);
    }
    void lock() { QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock"); }
};

TEST_F(LockWithDialogs, ClosesADialogThatWaitsForAFileName) {
    open_as_administrator("rail_station");
    bool opened = false, stayed = true;
    QTimer in_its_loop;
    QObject::connect(&in_its_loop, &QTimer::timeout, window.get(), [&] {
        QWidget* dialog = QApplication::activeModalWidget();
        if (dialog == nullptr) return;
        in_its_loop.stop();
        opened = true;
        lock();
        stayed = QApplication::activeModalWidget() != nullptr;
        if (stayed) dialog->close();  // so that the test ends
    });
    in_its_loop.start(10);
    click(*window, "back_up");
    ASSERT_TRUE(opened);
    EXPECT_FALSE(stayed);
    EXPECT_TRUE(sees(*window, "unlock_password"));
    EXPECT_TRUE(window->findChildren<BackgroundJob*>().isEmpty()) << "a backup was begun";
}

TEST_F(LockWithDialogs, ClosesADialogNextToTheWindow) {
    open_as_administrator("rail_people");
    bring(*find<QPushButton>(*window, "import_file"));
    click(*window, "import_file");
    ASSERT_TRUE(wait_for([] { return QApplication::activeModalWidget() != nullptr; }));
    lock();
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_TRUE(sees(*window, "unlock_password"));
}

TEST_F(LockWithDialogs, APasswordThatIsStillCheckedUnlocksNothingAfterASignOut) {
    open_as_administrator("rail_settings");
    ASSERT_TRUE(become_active(*window));
    HeldWork held;
    lock();
    type(*window, "unlock_password", "correct horse");
    click(*window, "unlock");
    click(*window, "lock_switch_user");
    ASSERT_FALSE(window->context().signed_in());
    QWidget* const used = window->focusWidget();
    ASSERT_NE(used, nullptr);
    EXPECT_EQ(used->objectName(), "login");
    held.release();
    settle();
    EXPECT_EQ(window->focusWidget(), used) << "the next person's";
    sign_in(Role::trainee);
    lock();
    EXPECT_TRUE(find<QPushButton>(*window, "unlock")->isEnabled()) << "for the next lock";
}

TEST_F(LockWithDialogs, ClosesAnOpenList) {
    open_as_administrator("rail_settings");
    find<QComboBox>(*window, "text_size")->showPopup();
    ASSERT_NE(QApplication::activePopupWidget(), nullptr);
    lock();
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    EXPECT_TRUE(sees(*window, "unlock_password"));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
