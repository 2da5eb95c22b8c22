// SPDX-License-Identifier: GPL-3.0-or-later
// The first steps in the theatre: for each kind of device its own lines, of what the scene needs; marked by
// what the hands did; ended and shown again with Enter.
#include <gtest/gtest.h>

#include <QPainter>
#include <set>

#include "sim_core/devices/device_table.h"
#include "sim_core/instrument/mouse_mapping.h"
#include "tests/support/support.h"
#include "tests/ui/painted_words.h"
#include "tests/ui/settings_screens.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/taught_lines.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui::window_test {
namespace {

constexpr const char* taught_scenes[] = {"a1_camera", "a2_targets", "b1_bowel", "b3_bands", "c4_posterior"};

Scene taught_scene(const char* name) {
    return load_scene(fulcrum::test::source_path(std::string("assets/scenes/") + name + ".json"));
}

TaughtHands all_parts_of(const DeviceRow& row) {
    TaughtHands hands;
    hands.kind = row.name;
    if (row.read_by != ReadBy::daemon) return hands;
    hands.drives[0] = hands.drives[1] = (row.moves & moves_hands) != 0;
    hands.drives[2] = (row.moves & moves_scope) != 0;
    return hands;
}

QStringList lines_of(const Scene& scene, const TaughtHands& hands) {
    QStringList lines;
    for (const TaughtLine& one : taught_lines(scene, hands, KeyMap::standard(false))) lines << one.line;
    return lines;
}

TEST(TaughtLines, EveryKindOfDeviceHasItsOwnForAllThatASceneNeedsInBothLanguages) {
    for (const Language language : {Language::english, Language::german}) {
        use_language(language);
        std::set<QString> first;
        for (const DeviceRow& row : device_table) {
            const TaughtHands hands = all_parts_of(row);
            for (const char* name : taught_scenes) {
                const Scene scene = taught_scene(name);
                HandDeeds taught;
                const auto lines = taught_lines(scene, hands, KeyMap::standard(false));
                for (const TaughtLine& one : lines) {
                    taught.set(bit_of(one.deed));
                    const std::string line = one.line.toStdString();
                    EXPECT_EQ(one.line.count('\t'), 1) << row.name << " " << line;
                    EXPECT_FALSE(one.line.contains('{')) << line;
                    EXPECT_LE(one.line.section('\t', 0, 0).size(), 48) << line;
                    EXPECT_LE(one.line.section('\t', 1).size(), 84) << line;
                    EXPECT_FALSE(language == Language::german && one.line.contains(" the ")) << line;
                }
                EXPECT_EQ(taught, needed_deeds(scene, is_one_mouse(scene, hands))) << row.name << " " << name;
                if (std::string(name) == "c4_posterior") first.insert(lines.front().line);
            }
        }
        EXPECT_EQ(first.size(), std::size(device_table)) << "each says what to hold";
    }
    use_language(Language::english);
}

// Reading at 150 words a minute, and six seconds for each thing that is done.
TEST(TaughtLines, CanBeReadAndDoneWithinTheirTwoMinutes) {
    constexpr double words_a_second = 2.5, seconds_a_deed = 6;
    EXPECT_EQ(teaching_s, 120);
    for (const Language language : {Language::english, Language::german}) {
        use_language(language);
        for (const DeviceRow& row : device_table) {
            TaughtHands hands = all_parts_of(row);
            if (row.read_by == ReadBy::daemon) hands.clutch = ClutchButton::own;
            for (const char* name : taught_scenes) {
                const QStringList lines = lines_of(taught_scene(name), hands);
                const int words = lines.join(QLatin1Char(' '))
                                      .replace(QLatin1Char('\t'), QLatin1Char(' '))
                                      .split(QLatin1Char(' '), Qt::SkipEmptyParts)
                                      .size();
                EXPECT_LT(words / words_a_second + seconds_a_deed * lines.size(), teaching_s)
                    << row.name << " " << name << ": " << words << " words in " << lines.size() << " lines";
            }
        }
    }
    use_language(Language::english);
}

// What a device without lines of its own shows.
TEST(TaughtLines, AreGeneralForANewDeviceAndNameIt) {
    const Scene c4 = taught_scene("c4_posterior"), a1 = taught_scene("a1_camera");
    for (const Language language : {Language::english, Language::german}) {
        use_language(language);
        const TaughtHands hands{"new-device", {true, true, true}};
        EXPECT_TRUE(lines_of(c4, hands).first().startsWith("new-device\t"));
        EXPECT_TRUE(lines_of(a1, hands).first().startsWith("new-device\t"));
        EXPECT_EQ(lines_of(c4, hands).filter("new-device").size(), 2) << "instrument and scope";
        for (const QString& line : lines_of(c4, hands) + lines_of(a1, hands)) {
            EXPECT_FALSE(line.contains('{')) << line.toStdString();
            EXPECT_FALSE(language == Language::german && line.contains(" the ")) << line.toStdString();
            EXPECT_LE(line.section('\t', 0, 0).size(), 48) << line.toStdString();
            EXPECT_LE(line.section('\t', 1).size(), 84) << line.toStdString();
        }
    }
    use_language(Language::english);
}

TEST(TaughtLines, SayTheMouseOnlyWhereItMovesSomething) {
    const Scene c4 = taught_scene("c4_posterior");
    TaughtHands touch{"touch", {true, true, false}};
    const QString both = lines_of(c4, touch).join('\n');
    EXPECT_FALSE(both.contains("Mouse")) << both.toStdString();
    EXPECT_TRUE(both.contains("T on the keyboard\tnext instrument")) << both.toStdString();
    EXPECT_TRUE(both.contains("Rear button of the stylus\tpedal of that hand"));
    EXPECT_TRUE(both.contains("Arrows · PgUp PgDown\tscope: look · in, out")) << "a Touch moves no scope";
    touch.drives[0] = false;
    EXPECT_TRUE(lines_of(c4, touch).contains("Mouse · wheel\tthe left hand · in and out"));
    TaughtHands cap{"space-mouse", {false, false, true}};
    const QStringList lines = lines_of(c4, cap);
    EXPECT_TRUE(lines.first().startsWith("Mouse\tmoves the handle of the active hand"));
    EXPECT_TRUE(lines.contains("Cap of the SpaceMouse\tscope: look · in, out"));
    const QStringList help = device_help(c4, cap, KeyMap::standard(false), {"mouse"});
    EXPECT_EQ(help, QStringList({"Cap of the SpaceMouse\tscope: look · in, out", "mouse"}));
    cap.drives[1] = true;
    EXPECT_TRUE(lines_of(c4, cap).first().startsWith("Cap to the side"));
    EXPECT_EQ(lines_of(taught_scene("a1_camera"), touch), lines_of(taught_scene("a1_camera"), {}))
        << "what has no scope leaves it to the mouse";
}

// For each device that has one, in both languages: in the first steps and in the help, and marked when it was
// held.
TEST(TaughtLines, NameTheClutchWhereTheDeviceHasAButtonForIt) {
    const Scene c4 = taught_scene("c4_posterior");
    for (const Language language : {Language::english, Language::german}) {
        use_language(language);
        for (const DeviceRow& row : device_table) {
            TaughtHands hands = all_parts_of(row);
            if (row.read_by != ReadBy::daemon) continue;
            const QStringList without = lines_of(c4, hands);
            for (const ClutchButton clutch : {ClutchButton::own, ClutchButton::energy}) {
                hands.clutch = clutch;
                QStringList added = lines_of(c4, hands);
                for (const QString& line : without) added.removeAll(line);
                ASSERT_EQ(added.size(), 1) << row.name;
                EXPECT_TRUE(added[0].contains(language == Language::english ? "\tclutch" : "\tKupplung"))
                    << added[0].toStdString();
                EXPECT_LE(added[0].section('\t', 0, 0).size(), 48) << added[0].toStdString();
                EXPECT_LE(added[0].section('\t', 1).size(), 84) << added[0].toStdString();
                EXPECT_TRUE(device_help(c4, hands, KeyMap::standard(false), {}).contains(added[0]));
                EXPECT_TRUE(needed_deeds(c4, hands).test(bit_of(HandDeed::clutched)));
            }
        }
    }
    use_language(Language::english);
    TaughtHands touch{"touch", {true, true, false}, ClutchButton::energy, pedal_keys_only};
    const QStringList lines = lines_of(c4, touch);
    EXPECT_TRUE(lines.contains("B on the keyboard\tpedal (energy, suction)"))
        << lines.join('\n').toStdString();
    EXPECT_TRUE(lines.filter("Rear button of the stylus\tclutch").size() == 1)
        << lines.join('\n').toStdString();
    touch.pedal = 0;
    EXPECT_TRUE(lines_of(c4, touch).contains("Button of the left device, or B\tpedal (energy, suction)"));
    const TaughtHands cap{"space-mouse", {false, false, true}, ClutchButton::energy, pedal_keys_only};
    EXPECT_EQ(device_help(c4, cap, KeyMap::standard(false), {"mouse"}).size(), 3) << "clutch, scope, mouse";
    HandWatch watch(c4);
    RigSample sample;
    for (DeviceSample* part : {&sample.hand[0], &sample.hand[1], &sample.camera}) part->present = 1;
    watch.see(sample);
    EXPECT_FALSE(watch.done(false).test(bit_of(HandDeed::clutched)));
    sample.hand[1].buttons = button_clutch;
    watch.see(sample);
    EXPECT_TRUE(watch.done(false).test(bit_of(HandDeed::clutched)));
}

TEST(TaughtLines, HaveTheKeysOfThePerson) {
    KeyMap keys = KeyMap::standard(false);
    keys.assign(KeyAction::pedal, Qt::Key_BraceLeft);
    keys.assign(KeyAction::exchange, Qt::Key_F5);
    QStringList lines;
    for (const TaughtLine& one : taught_lines(taught_scene("b3_bands"), {}, keys)) lines << one.line;
    EXPECT_TRUE(lines.contains("{\tpedal of the active hand (energy, suction)"))
        << lines.join('\n').toStdString();
    EXPECT_TRUE(lines.contains("F5\tnext instrument of the active hand"));
}

/// Devices that are where a test puts them.
class PutRig : public Rig {
  public:
    explicit PutRig(const Scene& scene) {
        for (const InstrumentSpec& spec : scene.instruments)
            hand[static_cast<int>(spec.hand)] = start_reading(spec.trocar.shaft_length, spec.start_insertion,
                                                              spec.jaw_opening * open_jaw_share);
        camera = start_reading(scene.camera->trocar.shaft_length, scene.camera->start_insertion, 0);
    }
    void read(std::uint32_t tick, RigSample& sample) override {
        sample.tick = tick;
        for (int h = 0; h < hand_count; ++h) sample.hand[h] = quantise(hand[h], {});
        sample.camera = quantise(camera, {});
    }
    void write_force(Hand, const Vector3&) override {}
    bool has_force(Hand) const override { return false; }
    double damping(Hand) const override { return -1; }
    DeviceReading hand[hand_count], camera;
};

class FirstSteps : public SettingsScreens {
  protected:
    /// Practice of `task` with a device that the test moves.
    void begin(const char* task, const char* scene, const char* kind, const char* title, bool scope = false) {
        rig = std::make_shared<PutRig>(taught_scene(scene));
        services.device_rig = rig;
        services.in_use.kind = kind;
        services.in_use.title = title;
        services.in_use.drives[0] = services.in_use.drives[1] = true;
        services.in_use.drives[2] = scope;
        services.control.ticks_per_update = 1;
        again(task);
    }
    void again(const char* task) {
        emit window->context().attempt_wanted(task, false, 0, false);
        page = static_cast<TheatrePage*>(window->current_page());
        // The first reading is where the hands begin.
        ASSERT_TRUE(
            wait_for([&] { return page->session()->health().ticks > 2 && sees(*window, "theatre_keys"); }));
    }
    void home() {
        emit window->context().home_wanted();
        settle();
    }
    QString strip() {
        return find<QFrame>(*window, "theatre_keys")
            ->findChild<QLabel*>()
            ->text()
            .replace(QStringLiteral("&nbsp;"), QStringLiteral(" "))
            .remove(QStringLiteral("<b>"))
            .remove(QStringLiteral("</b>"));
    }
    bool shows(const char* words) {
        return wait_for([&] { return strip().contains(QString::fromUtf8(words)); }, 5000);
    }
    std::shared_ptr<PutRig> rig;
    TheatrePage* page = nullptr;
};

TEST_F(FirstSteps, AreMarkedByWhatTheHandsDidAndOnlyWhatIsNewIsTaughtNextTime) {
    open({1280, 800});
    sign_in(Role::trainee);
    begin("C4", "c4_posterior", "touch", "3D Systems Touch");
    EXPECT_TRUE(shows("Stylus is the handle of its hand")) << strip().toStdString();
    EXPECT_FALSE(strip().contains("Mouse")) << strip().toStdString();
    EXPECT_FALSE(strip().contains("done"));
    for (DeviceReading& hand : rig->hand) hand.handle.x() += 0.03;
    EXPECT_TRUE(shows("✓ 1 of 7 done")) << strip().toStdString();
    EXPECT_FALSE(strip().contains("Stylus is the handle"));
    QTest::keyClick(page->view(), Qt::Key_B);
    EXPECT_FALSE(page->deeds().test(bit_of(HandDeed::pedal)))
        << "the hands did not; this device heeds no key";
    rig->hand[0].roll = 1;
    rig->hand[0].jaw = 0;
    EXPECT_TRUE(shows("✓ 3 of 7 done")) << strip().toStdString();
    EXPECT_TRUE(strip().contains("T on the keyboard next instrument")) << strip().toStdString();
    home();
    again("C4");
    EXPECT_TRUE(shows("Stylus away from you")) << strip().toStdString();
    EXPECT_FALSE(strip().contains("Front button")) << "was done before";
    rig->hand[1].buttons = button_energy | button_exchange;
    rig->camera.handle.x() += 0.03;
    rig->hand[1].handle *= 0.9;
    EXPECT_TRUE(wait_for([&] { return !strip().contains("Enter"); })) << "all is learnt";
    home();
    again("C4");
    EXPECT_FALSE(strip().contains("Enter")) << strip().toStdString();
    home();
    services.in_use.kind = "haply";
    again("C4");
    EXPECT_TRUE(shows("Grip of the Inverse3")) << "another kind of device is new";
    EXPECT_TRUE(strip().contains("Enter"));
}

TEST_F(FirstSteps, EndWithEnterAndAreShownAgainFromTheHelp) {
    open({1280, 800});
    sign_in(Role::trainee);
    begin("A2", "a2_targets", "trainer", "Box", true);
    EXPECT_TRUE(shows("Enter ends these lines"));
    EXPECT_TRUE(strip().contains("Scope of the trainer scope: look"));
    EXPECT_FALSE(strip().contains("jaws")) << "a probe has none";
    QTest::keyClick(page->view(), Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return !sees(*window, "theatre_keys"); }, 3000));
    QTest::keyClick(page->view(), Qt::Key_Return);
    EXPECT_EQ(page->session()->phase(), AttemptPhase::running) << "a second one does nothing";
    QTest::keyClick(page->view(), Qt::Key_F1);
    QTest::keyClick(page->view(), Qt::Key_Return);
    EXPECT_TRUE(wait_for([&] { return sees(*window, "theatre_keys"); }, 3000));
    EXPECT_TRUE(shows("Enter ends these lines"));
    for (DeviceReading& hand : rig->hand) {
        hand.handle.x() += 0.03;
        hand.handle *= 0.9;
    }
    EXPECT_TRUE(shows("✓ Push, pull the instrument")) << strip().toStdString();
    home();
    again("A2");
    EXPECT_FALSE(strip().contains("Enter")) << "ended is as good as learnt";
}

