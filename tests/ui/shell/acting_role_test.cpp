// SPDX-License-Identifier: GPL-3.0-or-later
// A person of several roles acts in another one only after a press of the button that says so: keys and the
// wheel in the list of roles choose, and change nothing.
#include <QComboBox>
#include <QPushButton>
#include <QWheelEvent>

#include "database/records/people.h"
#include "tests/ui/screens.h"
#include "ui/language/language.h"
#include "ui/shell/idle_watch.h"

namespace fulcrum::ui::window_test {
namespace {

class ActingRole : public Screens {
  protected:
    ~ActingRole() override {
        window->set_text_size(100);
        window->set_language(Language::english);
    }
    /// Ed, who is a trainee too, on the educator's pages.
    void open_as_ed() {
        database::People(*services.store())
            .set_roles(sessions.at(Role::administrator), sessions.at(Role::educator).person_id(),
                       {Role::trainee, Role::educator});
        open({1280, 800});
        const database::People people(*services.store());  // the window opened another store
        window->context().set_session(people.sign_in("ed", "a long password", Role::educator));
        settle();
        go_to("rail_metrics");
    }
    QComboBox& roles() { return *find<QComboBox>(*window, "acting_role"); }
    Role role() { return window->context().session().role(); }
    Role shown() { return static_cast<Role>(roles().currentData().toInt()); }
    bool is_above(Role wanted) { return roles().findData(static_cast<int>(wanted)) < roles().currentIndex(); }
    void press_towards(Role wanted) {
        QTest::keyClick(&roles(), is_above(wanted) ? Qt::Key_Up : Qt::Key_Down);
    }
    void turn_wheel_towards(Role wanted) {
        const QPoint middle = roles().rect().center();
        QWheelEvent turn(QPointF(middle), QPointF(roles().mapToGlobal(middle)), QPoint(),
                         QPoint(0, is_above(wanted) ? 120 : -120), Qt::NoButton, Qt::NoModifier,
                         Qt::NoScrollPhase, false);
        QApplication::sendEvent(&roles(), &turn);
        settle();
    }
    QString label(const char* name) { return find<QLabel>(*window, name)->text(); }
};

TEST_F(ActingRole, IsChangedByAPressAndNotByKeysOrTheWheel) {
    open_as_ed();
    ASSERT_EQ(role(), Role::educator);
    const auto expect_asked = [&](const char* how) {
        settle();
        EXPECT_EQ(role(), Role::educator) << how;
        EXPECT_EQ(shown(), Role::trainee) << how;
        EXPECT_EQ(window->current_page()->objectName(), "metrics_page") << how;
        EXPECT_EQ(find<QPushButton>(*window, "question_yes")->text(), "Act as trainee") << how;
        EXPECT_EQ(label("question_words"),
                  "You still act as educator. As trainee you see the pages of that role.");
    };
    roles().setFocus();
    press_towards(Role::trainee);
    expect_asked("a key");
    press_towards(Role::educator);
    settle();
    EXPECT_FALSE(sees(*window, "question_yes")) << "it is the role in use again";
    turn_wheel_towards(Role::trainee);
    expect_asked("the wheel");
    click(*window, "question_no");
    EXPECT_FALSE(sees(*window, "question_yes"));
    EXPECT_EQ(shown(), Role::educator) << "the list has the role in use";
    press_towards(Role::trainee);
    expect_asked("a key again");
    go_to("rail_attempts");
    EXPECT_FALSE(sees(*window, "question_yes")) << "work continues in the old role";
    EXPECT_EQ(shown(), Role::educator);
    EXPECT_EQ(role(), Role::educator);
    press_towards(Role::trainee);
    QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
    EXPECT_FALSE(sees(*window, "question_yes")) << "nobody else takes it from the lock";
    type(*window, "unlock_password", "a long password");
    click(*window, "unlock");
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "unlock_password"); }));
    EXPECT_EQ(role(), Role::educator);
    press_towards(Role::trainee);
    click(*window, "question_yes");
    settle();
    EXPECT_EQ(role(), Role::trainee);
    EXPECT_EQ(shown(), Role::trainee);
    EXPECT_EQ(window->current_page()->objectName(), "home_page");
    EXPECT_FALSE(sees(*window, "question_yes"));
}

TEST_F(ActingRole, IsAskedForInGermanAndFitsWithLargeText) {
    open_as_ed();
    window->set_language(Language::german);
    window->set_text_size(200);
    settle();
    press_towards(Role::trainee);
    settle();
    EXPECT_EQ(find<QPushButton>(*window, "question_yes")->text(), "Als Lernende(r) tätig werden");
    EXPECT_EQ(find<QPushButton>(*window, "question_no")->text(), "Ausbilder bleiben");
    for (const char* name : {"question_yes", "question_no", "question_words"}) {
        auto* part = find<QWidget>(*window, name);
        const QRect place(part->mapTo(window.get(), QPoint()), part->size());
        EXPECT_TRUE(window->rect().contains(place)) << name;
        EXPECT_GE(part->width(), part->minimumSizeHint().width()) << name;
    }
    click(*window, "question_yes");
    settle();
    EXPECT_EQ(role(), Role::trainee);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
