// SPDX-License-Identifier: GPL-3.0-or-later
// The first steps of the theatre, done to their end in B3, which asks for all of them, with each kind of
// device: mouse and keyboard, two mice, a game controller, and the fakes of what fulcrum-hapticd reads. What
// a device cannot do is done with the keys that its lines name.
#include <gtest/gtest.h>

#include <QSettings>

#include "sim_core/controllers/sdl_library.h"
#include "tests/app/held_devices.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/virtual_mice.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/support/fake_trainer.h"

namespace fulcrum::app::program_test {
namespace {

using ui::HandDeed;

/// A device that does what a line of the first steps asks for.
class Taught {
  public:
    virtual ~Taught() = default;
    /// Called again until the deed is done; false: the device cannot do it.
    virtual bool work(HandDeed deed, ui::TheatreView& view) = 0;
    /// Lets go.
    virtual void rest(ui::TheatreView& view) = 0;
    std::string strip;             ///< in the first line
    bool one_after_other = false;  ///< both hands are not moved at the same time
    bool clutch = false;
};

class TaughtHeld : public Taught {
  public:
    explicit TaughtHeld(const std::string& kind) : device_(make_held(kind)) {
        strip = device_->strip;
        one_after_other = kind == "SpaceMouse";
        clutch = device_->own.test(ui::bit_of(HandDeed::clutched));
    }
    bool work(HandDeed deed, ui::TheatreView&) override {
        Vector3 away = Vector3::Zero();
        HeldParts parts;
        if (deed == HandDeed::moved) {
            away.x() = 0.03;
        } else if (deed == HandDeed::inserted) {
            away.z() = -0.02;
        } else if (!device_->own.test(ui::bit_of(deed))) {
            return false;
        }
        if (deed == HandDeed::rolled) parts.roll = 0.6;
        parts.closed = deed == HandDeed::jaws_closed;
        parts.energy = deed == HandDeed::pedal;
        parts.exchange = deed == HandDeed::exchanged;
        parts.clutch = deed == HandDeed::clutched;
        use(away, parts);
        return true;
    }
    void rest(ui::TheatreView&) override { use(Vector3::Zero(), {}); }

  private:
    void use(const Vector3& away, const HeldParts& parts) {
        for (int hand = 0; hand < hand_count; ++hand) {
            device_->put(hand, device_->begin() + away);
            device_->hold(hand, parts);
        }
    }
    std::unique_ptr<HeldDevice> device_;
};

class TaughtMice : public Taught {
  public:
    TaughtMice() { strip = "Each mouse"; }
    bool work(HandDeed deed, ui::TheatreView&) override {
        constexpr int left = 1, middle = 2, right = 3, side = 8;
        switch (deed) {
            case HandDeed::moved:
                mice_.move(0, 8, 0);
                mice_.move(1, -8, 0);
                return true;
            case HandDeed::inserted:
                mice_.wheel(0, 1);
                return true;
            case HandDeed::rolled:
                press(0, right);
                mice_.move(0, 20, 0);
                return true;
            case HandDeed::jaws_closed:
                press(0, left);
                return true;
            case HandDeed::pedal:
                press(1, middle);
                return true;
            case HandDeed::exchanged:
                press(1, side);
                return true;
            default:
                return false;
        }
    }
    void rest(ui::TheatreView&) override {
        if (pressed_ != 0) mice_.button(mouse_, pressed_, false);
        pressed_ = 0;
    }

  private:
    void press(int mouse, int button) {
        if (pressed_ == button) return;
        mice_.button(mouse, button, true);
        mouse_ = mouse;
        pressed_ = button;
    }
    fulcrum::test::Variable device_{"FULCRUM_DEVICE", "two-mice:virtual"};
    VirtualMice mice_;
    int mouse_ = 0, pressed_ = 0;
};

class TaughtPad : public Taught {
  public:
    TaughtPad() {
        strip = "Each stick";
        pad().plugged = 1;
    }
    bool work(HandDeed deed, ui::TheatreView&) override {
        using namespace controllers;
        const auto push = [this](SdlButton button) { pad().buttons = 1U << static_cast<unsigned>(button); };
        switch (deed) {
            case HandDeed::moved:
                pad().axis[axis_left_x] = 20000;
                pad().axis[axis_right_x] = -20000;
                return true;
            case HandDeed::inserted:
                push(button_left_shoulder);
                pad().axis[axis_left_y] = -32768;
                return true;
            case HandDeed::rolled:
                push(button_left_shoulder);
                pad().axis[axis_left_x] = 32767;
                return true;
            case HandDeed::jaws_closed:
                pad().axis[axis_left_trigger] = 32767;
                return true;
            case HandDeed::pedal:
                push(button_east);
                return true;
            case HandDeed::exchanged:  // of the right hand, which worked last
                push(button_south);
                return true;
            case HandDeed::scope_moved:
                push(button_pad_left);
                return true;
            default:
                return false;
        }
    }
    void rest(ui::TheatreView&) override {
        for (auto& axis : pad().axis) axis = 0;
        pad().buttons = 0;
    }