// Two minutes of the attempt, in seconds: the window takes the time from its ticks.
TEST_F(FirstSteps, EndAfterTwoMinutesOfWorkAndTeachTheRestNextTime) {
    open({1280, 800});
    sign_in(Role::trainee);
    begin("A2", "a2_targets", "trainer", "Box", true);
    EXPECT_TRUE(shows("Instrument of the trainer moves as you hold it")) << strip().toStdString();
    for (DeviceReading& hand : rig->hand) hand.handle.x() += 0.03;
    ASSERT_TRUE(wait_for([&] { return page->session()->display().moving_seen; }));
    EXPECT_TRUE(shows("Enter ends these lines")) << "the scope was not moved yet";
    page->pause();
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "theatre_keys"); }, 3000));
    const std::uint32_t begun = page->session()->health().ticks;
    services.control.ticks_per_update = 2000;
    click(*window, "panel_resume");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "theatre_keys"); }, 3000));
    std::uint32_t seen = begun;
    ASSERT_TRUE(wait_for(
        [&] {
            const bool shown = sees(*window, "theatre_keys");
            if (shown) seen = page->session()->health().ticks;
            return !shown;
        },
        30000));
    // The window may have looked several times between two looks of the test.
    EXPECT_GT(1e-3 * (seen - begun), 0.85 * teaching_s);
    EXPECT_LT(1e-3 * (page->session()->health().ticks - begun), 1.15 * teaching_s);
    EXPECT_FALSE(page->deeds().test(bit_of(HandDeed::scope_moved)));
    services.control.ticks_per_update = 1;
    home();
    again("A2");
    EXPECT_TRUE(shows("Scope of the trainer scope: look")) << strip().toStdString();
    EXPECT_TRUE(strip().contains("Enter ends these lines")) << strip().toStdString();
    EXPECT_FALSE(strip().contains("moves as you hold it")) << "was done: " << strip().toStdString();
}

