// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/held_devices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <initializer_list>

#include "app/services/calibration.h"
#include "sim_core/controllers/joystick_mapping.h"
#include "sim_core/igtl/content.h"
#include "sim_core/instrument/device.h"
#include "sim_core/numerics/files.h"
#include "tests/fakes/fake_force_dimension.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/fakes/fake_touch.h"
#include "tests/support/fake_haply.h"
#include "tests/support/fake_spacenavd.h"
#include "tests/support/fake_tracker.h"
#include "tests/support/fake_trainer.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

using ui::HandDeed;

ui::HandDeeds these_deeds(std::initializer_list<HandDeed> deeds) {
    ui::HandDeeds all;
    for (const HandDeed deed : deeds) all.set(ui::bit_of(deed));
    return all;
}

/// Of a device whose buttons have the numbers of the record.
int button_mask(const HeldParts& parts) {
    return (parts.clutch ? int{button_clutch} : 0) | (parts.energy ? int{button_energy} : 0) |
           (parts.exchange ? int{button_exchange} : 0);
}

class HeldTouch : public HeldDevice {
  public:
    HeldTouch() {
        name("touch:Left Device,Right Device");
        title = "3D Systems Touch (fake of its library)";
        strip = "Stylus";
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal});
    }
    void put(int hand, const Vector3& position) override {
        for (int axis = 0; axis < 3; ++axis) page_->device[hand].position[axis] = 1e3 * position[axis];
    }
    void hold(int hand, const HeldParts& parts) override {
        page_->device[hand].gimbal[2] = parts.roll;
        page_->device[hand].buttons = (parts.closed ? 1 : 0) | (parts.energy ? 2 : 0);
    }
    double force() const override {
        double most = 0;
        for (const auto& device : page_->device)
            for (const auto& one : device.force) most = std::max(most, std::abs(one.load()));
        return most;
    }

  private:
    fulcrum::test::FakePage<fulcrum::test::FakeTouchPage> page_{"FAKE_TOUCH_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so")};
};

class HeldForceDimension : public HeldDevice {
  public:
    HeldForceDimension() {
        name("force-dimension");
        title = "Force Dimension (fake of its library)";
        strip = "Handle of the device";
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal, HandDeed::clutched});
    }
    void put(int hand, const Vector3& p) override {
        const double place[3] = {p.z(), p.x(), p.y()};  // towards the person, to the right, up
        for (int axis = 0; axis < 3; ++axis) page_->device[hand].position[axis] = place[axis];
    }
    void hold(int hand, const HeldParts& parts) override {
        page_->device[hand].turn = parts.roll;
        page_->device[hand].gripper = parts.closed ? 0 : 0.5;
        page_->device[hand].buttons = (parts.energy ? 1U : 0U) | (parts.clutch ? 2U : 0U);
    }
    double force() const override {
        double most = 0;
        for (const auto& device : page_->device)
            for (const auto& one : device.force) most = std::max(most, std::abs(one.load()));
        return most;
    }

  private:
    fulcrum::test::FakePage<fulcrum::test::FakeForceDimensionPage> page_{"FAKE_FORCE_DIMENSION_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBDRD", fulcrum::test::fake_library("libdrd.so")};
};

class HeldHaply : public HeldDevice {
  public:
    HeldHaply() {
        name(haply_.specification());
        title = "Haply Inverse3 (fake of its service)";
        strip = "Grip of the Inverse3";
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal, HandDeed::exchanged});
        for (int hand = 0; hand < hand_count; ++hand) HeldHaply::put(hand, HeldHaply::begin());
    }
    void put(int hand, const Vector3& p) override {
        haply_.move(static_cast<std::size_t>(hand), Vector3(p.x(), -p.z(), p.y()));
    }
    void hold(int hand, const HeldParts& parts) override {
        haply_.turn(static_cast<std::size_t>(hand),
                    Quaternion(Eigen::AngleAxisd(parts.roll, Vector3::UnitZ())), parts.closed, parts.energy,
                    parts.exchange);
    }
    Vector3 begin() const override { return {0.01, 0.1, 0.15}; }
    double force() const override { return std::max(haply_.force(0).norm(), haply_.force(1).norm()); }

  private:
    fulcrum::test::FakeHaply haply_{{{"0A11", "left"}, {"0B22", "right"}}, 2};
};