  private:
    fulcrum::test::FakeSdlController& pad() { return page_->controller[0]; }
    fulcrum::test::FakePage<fulcrum::test::FakeSdlPage> page_{"FAKE_SDL_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so")};
    fulcrum::test::Variable device_{"FULCRUM_DEVICE", "controller"};
};

class TaughtMouse : public Taught {
  public:
    TaughtMouse() {
        strip = "moves the handle of the active hand";
        one_after_other = true;
    }
    bool work(HandDeed deed, ui::TheatreView& view) override {
        switch (deed) {
            case HandDeed::other_hand:
                take_other(view, true);
                [[fallthrough]];
            case HandDeed::moved:
                slide_mouse(view, {60, 20});
                return true;
            case HandDeed::inserted:
                turn_wheel(view, 120);
                return true;
            case HandDeed::rolled:
                slide_mouse(view, {160, 0}, Qt::ShiftModifier);
                return true;
            case HandDeed::jaws_closed:
                if (!pressed_) QTest::mousePress(&view, Qt::LeftButton, {}, view.rect().center());
                pressed_ = true;
                return true;
            case HandDeed::pedal:  // of the right hand, which was active at first, by its key
                take_other(view, false);
                return false;
            default:
                return false;
        }
    }
    void rest(ui::TheatreView& view) override {
        if (pressed_) QTest::mouseRelease(&view, Qt::LeftButton, {}, view.rect().center());
        pressed_ = false;
    }

  private:
    void take_other(ui::TheatreView& view, bool other) {
        if (other != other_) QTest::mouseClick(&view, Qt::RightButton, {}, view.rect().center());
        other_ = other;
    }
    bool other_ = false, pressed_ = false;
};

std::unique_ptr<Taught> make_taught(const std::string& kind) {
    if (kind == "Mouse") return std::make_unique<TaughtMouse>();
    if (kind == "TwoMice") return std::make_unique<TaughtMice>();
    if (kind == "Controller") return std::make_unique<TaughtPad>();
    return std::make_unique<TaughtHeld>(kind);
}

/// Before the services are made.
struct WithTaught : ::testing::WithParamInterface<std::string> {
    std::unique_ptr<Taught> taught = make_taught(GetParam());
};

class FirstStepsWith : public WithTaught, public Window {
  protected:
    QString strip() {
        return ui::window_test::find<QFrame>(window, "theatre_keys")
            ->findChild<QLabel*>()
            ->text()
            .replace(QStringLiteral("&nbsp;"), QStringLiteral(" "));
    }
    /// Lines are still taught, not only shown.
    bool learns() { return ui::window_test::sees(window, "theatre_keys") && strip().contains("Enter"); }
    bool done(HandDeed deed) { return theatre().deeds().test(ui::bit_of(deed)); }
    /// The keys that the lines name where a device has nothing of its own.
    static Qt::Key key_for(HandDeed deed) {
        switch (deed) {
            case HandDeed::rolled:
                return Qt::Key_E;
            case HandDeed::jaws_closed:
                return Qt::Key_X;
            case HandDeed::pedal:
                return Qt::Key_B;
            case HandDeed::exchanged:
                return Qt::Key_T;
            default:
                return Qt::Key_Left;
        }
    }
    void do_one(HandDeed deed) {
        ui::TheatreView& view = *theatre().view();
        const bool of_device = taught->work(deed, view);
        const bool by_mouse = !of_device && deed == HandDeed::other_hand;
        const Qt::Key key = key_for(deed);
        const bool by_key = !of_device && !by_mouse;
        if (by_key) QTest::keyPress(&view, key);
        EXPECT_TRUE(ui::window_test::wait_for(
            [&] {
                if (done(deed)) return true;
                if (of_device) taught->work(deed, view);
                if (by_mouse) slide_mouse(view, {60, 20});
                return false;
            },
            10000))
            << GetParam() << ", deed " << static_cast<int>(deed) << ": " << strip().toStdString();
        if (by_key) QTest::keyRelease(&view, key);
        taught->rest(view);
    }
};

TEST_P(FirstStepsWith, AreDoneToTheirEnd) {
    if (GetParam() == "Trainer" && !fulcrum::test::FakeTrainer::is_possible())
        GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    QSettings().clear();
    create_programme_and_trainee();
    start("B3", false);
    ASSERT_TRUE(ui::window_test::wait_for([&] { return learns(); }, 30000));
    EXPECT_TRUE(strip().contains(QString::fromStdString(taught->strip))) << strip().toStdString();
    // The first readings are where the hands begin.
    ASSERT_TRUE(ui::window_test::wait_for([&] { return theatre().session()->health().ticks > 100; }));
    QTest::mouseMove(theatre().view(), theatre().view()->rect().center());
    for (const HandDeed deed :
         {HandDeed::moved, HandDeed::other_hand, HandDeed::inserted, HandDeed::rolled, HandDeed::jaws_closed,
          HandDeed::pedal, HandDeed::exchanged, HandDeed::clutched}) {
        if (deed == HandDeed::other_hand && !taught->one_after_other) continue;
        if (deed == HandDeed::clutched && !taught->clutch) continue;
        do_one(deed);
    }
    EXPECT_TRUE(learns()) << "the scope is still to be moved";
    do_one(HandDeed::scope_moved);
    EXPECT_TRUE(ui::window_test::wait_for([&] { return !learns(); }, 5000)) << strip().toStdString();
    EXPECT_EQ(QSettings().allKeys().filter("learnt/").size(), 1);
    abandon();
    EXPECT_EQ(newest_attempt().state, AttemptState::abandoned);
}

INSTANTIATE_TEST_SUITE_P(Devices, FirstStepsWith,
                         ::testing::Values("Mouse", "TwoMice", "Controller", "Touch", "ForceDimension",
                                           "Haply", "SpaceMouse", "Tracker", "Trainer", "Joystick"),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace fulcrum::app::program_test