TEST_F(FirstSteps, AreStillThereAfterALongPause) {
    open({1280, 800});
    sign_in(Role::trainee);
    services.control.ticks_per_update = 10;
    emit window->context().attempt_wanted("A2", true, 0, false);
    page = static_cast<TheatrePage*>(window->current_page());
    ASSERT_TRUE(wait_for([&] { return sees(*window, "theatre_keys"); }));
    QTest::keyPress(page->view(), Qt::Key_D);
    ASSERT_TRUE(wait_for([&] { return page->session()->display().moving_seen; }));
    QTest::keyRelease(page->view(), Qt::Key_D);
    page->pause();
    ASSERT_TRUE(wait_for([&] { return !sees(*window, "theatre_keys"); }, 3000));
    QTest::qWait(8500);  // the lines stay for 8 s of the attempt
    click(*window, "panel_resume");
    EXPECT_TRUE(wait_for([&] { return sees(*window, "theatre_keys"); }, 3000));
}

// On a German keyboard the semicolon is Shift and the comma.
TEST_F(FirstSteps, AKeyIsReleasedUnderTheNameThatShiftGaveIt) {
    open({1280, 800});
    sign_in(Role::trainee);
    services.control.ticks_per_update = 1;
    again("A2");
    const auto send = [this](QEvent::Type type, int key, Qt::KeyboardModifiers with, const char* words) {
        QKeyEvent event(type, key, with, 47, 0, 0, QString::fromLatin1(words));
        QCoreApplication::sendEvent(page->view(), &event);
    };
    const auto handle = [this]() -> Vector3 { return page->input()->targets().hand[1].handle; };
    const Vector3 begun = handle();
    send(QEvent::KeyPress, Qt::Key_Semicolon, Qt::NoModifier, ";");
    page->input()->advance(0.1);
    EXPECT_GT((handle() - begun).norm(), 1e-4);
    send(QEvent::KeyRelease, Qt::Key_Colon, Qt::ShiftModifier, ":");
    const Vector3 released = handle();
    page->input()->advance(1.0);
    EXPECT_EQ(handle(), released);
}

