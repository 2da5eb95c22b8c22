// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/taught_devices.h"

#include "sim_core/controllers/sdl_library.h"
#include "tests/app/controller_hand.h"
#include "tests/app/held_devices.h"
#include "tests/app/held_hand.h"
#include "tests/app/mouse_hand.h"
#include "tests/app/two_mice_hand.h"
#include "tests/app/virtual_mice.h"
#include "tests/app/virtual_pad.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/support/built.h"

namespace fulcrum::app::program_test {
namespace {

using ui::HandDeed;

class TaughtHeld : public Taught {
  public:
    explicit TaughtHeld(const std::string& kind) : device_(make_held(kind)) {
        title = device_->title;
        model = device_->model;
        strip = device_->strip;
        one_after_other = !device_->moves[1];
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
        parts.open = parts.closed ? 0 : 1;
        parts.energy = deed == HandDeed::pedal;
        parts.exchange = deed == HandDeed::exchanged;
        parts.clutch = deed == HandDeed::clutched;
        use(away, parts);
        return true;
    }
    void rest(ui::TheatreView&) override { use(Vector3::Zero(), {}); }
    std::unique_ptr<Worker> worker(ui::TheatrePage& theatre, ObservingRig& mind) override {
        return std::make_unique<HeldHand>(theatre, mind, *device_);
    }

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
    TaughtMice() {
        title = model = "two mice and keyboard";
        strip = "Each mouse";
        buttons = InputWatch::MouseButtons::of_hold;
    }
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
    std::unique_ptr<Worker> worker(ui::TheatrePage& theatre, ObservingRig& mind) override {
        return std::make_unique<TwoMiceHand>(theatre, mind, mice_);
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

/// What the program finds where it loads the fake of SDL 2.
class PadOfFakeSdl : public VirtualPad {
  public:
    PadOfFakeSdl() { page_->controller[0].plugged = 1; }
    void set_axis(int axis, std::int32_t value) override { pad_.set_axis(axis, value); }
    void set_buttons(std::uint32_t held) override { pad_.set_buttons(held); }

  private:
    fulcrum::test::FakePage<fulcrum::test::FakeSdlPage> page_{"FAKE_SDL_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so")};
    FakePad pad_{page_->controller[0]};
};

class TaughtPad : public Taught {
  public:
    TaughtPad(std::unique_ptr<VirtualPad> pad, const std::string& name, const std::string& specification)
        : pad_(std::move(pad)), device_("FULCRUM_DEVICE", specification) {
        title = model = name;
        strip = "Each stick";
    }
    bool work(HandDeed deed, ui::TheatreView&) override {
        using namespace controllers;
        const auto press = [this](SdlButton button) {
            pad_->set_buttons(1U << static_cast<unsigned>(button));
        };
        switch (deed) {
            case HandDeed::moved:
                pad_->set_axis(axis_left_x, 20000);
                pad_->set_axis(axis_right_x, -20000);
                return true;
            case HandDeed::inserted:
                press(button_left_shoulder);
                pad_->set_axis(axis_left_y, -32768);
                return true;
            case HandDeed::rolled:
                press(button_left_shoulder);
                pad_->set_axis(axis_left_x, 32767);
                return true;
            case HandDeed::jaws_closed:
                pad_->set_axis(axis_left_trigger, 32767);
                return true;
            case HandDeed::pedal:
                press(button_east);
                return true;
            case HandDeed::exchanged:  // of the right hand, which worked last
                press(button_south);
                return true;
            case HandDeed::scope_moved:
                press(button_pad_left);
                return true;
            default:
                return false;
        }
    }
    void rest(ui::TheatreView&) override {
        for (int axis = 0; axis <= controllers::axis_right_trigger; ++axis) pad_->set_axis(axis, 0);
        pad_->set_buttons(0);
    }
    std::unique_ptr<Worker> worker(ui::TheatrePage& theatre, ObservingRig& mind) override {
        return std::make_unique<ControllerHand>(theatre, mind, *pad_);
    }