class HeldTracker : public HeldDevice {
  public:
    HeldTracker() {
        // The tool's z points away from the person, as an instrument does.
        name("openigtlink:" + tracker_.address() +
             ",left=LeftTipToPatient,right=RightTipToPatient,length=0,shaft=-z");
        title = "tracked instruments over OpenIGTLink";
        strip = "Tracked instrument";
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal, HandDeed::exchanged,
                           HandDeed::clutched});
    }
    void put(int hand, const Vector3& position) override {
        pose(hand).place = position;
        tracker_.move(static_cast<std::size_t>(hand), pose(hand));
    }
    void hold(int hand, const HeldParts& parts) override {
        pose(hand).rotation = Eigen::AngleAxisd(parts.roll, Vector3::UnitZ()).toRotationMatrix();
        tracker_.move(static_cast<std::size_t>(hand), pose(hand));
        parts_[static_cast<std::size_t>(hand)] = parts;
        constexpr const char* names[hand_count] = {"LeftJaw", "RightJaw"};
        igtl::Bytes bytes;
        for (std::size_t h = 0; h < hand_count; ++h) {
            const double values[] = {parts_[h].closed ? 0.0 : 1.0, 1.0 * button_mask(parts_[h])};
            igtl::append_sensor(bytes, names[h], 0, values, 2, igtl::unit_none);
        }
        tracker_.also_send(bytes);
    }

  private:
    igtl::Pose& pose(int hand) { return pose_[static_cast<std::size_t>(hand)]; }
    fulcrum::test::FakeTracker tracker_{{"LeftTipToPatient", "RightTipToPatient"}};
    std::array<igtl::Pose, hand_count> pose_;
    std::array<HeldParts, hand_count> parts_;
};

class HeldTrainer : public HeldDevice {
  public:
    HeldTrainer() {
        name(trainer_.specification());
        title = "box trainer on a serial port (pseudo-terminal)";
        strip = "Instrument of the trainer";
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal, HandDeed::exchanged,
                           HandDeed::clutched});
    }
    void put(int hand, const Vector3& position) override { trainer_.move(letter(hand), position); }
    void hold(int hand, const HeldParts& parts) override {
        trainer_.turn(letter(hand), parts.roll);
        trainer_.hold(letter(hand), parts.closed ? 0 : 1000, button_mask(parts));
    }
    Vector3 begin() const override { return {0, 0, 0.24}; }

  private:
    static char letter(int hand) { return hand == 0 ? 'L' : 'R'; }
    fulcrum::test::FakeTrainer trainer_{"LR"};
};

/// A joystick of SDL 2 whose six axes are the angles and the lengths of two instruments, with four buttons
/// each.
class HeldJoystick : public HeldDevice {
  public:
    explicit HeldJoystick(bool named)
        : file_(named ? (folder_.path() / "joystick.json").string() : joystick_file()) {
        if (named) name("joystick:" + file_);
        title = "HID joystick (fake of SDL 2)";
        strip = "Instrument on the joystick";
        own = these_deeds({HandDeed::jaws_closed, HandDeed::pedal, HandDeed::exchanged, HandDeed::clutched});
        stick().known = 0;
        std::snprintf(stick().name, sizeof stick().name, "%s", stick_name);
        for (int hand = 0; hand < hand_count; ++hand) HeldJoystick::put(hand, HeldJoystick::begin());
        stick().plugged = 1;
        std::filesystem::create_directories(std::filesystem::path(file_).parent_path());
        write_whole_file(file_, joystick_mapping_text(mapping()));
    }
    ~HeldJoystick() override { std::remove(file_.c_str()); }
    void put(int hand, const Vector3& handle) override {
        const Vector3 to_the_tip = -handle.normalized();
        const double of_instrument[] = {std::asin(to_the_tip.y()),
                                        std::atan2(to_the_tip.x(), -to_the_tip.z()),
                                        fulcrum::test::trainer_length - handle.norm()};
        for (int i = 0; i < axes_of_hand; ++i) {
            const double share = (of_instrument[i] - least[i]) / (most[i] - least[i]);
            stick().axis[axes_of_hand * hand + i] =
                static_cast<std::int32_t>(std::lround(65535 * share)) - 32768;
        }
    }
    void hold(int hand, const HeldParts& parts) override {
        const std::uint32_t pressed = (parts.closed ? 1U : 0U) | (parts.energy ? 2U : 0U) |
                                      (parts.exchange ? 4U : 0U) | (parts.clutch ? 8U : 0U);
        const auto shift = static_cast<unsigned>(buttons_of_hand * hand);
        stick().buttons = (stick().buttons & ~(0xFU << shift)) | (pressed << shift);
    }
    Vector3 begin() const override { return {0, 0, 0.24}; }