TEST_F(FirstSteps, AreDrawnInBothThemesLanguagesAndLarge) {
    open({1280, 800});
    sign_in(Role::trainee);
    for (const Theme theme : {Theme::light, Theme::dark})
        for (const Language language : {Language::english, Language::german})
            for (const int percent : {100, 200}) {
                // All eight where pictures are wanted, else both sizes in both themes, each in its language.
                const bool light = theme == Theme::light, english = language == Language::english;
                if (!qEnvironmentVariableIsSet("FULCRUM_PICTURES") && light != english) continue;
                window->set_theme(theme);
                window->set_language(language);
                window->set_text_size(percent);
                settle();
                const bool cap = percent == 100 && theme == Theme::dark;
                services.in_use.clutch = cap ? ClutchButton::none : ClutchButton::energy;
                services.in_use.pedal = cap ? pedal_of_each_hand : pedal_keys_only;
                begin("C4", "c4_posterior", cap ? "haply" : "touch",
                      cap ? "Haply Inverse3" : "3D Systems Touch");
                auto* const bar = find<QFrame>(*window, "theatre_keys");
                EXPECT_GT(bar->y(), 0.4 * page->height()) << percent << " covers too much";
                const QString name = QStringLiteral("first-steps-%1-%2-%3")
                                         .arg(light ? "light" : "dark", english ? "en" : "de")
                                         .arg(percent);
                EXPECT_EQ(expect_whole(name, bar), 1) << "the lines";
                EXPECT_TRUE(page->rect().contains(bar->geometry())) << name.toStdString();
                EXPECT_GT(expect_whole(name + " theatre"), 4) << "with the buttons below";
                keep(name);
                QTest::keyClick(page->view(), Qt::Key_F1);
                keep(name + QStringLiteral("-help"));
                EXPECT_EQ(page->view()->cover().filter(english ? "\tclutch" : "\tKupplung").size(),
                          cap ? 0 : 1);
                QTest::keyClick(page->view(), Qt::Key_F1);
                home();
            }
}

