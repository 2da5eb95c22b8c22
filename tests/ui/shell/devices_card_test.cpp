// SPDX-License-Identifier: GPL-3.0-or-later
// The devices on the page of settings: what is connected, what is not and why; readings; force scale.
#include "ui/shell/devices_card.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <atomic>
#include <thread>

#include "sim_core/devices/device_table.h"
#include "tests/ui/screens.h"
#include "ui/language/language.h"
#include "ui/style/appearance.h"

namespace fulcrum::ui::window_test {
namespace {

class DevicesOnThePage : public Screens {
  protected:
    DevicesOnThePage() {
        services.devices = {{"mouse-keyboard",
                             "mouse and keyboard",
                             DeviceClass::mouse_keyboard,
                             DeviceState::usable,
                             {},
                             "",
                             ""},
                            {"touch",
                             "3D Systems Touch",
                             DeviceClass::haptic,
                             DeviceState::connected,
                             {"Touch (2988:0302)"},
                             "you have no permission to open the device",
                             device_row("touch")->rule,
                             "/dev/ttyACM0"},
                            {"space-mouse",
                             "SpaceMouse",
                             DeviceClass::controller,
                             DeviceState::absent,
                             {},
                             "spacenavd, which reads it, does not run",
                             "install the package spacenavd and start it with `sudo systemctl restart "
                             "spacenavd`"},
                            {"trainer",
                             device_row("trainer")->title,
                             DeviceClass::tracked,
                             DeviceState::connected,
                             {"Arduino Uno (2341:0043)"},
                             "you have no permission to open the device",
                             device_row("trainer")->rule,
                             "/dev/ttyACM1"}};
    }
    ~DevicesOnThePage() override {
        window.reset();
        apply_text_size(*qApp, 100);
        use_language(Language::english);
    }
    void open_page() {
        open({1280, 800});
        sign_in(Role::trainee);
        go_to("rail_settings");
    }
    /// All visible words of the card.
    QString words() {
        QStringList shown;
        for (const QLabel* label : window->findChild<DevicesCard*>()->findChildren<QLabel*>())
            if (label->isVisible()) shown << label->text();
        return shown.join(QLatin1Char('\n'));
    }
    void use_haptic_device() {
        services.in_use.kind = "virtual";
        services.in_use.title = "Virtual device";
        services.in_use.device_class = DeviceClass::haptic;
    }
};

TEST_F(DevicesOnThePage, EachSaysItsStateWhyAndWhatToDo) {
    open_page();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "device_touch"); }));
    for (const char* line :
         {"✓ mouse and keyboard: can be used", "! 3D Systems Touch: connected, cannot be used",
          "Touch (2988:0302)\nWhy: you have no permission to open the device (/dev/ttyACM0)\nWhat to do: "
          "write the line "
          "SUBSYSTEMS==\"usb\"",
          "– SpaceMouse: not connected", "! box trainer on a serial port: connected, cannot be used",
          "What to do: run “sudo usermod -aG dialout $USER”"})
        EXPECT_TRUE(words().contains(line)) << line << "\n\n" << words().toStdString();
    EXPECT_FALSE(sees(*window, "force_scale")) << "mouse and keyboard give no force";
}

TEST_F(DevicesOnThePage, AnotherLookShowsWhatWasConnectedSince) {
    open_page();
    ASSERT_TRUE(wait_for([&] { return sees(*window, "device_touch"); }));
    services.devices.erase(services.devices.begin() + 1);
    click(*window, "look_for_devices");
    EXPECT_TRUE(wait_for([&] { return !sees(*window, "device_touch"); }));
    EXPECT_TRUE(wait_for([&] { return sees(*window, "device_space-mouse"); }));
}

class SlowDevices : public DevicesOnThePage {
  protected:
    /// Answers when it is allowed to.
    struct Slow : FakeServices {
        std::atomic<bool> answer{false};
        std::function<std::vector<ListedDevice>()> list_devices() override {
            return [this] {
                while (!answer) std::this_thread::yield();
                return std::vector<ListedDevice>{
                    {"slow", "slow device", DeviceClass::haptic, DeviceState::absent, {}, "w", "t"}};
            };
        }
    };
};

TEST_F(SlowDevices, WindowAnswersWhileDevicesAreLookedFor) {
    Slow slow;
    slow.open_store(false);
    Context context(slow);
    DevicesCard card(context);
    card.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&card));
    EXPECT_EQ(card.findChild<QLabel*>("device_slow"), nullptr);
    slow.answer = true;
    EXPECT_TRUE(wait_for([&] { return card.findChild<QLabel*>("device_slow") != nullptr; }));
}

TEST_F(DevicesOnThePage, ForceScaleIsChosenByTheKeyboardAndKept) {
    use_haptic_device();
    open_page();
    auto* scale = find<QComboBox>(*window, "force_scale");
    EXPECT_EQ(scale->currentText(), "100 %");
    scale->setFocus();
    for (int i = 0; i < 6; ++i) QTest::keyClick(scale, Qt::Key_Up);
    EXPECT_EQ(scale->currentText(), "40 %");
    EXPECT_DOUBLE_EQ(services.force_scale("virtual"), 0.4);
    go_to("rail_home");
    go_to("rail_settings");
    EXPECT_EQ(find<QComboBox>(*window, "force_scale")->currentText(), "40 %");
}

