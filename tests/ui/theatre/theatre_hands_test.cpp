// SPDX-License-Identifier: GPL-3.0-or-later
// The hands in the theatre: what moves an instrument there, and by how much.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCursor>
#include <QMouseEvent>
#include <memory>

#include "tests/ui/four_people.h"
#include "tests/ui/settings_screens.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui::window_test {
namespace {

class TheatreHands : public SettingsScreens {
  protected:
    void begin(const char* task) {
        emit window->context().attempt_wanted(task, false, 0, false);
        page = static_cast<TheatrePage*>(window->current_page());
        ASSERT_TRUE(wait_for(
            [&] { return page->session() != nullptr && page->session()->phase() == AttemptPhase::running; }));
        services.control.ticks_per_update = 1;
    }
    /// The pointer of the screen too, so that nothing else comes from it.
    void rest_at(const QPoint& there) {
        QTest::mouseMove(page->view(), page->view()->mapFromGlobal(there));
        EXPECT_TRUE(wait_for([&] { return QCursor::pos() == there; }));
        settle();
        point_at(there);
    }
    void point_at(const QPoint& there) {
        TheatreView* const view = page->view();
        QMouseEvent event(QEvent::MouseMove, view->mapFromGlobal(there), there, Qt::NoButton, Qt::NoButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(view, &event);
    }
    QPoint corner() { return page->view()->mapToGlobal(QPoint(0, 0)); }
    QPoint middle() { return page->view()->mapToGlobal(page->view()->rect().center()); }
    Vector3 handle() {
        const auto active = static_cast<int>(page->input()->active_hand());
        return page->input()->targets().hand[active].handle;
    }
    TheatrePage* page = nullptr;
};

TEST_F(TheatreHands, StayWhereTheyAreWhereTheViewMovesUnderThePointer) {
    open({1280, 800});
    sign_in(Role::trainee);
    begin("A2");
    const QPoint there = middle();
    rest_at(there);
    const Vector3 held = handle();
    const QPoint before = corner();
    window->context().say(QStringLiteral("Saved"));
    settle();
    ASSERT_TRUE(wait_for([&] { return corner() != before; })) << "the message is above the view";
    point_at(there);
    EXPECT_LT((handle() - held).norm(), 1e-6);
    const QPoint below = corner();
    window->move(window->pos() + QPoint(40, 30));
    ASSERT_TRUE(wait_for([&] { return corner() != below; }));
    settle();
    point_at(there);
    EXPECT_LT((handle() - held).norm(), 1e-6);
    point_at(there + QPoint(20, 0));
    EXPECT_GT((handle() - held).norm(), 1e-4) << "the mouse moves it";
}

// No event loop between the movements: the server's word of the pointer that was put back comes after them.
TEST_F(TheatreHands, MoveEvenlyWhereThePointerIsPutBackIntoTheMiddle) {
    open({1280, 800});
    sign_in(Role::trainee);
    begin("A2");
    rest_at(middle());
    QApplication::setActiveWindow(window.get());  // there is no window manager that would do it
    settle();
    ASSERT_TRUE(page->view()->isActiveWindow());
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(page->view(), &leave);
    const QPoint border = middle() + QPoint(page->view()->width() / 2, 0);
    const auto moved_to = [&](const QPoint& there) {
        const Vector3 before = handle();
        point_at(there);
        return (handle() - before).norm();
    };
    EXPECT_EQ(moved_to(border - QPoint(60, 0)), 0) << "where it came in";
    EXPECT_GT(moved_to(border - QPoint(20, 0)), 1e-3) << "and is put back";
    const double ten = moved_to(border - QPoint(10, 0));
    EXPECT_GT(ten, 3e-4);
    EXPECT_LT(ten, 4e-3) << "10 px, not half a window";
    EXPECT_GT(moved_to(border - QPoint(2, 0)), 1e-4) << "is not put back twice";
    EXPECT_LT(moved_to(middle()), 1e-9) << "the pointer moves, the hand does not";
    EXPECT_NEAR(moved_to(middle() + QPoint(10, 0)), ten, 1e-3);
}

// A SpaceMouse moves the scope, the mouse both hands.
TEST_F(TheatreHands, MoveByTheScaleOfTheMouseNextToADeviceThatHasAScaleOfItsOwn) {
    services.in_use.kind = "space-mouse";
    services.in_use.title = "SpaceMouse";
    services.in_use.drives[2] = true;
    services.motions["space-mouse"] = 2;
    open({1280, 800});
    sign_in(Role::trainee);
    double moved[2] = {};
    for (int i = 0; i < 2; ++i) {
        services.motions[""] = i == 0 ? 1 : 0.5;
        begin("C4");
        const QPoint there = middle();
        rest_at(there);
        const Vector3 before = handle();
        point_at(there + QPoint(20, 0));
        moved[i] = (handle() - before).norm();
        emit window->context().home_wanted();
        settle();
    }
    EXPECT_GT(moved[0], 1e-3);
    EXPECT_LT(moved[0], 7.5e-3) << "20 px at 100 %";
    EXPECT_NEAR(moved[1], moved[0] / 2, 2e-4) << "what was set for the mouse";
}

class ServicesWithPad : public FakeServices {
  public:
    std::shared_ptr<GameController> game_controller() override { return pad; }
    /// Nothing is behind it: whoever has a share of it only holds it.
    std::shared_ptr<void> owner = std::make_shared<int>(0);
    std::shared_ptr<GameController> pad{owner, static_cast<GameController*>(owner.get())};
};

TEST(TheatreDevices, AreLetGoOfWhereTheAttemptIsRefused) {
    ServicesWithPad services;
    services.open_store(false);
    const auto sessions = make_four_people(*services.store());
    MainWindow window(services);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.start();
    window.context().set_session(sessions.at(Role::administrator));
    const long before = services.owner.use_count();
    emit window.context().attempt_wanted("A2", false, 0, false);
    EXPECT_TRUE(wait_for([&] { return sees(window, "message_text"); }))
        << "an administrator performs nothing";
    EXPECT_EQ(services.owner.use_count(), before);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