  private:
    static constexpr int axes_of_hand = 3, buttons_of_hand = 4;
    static constexpr double least[axes_of_hand] = {-0.8, -0.8, 0}, most[axes_of_hand] = {0.8, 0.8, 0.3};
    static constexpr const char* stick_name = "Odd Stick";
    static JoystickMapping mapping() {
        JoystickMapping made;
        made.name = stick_name;
        for (int hand = 0; hand < hand_count; ++hand) {
            JoystickPart& part = made.part[hand];
            for (int i = 0; i < axes_of_hand; ++i) {
                JoystickAxis& axis = part.motion[i];
                axis.axis = axes_of_hand * hand + i;
                axis.at_low = least[i];
                axis.at_high = most[i];
                axis.at_rest = 0.5 * (least[i] + most[i]);
            }
            part.jaws = buttons_of_hand * hand;
            part.energy = part.jaws + 1;
            part.exchange = part.jaws + 2;
            part.clutch = part.jaws + 3;
        }
        return made;
    }
    fulcrum::test::FakeSdlController& stick() { return page_->controller[0]; }
    fulcrum::test::FakePage<fulcrum::test::FakeSdlPage> page_{"FAKE_SDL_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so")};
    fulcrum::test::OwnFolder folder_;
    std::string file_;
};

/// For the left hand: the cap is pushed and turned, its first button closes the jaws.
class HeldCap : public HeldDevice {
  public:
    HeldCap() {
        name("space-mouse:left");
        title = "SpaceMouse for the left hand (fake of spacenavd)";
        strip = "Cap to the side";
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed});
    }
    void put(int hand, const Vector3& position) override {
        if (hand != 0) return;
        const auto pushed = [](double along) {
            return std::abs(along) < 1e-3 ? 0 : along > 0 ? full : -full;
        };
        push_ = {pushed(position.x()), pushed(position.y()), pushed(-position.z())};
        send();
    }
    void hold(int hand, const HeldParts& parts) override {
        if (hand != 0) return;
        turn_ = parts.roll != 0 ? full : 0;
        send();
        if (parts.closed != closed_) cap_.send_event(parts.closed ? 1 : 2, {0, parts.closed ? 1 : 0});
        closed_ = parts.closed;
    }

  private:
    static constexpr int full = 350;
    void send() const { cap_.send_event(0, {push_[0], push_[1], push_[2], 0, turn_, 0, 16}); }
    fulcrum::test::OwnFolder folder_;
    std::string path_ = (folder_.path() / "spnav.sock").string();
    fulcrum::test::Variable socket_{"SPNAV_SOCKET", path_};
    fulcrum::test::FakeSpacenavd cap_{path_, 1};
    std::array<int, 3> push_{0, 0, 0};
    int turn_ = 0;
    bool closed_ = false;
};

}  // namespace

std::unique_ptr<HeldDevice> make_held(const std::string& kind, bool named) {
    if (kind == "Touch") return std::make_unique<HeldTouch>();
    if (kind == "Haply") return std::make_unique<HeldHaply>();
    if (kind == "ForceDimension") return std::make_unique<HeldForceDimension>();
    if (kind == "Tracker") return std::make_unique<HeldTracker>();
    if (kind == "Trainer") return std::make_unique<HeldTrainer>();
    if (kind == "Joystick") return std::make_unique<HeldJoystick>(named);
    return std::make_unique<HeldCap>();
}

}  // namespace fulcrum::app::program_test
