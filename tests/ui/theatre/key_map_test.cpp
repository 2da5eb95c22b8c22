// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/key_map.h"

#include <gtest/gtest.h>

#include <QKeySequence>
#include <QSettings>
#include <cmath>
#include <set>

#include "tests/support/support.h"
#include "ui/language/language.h"
#include "ui/theatre/mouse_keyboard_input.h"

namespace fulcrum::ui {
namespace {

class Keys : public ::testing::Test {
  protected:
    Keys() { QSettings().clear(); }
    ~Keys() override { QSettings().clear(); }
};

TEST_F(Keys, EachUsualLayoutHasOneKeyForEachAction) {
    for (const bool left_handed : {false, true}) {
        const KeyMap map = KeyMap::standard(left_handed);
        std::set<int> used;
        for (const KeyActionRow& row : key_actions()) {
            EXPECT_EQ(&row - key_actions().data(), static_cast<std::ptrdiff_t>(row.action)) << row.name;
            EXPECT_TRUE(KeyMap::can_be_used(map.key(row.action))) << row.name;
            EXPECT_TRUE(used.insert(map.key(row.action)).second) << row.name;
            EXPECT_EQ(map.action(map.key(row.action)), row.action);
        }
    }
    EXPECT_EQ(KeyMap::standard(false).action(Qt::Key_Backtab), KeyAction::other_hand);
}

TEST_F(Keys, AKeyThatAnotherActionHasIsRefusedAndNothingChanges) {
    KeyMap map = KeyMap::standard(false);
    EXPECT_EQ(map.assign(KeyAction::pedal, Qt::Key_A), KeyAction::left_left);
    EXPECT_EQ(map, KeyMap::standard(false));
    EXPECT_EQ(map.assign(KeyAction::pedal, Qt::Key_G), std::nullopt);
    EXPECT_EQ(map.key(KeyAction::pedal), Qt::Key_G);
    EXPECT_EQ(map.action(Qt::Key_B), std::nullopt);
    EXPECT_EQ(map.assign(KeyAction::pedal, Qt::Key_G), std::nullopt) << "its own key";
    for (const int needed : {int{Qt::Key_Escape}, int{Qt::Key_F1}, int{Qt::Key_Return}, int{Qt::Key_Shift}, 0,
                             int{Qt::Key_unknown}}) {
        const KeyMap before = map;
        map.assign(KeyAction::jaws, needed);
        EXPECT_EQ(map, before) << needed;
    }
}

TEST_F(Keys, AreKeptForEachPersonAndSurviveADamagedFile) {
    KeyMap map = KeyMap::standard(true);
    map.assign(KeyAction::pedal, Qt::Key_G);
    map.assign(KeyAction::right_out, Qt::Key_Odiaeresis);  // a German keyboard
    map.keep_for("tara");
    EXPECT_EQ(KeyMap::of_person("tara"), map);
    EXPECT_EQ(KeyMap::of_person("ed"), KeyMap::standard(false));
    EXPECT_EQ(KeyMap::of_person(""), KeyMap::standard(false));
    for (const char* damaged : {"A", "", "Ctrl+K", "Esc", "no key", "A, B"}) {
        QSettings().setValue("keys/tara/pedal", QString::fromLatin1(damaged));
        const KeyMap read = KeyMap::of_person("tara");
        std::set<int> used;
        for (const KeyActionRow& row : key_actions())
            EXPECT_TRUE(used.insert(read.key(row.action)).second) << damaged << ' ' << row.name;
        EXPECT_TRUE(read.left_handed());
    }
    KeyMap::standard(false).keep_for("tara");
    EXPECT_EQ(KeyMap::of_person("tara"), KeyMap::standard(false));
    EXPECT_TRUE(QSettings().allKeys().filter("keys/").isEmpty()) << "nothing is left where all is usual";
}

TEST_F(Keys, AKeyWithoutANameIsRefusedAndOneThatCannotBeReadLeavesTheOthers) {
    KeyMap map = KeyMap::standard(false);
    map.assign(KeyAction::left_left, Qt::Key_G);
    const KeyMap before = map;
    for (const Qt::Key nameless :
         {Qt::Key_Dead_Acute, Qt::Key_Dead_Circumflex, Qt::Key_Multi_key, Qt::Key_mu}) {
        EXPECT_FALSE(KeyMap::is_needed(nameless)) << nameless;
        EXPECT_EQ(map.assign(KeyAction::pedal, nameless), std::nullopt);
        EXPECT_EQ(map, before) << nameless;
        map.keep_for("tara");
        EXPECT_EQ(KeyMap::of_person("tara"), map) << nameless;
    }
    for (const Qt::Key named : {Qt::Key_Plus, Qt::Key_NumberSign, Qt::Key_Adiaeresis, Qt::Key_ssharp,
                                Qt::Key_Less, Qt::Key_Slash, Qt::Key_F13, Qt::Key_Menu}) {
        EXPECT_EQ(map.assign(KeyAction::pedal, named), std::nullopt);
        EXPECT_EQ(map.key(KeyAction::pedal), named);
        map.keep_for("tara");
        EXPECT_EQ(KeyMap::of_person("tara"), map) << named;
    }
    // As an earlier version kept a dead key.
    QSettings().setValue("keys/tara/pedal",
                         QKeySequence(Qt::Key_Dead_Acute).toString(QKeySequence::PortableText));
    EXPECT_EQ(KeyMap::of_person("tara"), before);
}

TEST_F(Keys, AKeyThatAPersonChoseBeforeTheSoundHadItStaysAndTheSoundTakesTheNext) {
    KeyMap map = KeyMap::standard(false);
    ASSERT_EQ(map.assign(KeyAction::sound, Qt::Key_F9), std::nullopt);
    ASSERT_EQ(map.assign(KeyAction::pedal, Qt::Key_F2), std::nullopt);
    ASSERT_EQ(map.assign(KeyAction::exchange, Qt::Key_F3), std::nullopt);
    map.keep_for("tara");
    QSettings().remove("keys/tara/sound");  // as an earlier version left it
    const KeyMap read = KeyMap::of_person("tara");
    EXPECT_EQ(read.key(KeyAction::pedal), Qt::Key_F2);
    EXPECT_EQ(read.key(KeyAction::exchange), Qt::Key_F3);
    EXPECT_EQ(read.key(KeyAction::sound), Qt::Key_F4);
    read.keep_for("tara");
    EXPECT_EQ(KeyMap::of_person("tara"), read);
}

TEST_F(Keys, ChangedKeysMoveTheHandsAndAppearInTheHelp) {
    const Scene scene = load_scene(fulcrum::test::source_path("assets/scenes/a2_targets.json"));
    MouseKeyboardInput input(scene);
    KeyMap map = KeyMap::standard(false);
    map.assign(KeyAction::left_left, Qt::Key_G);
    map.assign(KeyAction::pedal, Qt::Key_F5);
    input.set_keys(map);
    const Vector3 before = input.targets().hand[0].handle;
    EXPECT_FALSE(input.press_key(Qt::Key_A));
    input.advance(0.1);
    EXPECT_EQ(input.targets().hand[0].handle, before);
    EXPECT_TRUE(input.press_key(Qt::Key_G));
    input.advance(0.1);
    EXPECT_NE(input.targets().hand[0].handle, before);
    input.release_key(Qt::Key_G);
    EXPECT_TRUE(input.press_key(Qt::Key_F5));
    input.advance(0);
    EXPECT_EQ(input.targets().hand[1].buttons & button_energy, button_energy);
    const QString help = input.help_lines().join(QLatin1Char('\n'));
    EXPECT_TRUE(help.contains("W G S D · R F · Q E · X\tleft hand: handle")) << help.toStdString();
    EXPECT_TRUE(help.contains("F5 · T\tpedal of the active hand")) << help.toStdString();
    EXPECT_TRUE(help.contains("Arrows · PgUp PgDown\tscope")) << help.toStdString();
    EXPECT_TRUE(help.contains("F2\tsound off, on")) << help.toStdString();
    EXPECT_FALSE(input.press_key(Qt::Key_F2)) << "moves nothing";
    map.assign(KeyAction::scope_up, Qt::Key_8);
    input.set_keys(map);
    EXPECT_TRUE(input.help_lines().join(QLatin1Char('\n')).contains("8 Left Down Right · PgUp"));
    input.set_keys(KeyMap::standard(true));
    EXPECT_TRUE(input.help_lines().contains("Right button\tcloses the jaws while held"));
    EXPECT_TRUE(input.help_lines().contains("Left button, Backspace\tthe other hand"));
}

TEST_F(Keys, TheHelpSpeaksGermanWithGermanNamesOfKeys) {
    const Scene scene = load_scene(fulcrum::test::source_path("assets/scenes/a2_targets.json"));
    MouseKeyboardInput input(scene);
    use_language(Language::german);
    const QStringList help = input.help_lines();
    input.set_device(MouseKeyboardInput::Device::controller);
    const QStringList controller = input.help_lines();
    use_language(Language::english);
    EXPECT_TRUE(
        help.contains(QStringLiteral("Leertaste\tMaul der aktiven Hand bleibt zu oder öffnet wieder")))
        << help.join('\n').toStdString();
    EXPECT_TRUE(help.contains(QStringLiteral("Pfeile · Bild auf Bild ab\tOptik: sehen · hinein, heraus")));
    for (const QStringList& lines : {help, controller})
        for (const QString& line : lines) {
            EXPECT_EQ(line.count('\t'), 1) << line.toStdString();
            EXPECT_FALSE(line.contains(" the ")) << line.toStdString();
        }
}

TEST_F(Keys, ASensitivityMovesTheHandleFurtherForTheSameMouse) {
    const Scene scene = load_scene(fulcrum::test::source_path("assets/scenes/a2_targets.json"));
    double moved[2] = {};
    for (int i = 0; i < 2; ++i) {
        MouseKeyboardInput input(scene);
        input.set_sensitivity(i == 0 ? 1 : 0.5);
        const Vector3 before = input.targets().hand[1].handle;
        input.move_mouse({20, 0});
        moved[i] = (input.targets().hand[1].handle - before).norm();
    }
    EXPECT_NEAR(moved[1], moved[0] / 2, 1e-5);
}

/// Full speed for `s` seconds.
ControllerMotion pushed(int hand, double right, double up, double along = 0) {
    ControllerMotion motion;
    motion.connected = motion.begun[0] = motion.begun[1] = true;
    motion.across[hand][0] = right;
    motion.across[hand][1] = up;
    motion.along[hand] = along;
    return motion;
}

TEST_F(Keys, AControllerMovesOneHandWhileTheOtherHoldsAndNeverLeavesTheWorkspace) {
    const Scene scene = load_scene(fulcrum::test::source_path("assets/scenes/b1_bowel.json"));
    MouseKeyboardInput input(scene);
    input.set_device(MouseKeyboardInput::Device::controller);
    ControllerMotion motion = pushed(1, 0, 0);
    motion.latches[0] = 1;
    input.move_by_controller(motion);
    input.advance(0);
    EXPECT_EQ(input.targets().hand[0].jaw, 0);
    EXPECT_GT(input.targets().hand[0].grip, 0);
    const Vector3 left = input.targets().hand[0].handle;
    const double shaft = scene.instrument(Hand::right)->trocar.shaft_length;
    for (int i = 0; i < 400; ++i) {
        input.move_by_controller(pushed(1, std::cos(0.1 * i), std::sin(0.23 * i), std::sin(0.05 * i)));
        input.advance(0.016);
        const Vector3 right = input.targets().hand[1].handle;
        ASSERT_TRUE(right.allFinite());
        ASSERT_LE(right.norm(), shaft);
        ASSERT_GE(right.norm(), handle_clearance);
        ASSERT_LT(right.z(), 0);
    }
    EXPECT_EQ(input.targets().hand[0].handle, left);
    EXPECT_EQ(input.targets().hand[0].jaw, 0) << "still holds";
    motion = pushed(1, 0, 0);
    motion.trigger[1] = 0.35;
    input.move_by_controller(motion);
    input.advance(0);
    const double opening = scene.instrument(Hand::right)->jaw_opening;
    EXPECT_NEAR(input.targets().hand[1].jaw, opening / 2, 1e-9);
    EXPECT_EQ(input.targets().hand[1].grip, 0);
    EXPECT_FALSE(input.jaws_closed(Hand::right));
    motion.trigger[1] = 0.85;
    input.move_by_controller(motion);
    input.advance(0);
    EXPECT_NEAR(input.targets().hand[1].grip, scene.instrument(Hand::right)->grip_force / 2, 1e-9);
    EXPECT_TRUE(input.jaws_closed(Hand::right));
    input.hold_jaws();
    input.advance(0);
    EXPECT_EQ(input.targets().hand[1].jaw, 0) << "held when the controller is lost";
}

}  // namespace
}  // namespace fulcrum::ui