TEST_F(FirstSteps, LeaveForcesAndTimesInSightInASmallWindowWithTheLargestText) {
    for (const Language language : {Language::english, Language::german}) {
        open({1024, 768});
        sign_in(Role::trainee);
        window->set_language(language);
        window->set_text_size(200);
        settle();
        services.in_use.clutch = ClutchButton::energy;
        services.in_use.pedal = pedal_keys_only;
        begin("C4", "c4_posterior", "touch", "3D Systems Touch");
        const TheatreView* const view = page->view();
        ASSERT_TRUE(wait_for([&] { return view->hud().task != nullptr && view->covered_foot() > 0; }));
        const auto* const strip = find<QFrame>(*window, "theatre_keys");
        EXPECT_TRUE(page->rect().contains(strip->geometry()));
        const double top = strip->y() - view->y();
        HudState hud = view->hud();
        hud.force_felt = false;
        for (int h = 0; h < hand_count; ++h) {
            hud.display.force[h] = 2.4F;
            hud.display.force_limit[h] = 3;
            hud.display.warning[h] = true;
        }
        WordsDevice device(view->size(), view->logicalDpiY());
        QPainter painter(&device);
        paint_hud(painter, view->rect(), hud, view->covered_foot());
        painter.end();
        ASSERT_GT(device.words().size(), 8U);
        int forces = 0;
        for (const PaintedWords& one : device.words()) {
            forces += one.words.endsWith(QLatin1String(" N")) ? 1 : 0;
            EXPECT_LE(one.place.bottom(), top + 1) << one.words.toStdString() << " is under the strip";
            EXPECT_GE(one.place.top(), -1) << one.words.toStdString();
            EXPECT_TRUE(one.whole) << one.words.toStdString();
            for (const PaintedWords& other : device.words()) {
                const QRectF both = one.place & other.place;
                if (&one != &other) {
                    EXPECT_LE(std::min(both.width(), both.height()), 2)
                        << one.words.toStdString() << " on " << other.words.toStdString();
                }
            }
        }
        EXPECT_EQ(forces, 4) << "force and limit of both hands";
        int bars = 0;
        for (const QRectF& shape : device.shapes()) {
            EXPECT_LE(shape.bottom(), top + 1) << "a bar is under the strip";
            bars += shape.height() > 20 && shape.height() > 1.2 * shape.width() ? 1 : 0;
        }
        EXPECT_GE(bars, 2) << "of both hands";
        keep(QStringLiteral("first-steps-small-") + (language == Language::english ? "en" : "de"));
        home();
        window.reset();
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