  private:
    std::unique_ptr<VirtualPad> pad_;
    fulcrum::test::Variable device_;
};

std::unique_ptr<Taught> make_taught_pad_of_sdl() {
    constexpr const char* name = "Virtual controller of SDL 2";
    std::unique_ptr<VirtualPad> pad = make_pad_of_sdl(name);
    if (pad == nullptr) return nullptr;
    return std::make_unique<TaughtPad>(std::move(pad), name, std::string("controller:") + name);
}

class TaughtMouse : public Taught {
  public:
    TaughtMouse() {
        title = model = "mouse and keyboard";
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
    std::unique_ptr<Worker> worker(ui::TheatrePage& theatre, ObservingRig& mind) override {
        return std::make_unique<MouseHand>(theatre, mind);
    }

  private:
    void take_other(ui::TheatreView& view, bool other) {
        if (other != other_) QTest::mouseClick(&view, Qt::RightButton, {}, view.rect().center());
        other_ = other;
    }
    bool other_ = false, pressed_ = false;
};

/// The keys that the lines name where a device has nothing of its own.
Qt::Key key_of_line(HandDeed deed) {
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

}  // namespace

std::unique_ptr<Taught> make_taught(const std::string& kind) {
    if (kind == "Mouse") return std::make_unique<TaughtMouse>();
    if (kind == "TwoMice") return std::make_unique<TaughtMice>();
    if (kind == "Controller")
        return std::make_unique<TaughtPad>(std::make_unique<PadOfFakeSdl>(), "Fake Pad", "controller");
    if (kind == "ControllerOfSdl") return make_taught_pad_of_sdl();
    return std::make_unique<TaughtHeld>(kind);
}

QString TaughtWindow::strip() {
    return ui::window_test::find<QFrame>(window, "theatre_keys")
        ->findChild<QLabel*>()
        ->text()
        .replace(QStringLiteral("&nbsp;"), QStringLiteral(" "));
}

void TaughtWindow::do_one(HandDeed deed) {
    ui::TheatreView& view = *theatre().view();
    const bool of_device = taught->work(deed, view);
    const bool by_mouse = !of_device && deed == HandDeed::other_hand;
    const Qt::Key key = key_of_line(deed);
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
        << "deed " << static_cast<int>(deed) << ": " << strip().toStdString();
    if (by_key) QTest::keyRelease(&view, key);
    taught->rest(view);
}

void TaughtWindow::do_first_steps() {
    ASSERT_TRUE(ui::window_test::wait_for([&] { return learns(); }, 30000));
    EXPECT_TRUE(strip().contains(QString::fromStdString(taught->strip))) << strip().toStdString();
    // The first readings are where the hands begin.
    ASSERT_TRUE(ui::window_test::wait_for([&] { return theatre().session()->health().ticks > 100; }));
    QTest::mouseMove(theatre().view(), theatre().view()->rect().center());
    ui::HandDeeds needed = ui::needed_deeds(theatre().session()->scene(), taught->one_after_other);
    needed.set(ui::bit_of(HandDeed::clutched), taught->clutch);
    for (const HandDeed deed :
         {HandDeed::moved, HandDeed::other_hand, HandDeed::inserted, HandDeed::rolled, HandDeed::jaws_closed,
          HandDeed::pedal, HandDeed::exchanged, HandDeed::clutched}) {
        if (needed.test(ui::bit_of(deed))) do_one(deed);
    }
    ASSERT_TRUE(ui::window_test::wait_for([&] { return learns(); })) << "the scope is still to be moved";
    do_one(HandDeed::scope_moved);
    EXPECT_TRUE(ui::window_test::wait_for([&] { return !learns(); }, 5000)) << strip().toStdString();
    lines_done_ = static_cast<int>(needed.count());
}

}  // namespace fulcrum::app::program_test
