// SPDX-License-Identifier: GPL-3.0-or-later
// The keys on the page of settings, changed by real key presses.
#include "ui/shell/keys_card.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QKeyEvent>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>

#include "tests/ui/settings_screens.h"
#include "ui/language/language.h"
#include "ui/style/appearance.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui::window_test {
namespace {

class KeysOnThePage : public SettingsScreens {
  protected:
    QString shown_key(const char* name) { return find<QPushButton>(*window, name)->text(); }
    void change(const char* name, Qt::Key key) {
        auto* button = find<QPushButton>(*window, name);
        bring(*button);
        click(*window, name);
        QTest::keyClick(window->focusWidget(), key);
    }
    QString message() { return window->findChild<QLabel*>("keys_message")->text(); }
    KeyMap kept(Role role = Role::trainee) { return KeyMap::of_person(sessions.at(role).person_id()); }
};

TEST_F(KeysOnThePage, AKeyIsChangedByPressingItAndKeptForThePerson) {
    open_page();
    EXPECT_EQ(shown_key("key_left_left"), "A");
    change("key_left_left", Qt::Key_G);
    EXPECT_EQ(shown_key("key_left_left"), "G");
    EXPECT_EQ(message(), "");
    EXPECT_EQ(kept().key(KeyAction::left_left), Qt::Key_G);
    EXPECT_EQ(kept(Role::educator), KeyMap::standard(false)) << "another person's keys stay";
    go_to("rail_home");
    go_to("rail_settings");
    EXPECT_EQ(shown_key("key_left_left"), "G");
    change("key_jaws", Qt::Key_Tab);
    EXPECT_TRUE(
        message().contains("is already used (Hand that the mouse moves: the mouse takes the other hand)"))
        << message().toStdString();
    EXPECT_EQ(shown_key("key_jaws"), "…") << "waits for another one";
    QTest::keyClick(window->focusWidget(), Qt::Key_F1);
    EXPECT_TRUE(message().contains("is needed for something else")) << message().toStdString();
    QTest::keyClick(window->focusWidget(), Qt::Key_Escape);
    EXPECT_EQ(message(), "");
    EXPECT_EQ(shown_key("key_jaws"), "Space");
    click(*window, "reset_keys");
    EXPECT_EQ(shown_key("key_left_left"), "A");
    EXPECT_EQ(kept(), KeyMap::standard(false));
}

TEST_F(KeysOnThePage, ADeadKeyIsRefusedInWordsOfItsOwnAndTheOthersStay) {
    open_page();
    change("key_left_left", Qt::Key_G);
    click(*window, "key_pedal");
    QKeyEvent dead(QEvent::KeyPress, Qt::Key_Dead_Acute, Qt::NoModifier);
    QCoreApplication::sendEvent(window->focusWidget(), &dead);
    EXPECT_TRUE(message().contains("has no name under which it could be kept")) << message().toStdString();
    EXPECT_EQ(shown_key("key_pedal"), "…") << "waits for another one";
    QTest::keyClick(window->focusWidget(), Qt::Key_Escape);
    go_to("rail_home");
    go_to("rail_settings");
    EXPECT_EQ(shown_key("key_pedal"), "B");
    EXPECT_EQ(shown_key("key_left_left"), "G");
}

TEST_F(KeysOnThePage, OnlyTheKeyThatWasClickedLastWaits) {
    open_page();
    click(*window, "key_pedal");
    EXPECT_EQ(shown_key("key_pedal"), "…");
    click(*window, "key_exchange");
    EXPECT_EQ(shown_key("key_pedal"), "B");
    QTest::keyClick(window->focusWidget(), Qt::Key_G);
    EXPECT_EQ(kept().key(KeyAction::exchange), Qt::Key_G);
    EXPECT_EQ(kept().key(KeyAction::pedal), Qt::Key_B);
    go_to("rail_home");
    go_to("rail_settings");
    click(*window, "key_pedal");
    go_to("rail_home");
    go_to("rail_settings");
    EXPECT_EQ(shown_key("key_pedal"), "B") << "nothing waits any more";
}

TEST_F(KeysOnThePage, TheTheatreUsesAndShowsTheKeysOfThePerson) {
    open_page();
    check(*window, "keys_left_handed");
    EXPECT_EQ(shown_key("key_pedal"), "N");
    EXPECT_TRUE(kept().left_handed());
    change("key_left_left", Qt::Key_G);
    change("key_pedal", Qt::Key_H);
    theatre([&] {
        auto& page = *static_cast<TheatrePage*>(window->current_page());
        ASSERT_NE(page.input(), nullptr);
        EXPECT_EQ(page.input()->keys(), kept());
        ASSERT_TRUE(wait_for([&] { return sees(*window, "theatre_keys"); }));
        const QString strip = find<QFrame>(*window, "theatre_keys")->findChild<QLabel*>()->text();
        EXPECT_TRUE(strip.contains("Left&nbsp;button,&nbsp;Backspace")) << strip.toStdString();
        EXPECT_EQ(page.view()->hud().next_key, "Y") << "the usual one of a mouse in the left hand";
        EXPECT_EQ(page.view()->hud().pedal_key, "H");
        keep("theatre-keys");
        // The buttons of a mouse in the left hand are changed over.
        ASSERT_TRUE(wait_for([&] { return page.session()->phase() == AttemptPhase::running; }));
        const Hand hand = page.input()->active_hand();
        const auto jaw = [&] { return page.input()->targets().hand[static_cast<int>(hand)].jaw; };
        ASSERT_GT(jaw(), 0);
        QTest::mousePress(page.view(), Qt::RightButton);
        EXPECT_TRUE(wait_for([&] { return jaw() == 0; }, 5000)) << "the right one closes the jaws";
        EXPECT_EQ(page.input()->active_hand(), hand);
        QTest::mouseRelease(page.view(), Qt::RightButton);
        EXPECT_TRUE(wait_for([&] { return jaw() > 0; }, 5000));
        QTest::mousePress(page.view(), Qt::LeftButton);
        EXPECT_NE(page.input()->active_hand(), hand) << "the left one takes the other hand";
        QTest::mouseRelease(page.view(), Qt::LeftButton);
        QTest::qWait(100);
        for (const DeviceReading& one : page.input()->targets().hand)
            EXPECT_GT(one.jaw, 0) << "and closes nothing";
    });
}

TEST_F(KeysOnThePage, AKeyAndAButtonSwitchTheSoundDuringAnAttemptAndTheCardKnowsIt) {
    open_page();
    EXPECT_EQ(shown_key("key_sound"), "F2");
    change("key_sound", Qt::Key_G);
    EXPECT_EQ(kept().key(KeyAction::sound), Qt::Key_G);
    services.sound = {true, 0.25};
    theatre([&] {
        auto& page = *static_cast<TheatrePage*>(window->current_page());
        const auto* button = find<QPushButton>(*window, "theatre_sound");
        EXPECT_EQ(button->text(), "Sound off (G)");
        QTest::keyClick(page.view(), Qt::Key_G);
        EXPECT_FALSE(services.sound.wanted);
        EXPECT_EQ(services.sound.volume, 0.25) << "the volume stays for the next time";
        EXPECT_EQ(button->text(), "Sound on (G)");
        EXPECT_EQ(page.session()->phase(), AttemptPhase::running) << "and nothing else happens";
        QTest::keyClick(page.view(), Qt::Key_F1);
        EXPECT_TRUE(page.view()->cover().join('\n').contains("G\tsound off, on"));
        QTest::keyClick(page.view(), Qt::Key_F1);
        click(*window, "theatre_sound");
        EXPECT_TRUE(services.sound.wanted);
        QTest::keyClick(page.view(), Qt::Key_G);
    });
    go_to("rail_settings");
    EXPECT_FALSE(find<QCheckBox>(*window, "sound_wanted")->isChecked());
}

TEST_F(KeysOnThePage, AreDrawnInBothThemesLanguagesAndLarge) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        for (const int percent : {100, 200}) {
            close_and_look(theme, theme == Theme::light ? Language::english : Language::german, percent);
            open_page();
            auto* button = find<QPushButton>(*window, "reset_keys");
            bring(*button);
            settle();
            expect_fits("keys");
            const QString size = QString::number(percent);
            EXPECT_GT(expect_whole("keys " + size, window->findChild<KeysCard*>()), 33) << "a button each";
            keep("keys-" + size);
            keep_body(
                *window, *window->current_page(),
                QStringLiteral("settings-%1-%2").arg(theme == Theme::light ? "light" : "dark-de", size));
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