TEST_F(DevicesOnThePage, ReadingsAreShownWhileTheDeviceIsOpen) {
    use_haptic_device();
    open_page();
    auto* shown = find<QLabel>(*window, "device_readings");
    EXPECT_TRUE(shown->text().contains("while it is open")) << shown->text().toStdString();
    DeviceReadings now;
    now.rate = 998.4;
    now.held = {{"left", true, Vector3(0.0123, -0.004, 0.1), 0.4, 1}, {"right", false, {}, 0, 0}};
    services.readings = now;
    EXPECT_TRUE(wait_for([&] { return shown->text().contains("998 readings per second"); }));
    EXPECT_TRUE(shown->text().contains("Left hand: at (12.3, -4.0, 100.0) mm, jaws 40 % open, buttons 1"))
        << shown->text().toStdString();
    EXPECT_TRUE(shown->text().contains("Right hand: does not answer"));
}

// As the daemon refuses them: touch_device_test.cpp, force_dimension_device_test.cpp.
TEST_F(DevicesOnThePage, OneThatIsTriedInVainSaysWhyAndWhatToDoInBothLanguages) {
    use_haptic_device();
    open_page();
    const auto reported = [](const char* words) {
        return Sentence(QT_TRANSLATE_NOOP("errors", "the maker's driver reports %1"), std::string(words));
    };
    const Sentence update = QT_TRANSLATE_NOOP("errors",
                                              "update the firmware of the device with its maker's program, "
                                              "or install the driver that belongs to it");
    const struct {
        InputError error;
        const char *english, *german;
    } cases[] = {
        {InputError(device_row("touch")->title, "default device",
                    reported("0x0302 Firmware version is not supported"), update),
         "3D Systems Touch:default device: the maker's driver reports 0x0302 Firmware version is not "
         "supported; update the firmware of the device",
         "der Treiber des Herstellers meldet 0x0302 Firmware version is not supported; aktualisieren Sie die "
         "Firmware des Geräts"},
        {InputError(device_row("force-dimension")->title, "device 0",
                    {QT_TRANSLATE_NOOP("errors", "the device does not open: %1"),
                     reported("firmware version is not supported")},
                    update),
         "Force Dimension, Novint Falcon:device 0: the device does not open: the maker's driver reports "
         "firmware version is "
         "not supported; update the firmware of the device",
         "das Gerät lässt sich nicht öffnen: der Treiber des Herstellers meldet firmware version is not "
         "supported; aktualisieren Sie die Firmware des Geräts"},
        {InputError(device_row("touch")->title, "default device", reported("0x0600 Invalid license"),
                    QT_TRANSLATE_NOOP("errors", "install the licence of OpenHaptics")),
         "the maker's driver reports 0x0600 Invalid license; install the licence of OpenHaptics",
         "der Treiber des Herstellers meldet 0x0600 Invalid license; installieren Sie die Lizenz von "
         "OpenHaptics"}};
    for (const Language language : {Language::english, Language::german}) {
        window->set_language(language);
        settle();
        for (const auto& one : cases) {
            services.refuses.emplace(one.error);
            bring(*find<QPushButton>(*window, "open_device"));
            click(*window, "open_device");
            const QString wanted =
                QString::fromUtf8(language == Language::english ? one.english : one.german);
            EXPECT_TRUE(wait_for([&] { return error_shown().contains(wanted); }, 3000))
                << error_shown().toStdString() << "\n\n"
                << wanted.toStdString();
            EXPECT_TRUE(sees(*window, "open_device")) << "it can be tried again";
        }
    }
    window->set_language(Language::english);
    settle();
    // The same while it is open.
    services.refuses.reset();
    services.readings_when_open.emplace();
    services.trouble = words_of(DeviceFault::firmware);
    click(*window, "open_device");
    EXPECT_TRUE(wait_for([&] {
        return words().contains("the firmware of the device does not suit it. Update the firmware");
    })) << words().toStdString();
}

TEST_F(DevicesOnThePage, AreDrawnInBothThemesLanguagesAndLarge) {
    use_haptic_device();
    for (const auto& [theme, percent] : {std::pair(Theme::light, 100), std::pair(Theme::light, 200),
                                         std::pair(Theme::dark, 200), std::pair(Theme::dark, 100)}) {
        close_and_look(theme, theme == Theme::light ? Language::english : Language::german, percent);
        open_page();
        ASSERT_TRUE(wait_for([&] { return sees(*window, "device_touch"); }));
        bring(*find<QPushButton>(*window, "look_for_devices"));
        settle();
        expect_fits("devices");
        EXPECT_GT(expect_whole(QStringLiteral("devices %1").arg(percent), window->findChild<DevicesCard*>()),
                  8);
        keep(QStringLiteral("devices-%1").arg(percent));
        if (theme == Theme::dark && percent == 100) {
            EXPECT_TRUE(words().contains("– SpaceMouse: nicht verbunden")) << words().toStdString();
            EXPECT_TRUE(words().contains("Gerät zu öffnen (/dev/ttyACM0)")) << words().toStdString();
            EXPECT_TRUE(words().contains("schreiben Sie die Zeile SUBSYSTEMS==\"usb\""))
                << words().toStdString();
            services.trouble = words_of(DeviceFault::warm_motors);
            EXPECT_TRUE(wait_for([&] { return words().contains("Die Motoren des Geräts sind zu warm."); }))
                << words().toStdString();
            services.trouble = {};
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
