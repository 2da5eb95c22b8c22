// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/held_devices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <stdexcept>

#include "app/services/calibration.h"
#include "sim_core/controllers/joystick_mapping.h"
#include "sim_core/hapticd/space_mouse_device.h"
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

/// N, the largest component of a fake of a maker's library.
template <typename Devices>
double largest_component(const Devices& devices) {
    double most = 0;
    for (const auto& device : devices)
        for (const auto& one : device.force) most = std::max(most, std::abs(one.load()));
    return most;
}

class HeldTouch : public HeldDevice {
  public:
    HeldTouch() {
        name("touch:Left Device,Right Device");
        title = "3D Systems Touch (fake of its library)";
        model = "3D Systems Touch";
        strip = "Stylus";
        library = "libHD.so";
        device_class = DeviceClass::haptic;
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal});
    }
    void put(int hand, const Vector3& position) override {
        for (int axis = 0; axis < 3; ++axis) page_->device[hand].position[axis] = 1e3 * position[axis];
    }
    void hold(int hand, const HeldParts& parts) override {
        page_->device[hand].gimbal[2] = parts.roll;
        page_->device[hand].buttons = (parts.closed ? 1 : 0) | (parts.energy ? 2 : 0);
    }
    double force() const override { return largest_component(page_->device); }
    void break_it(DeviceFault fault) override {
        page_->old_firmware = fault == DeviceFault::firmware ? 1 : 0;
        page_->device[1].tick_error = fault == DeviceFault::warm_motors      ? 0x0200
                                      : fault == DeviceFault::too_much_force ? 0x0201
                                      : fault == DeviceFault::driver         ? 0x0103
                                                                             : 0x0300;
    }
    void repair() override { page_->device[1].tick_error = page_->old_firmware = 0; }

  private:
    fulcrum::test::FakePage<fulcrum::test::FakeTouchPage> page_{"FAKE_TOUCH_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so")};
};

class HeldForceDimension : public HeldDevice {
  public:
    HeldForceDimension() {
        name("force-dimension");
        title = "Force Dimension (fake of its library)";
        model = "omega.7";
        strip = "Handle of the device";
        library = "libdrd.so";
        device_class = DeviceClass::haptic;
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal, HandDeed::clutched});
    }
    void put(int hand, const Vector3& p) override {
        const double place[3] = {p.z(), p.x(), p.y()};  // towards the person, to the right, up
        for (int axis = 0; axis < 3; ++axis) page_->device[hand].position[axis] = place[axis];
    }
    void hold(int hand, const HeldParts& parts) override {
        page_->device[hand].turn = parts.roll;
        page_->device[hand].gripper = 0.5 * parts.open;
        page_->device[hand].buttons = (parts.energy ? 1U : 0U) | (parts.clutch ? 2U : 0U);
    }
    double force() const override { return largest_component(page_->device); }
    void break_it(DeviceFault fault) override {
        auto& device = page_->device[0];
        if (fault == DeviceFault::needs_calibration) device.status[reset] = 1;
        if (fault == DeviceFault::no_answer) device.pose_fails = 1;
        if (fault != DeviceFault::too_fast && fault != DeviceFault::switched_off) return;
        device.status[force_off_cause] = fault == DeviceFault::switched_off ? by_button : by_velocity;
        device.status[force_on] = 0;
    }
    void repair() override {
        auto& device = page_->device[0];
        device.status[reset] = 0;
        device.status[force_on] = 1;
        device.pose_fails = 0;
    }

  private:
    static constexpr int reset = 3, force_on = 5, force_off_cause = 14, by_button = 1, by_velocity = 2;
    fulcrum::test::FakePage<fulcrum::test::FakeForceDimensionPage> page_{"FAKE_FORCE_DIMENSION_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBDRD", fulcrum::test::fake_library("libdrd.so")};
};

class HeldHaply : public HeldDevice {
  public:
    HeldHaply() {
        name(haply_.specification());
        title = "Haply Inverse3 (fake of its service)";
        model = "Haply";
        strip = "Grip of the Inverse3";
        device_class = DeviceClass::haptic;
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
    double force() const override { return std::max(haply_.rendered(0).norm(), haply_.rendered(1).norm()); }
    double commanded() const override { return std::max(haply_.force(0).norm(), haply_.force(1).norm()); }
    void break_it(DeviceFault fault) override {
        using Mode = fulcrum::test::FakeHaply::Mode;
        if (fault == DeviceFault::haply_message) haply_.mode = Mode::garbage;
        if (fault == DeviceFault::no_power) haply_.mode = Mode::no_power;
        if (fault == DeviceFault::haply_silent) haply_.mode = Mode::silent;
        if (fault == DeviceFault::haply_ended) haply_.hang_up();
        if (fault == DeviceFault::safety_brake)
            haply_.event("device-safety-triggered", "0A11", "ebrake_triggered");
    }
    void repair() override { haply_.mode = fulcrum::test::FakeHaply::Mode::good; }

  private:
    fulcrum::test::FakeHaply haply_{{{"0A11", "left"}, {"0B22", "right"}}, 2};
};

class HeldTracker : public HeldDevice {
  public:
    HeldTracker() {
        // The tool's z points away from the person, as an instrument does.
        name("openigtlink:" + tracker_->address() +
             ",left=LeftTipToPatient,right=RightTipToPatient,length=0,shaft=-z");
        title = "tracked instruments over OpenIGTLink";
        model = "OpenIGTLink";
        strip = "Tracked instrument";
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal, HandDeed::exchanged,
                           HandDeed::clutched});
    }
    void put(int hand, const Vector3& position) override {
        pose(hand).place = position;
        send();
    }
    void hold(int hand, const HeldParts& parts) override {
        pose(hand).rotation = Eigen::AngleAxisd(parts.roll, Vector3::UnitZ()).toRotationMatrix();
        parts_[static_cast<std::size_t>(hand)] = parts;
        constexpr const char* names[hand_count] = {"LeftJaw", "RightJaw"};
        jaws_.clear();
        for (std::size_t h = 0; h < hand_count; ++h) {
            const double values[] = {parts_[h].open, 1.0 * button_mask(parts_[h])};
            igtl::append_sensor(jaws_, names[h], 0, values, 2, igtl::unit_none);
        }
        send();
    }
    void break_it(DeviceFault fault) override {
        using Mode = fulcrum::test::FakeTracker::Mode;
        if (fault == DeviceFault::no_poses) tracker_->mode = Mode::silent;
        if (fault == DeviceFault::not_a_pose) tracker_->mode = Mode::not_a_number;
        if (fault == DeviceFault::wrong_checksum) tracker_->mode = Mode::wrong_checksum;
        if (fault == DeviceFault::not_openigtlink) tracker_->mode = Mode::garbage;
        if (fault == DeviceFault::connection_ended) tracker_.reset();
    }
    void repair() override {
        if (tracker_ == nullptr) tracker_ = make(port_);
        send();
        tracker_->mode = fulcrum::test::FakeTracker::Mode::good;
    }
    const char* refusal(DeviceFault fault) const override {
        if (fault == DeviceFault::not_openigtlink) return "check that this is the port of the OpenIGTLink";
        return fault == DeviceFault::connection_ended ? "no OpenIGTLink server answers" : "";
    }

  private:
    static std::unique_ptr<fulcrum::test::FakeTracker> make(int port) {
        return std::make_unique<fulcrum::test::FakeTracker>(
            std::vector<std::string>{"LeftTipToPatient", "RightTipToPatient"}, port);
    }
    igtl::Pose& pose(int hand) { return pose_[static_cast<std::size_t>(hand)]; }
    void send() {
        for (std::size_t h = 0; h < hand_count; ++h) tracker_->move(h, pose_[h]);
        tracker_->also_send(jaws_);
    }
    std::unique_ptr<fulcrum::test::FakeTracker> tracker_ = make(0);
    int port_ = tracker_->port();
    std::array<igtl::Pose, hand_count> pose_;
    std::array<HeldParts, hand_count> parts_;
    igtl::Bytes jaws_;  // nothing before they are held first
};

class HeldTrainer : public HeldDevice {
  public:
    HeldTrainer() {
        name(trainer_.specification());
        title = "box trainer on a serial port (pseudo-terminal)";
        model = "Box";
        strip = "Instrument of the trainer";
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed, HandDeed::pedal, HandDeed::exchanged,
                           HandDeed::clutched});
    }
    void put(int hand, const Vector3& position) override { trainer_.move(letter(hand), position); }
    void hold(int hand, const HeldParts& parts) override {
        trainer_.turn(letter(hand), parts.roll);
        trainer_.hold(letter(hand), static_cast<int>(std::lround(1000 * parts.open)), button_mask(parts));
    }
    Vector3 begin() const override { return {0, 0, 0.24}; }
    void break_it(DeviceFault fault) override {
        using Mode = fulcrum::test::FakeTrainer::Mode;
        if (fault == DeviceFault::trainer_silent) trainer_.mode = Mode::silent;
        if (fault == DeviceFault::trainer_lines) trainer_.mode = Mode::garbage;
        if (fault == DeviceFault::trainer_checksum) trainer_.mode = Mode::wrong_checksum;
        if (fault == DeviceFault::trainer_values) trainer_.mode = Mode::not_a_number;
        unplugged_ = fault == DeviceFault::trainer_unplugged;
        if (unplugged_) trainer_.unplug();
    }
    void repair() override {
        trainer_.mode = fulcrum::test::FakeTrainer::Mode::good;
        if (unplugged_) trainer_.plug();
        unplugged_ = false;
    }
    const char* refusal(DeviceFault fault) const override {
        return fault == DeviceFault::trainer_unplugged ? "plug the trainer in" : "";
    }

  private:
    static char letter(int hand) { return hand == 0 ? 'L' : 'R'; }
    fulcrum::test::FakeTrainer trainer_{"LR"};
    bool unplugged_ = false;
};

/// A joystick of SDL 2 whose six axes are the angles and the lengths of two instruments, with four buttons
/// each.
class HeldJoystick : public HeldDevice {
  public:
    explicit HeldJoystick(bool named)
        : file_(named ? (folder_.path() / "joystick.json").string() : joystick_file()) {
        if (named) name("joystick:" + file_);
        title = "HID joystick (fake of SDL 2)";
        model = stick_name;
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
            const double share = std::clamp((of_instrument[i] - least[i]) / (most[i] - least[i]), 0.0, 1.0);
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
    /// Or the library hangs.
    void break_it(DeviceFault fault) override {
        if (fault == DeviceFault::trainer_unplugged) stick().plugged = 0;
        if (fault == DeviceFault::servo_stopped) page_->hang = 1;
    }
    void repair() override {
        page_->hang = 0;
        stick().plugged = 1;
    }
    const char* refusal(DeviceFault fault) const override {
        return fault == DeviceFault::servo_stopped ? "unplug the joystick and connect it again"
                                                   : "of the name Odd Stick is connected; connect it";
    }

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
        model = "SpaceMouse";
        strip = "Cap to the side";
        device_class = DeviceClass::controller;
        is_pushed = true;
        moves[1] = false;
        own = these_deeds({HandDeed::rolled, HandDeed::jaws_closed});
    }
    void put(int hand, const Vector3& position) override {
        if (hand != 0) return;
        push_ = {counts_for(position.x()), counts_for(position.y()), counts_for(-position.z())};
        send();
    }
    void hold(int hand, const HeldParts& parts) override {
        if (hand != 0) return;
        turn_ = parts.roll != 0 ? full : 0;
        send();
        if (parts.closed != closed_) cap_->send_event(parts.closed ? 1 : 2, {0, parts.closed ? 1 : 0});
        closed_ = parts.closed;
    }
    /// The nearer, the slower: a window that looks seldom must not let it run past its instrument and away.
    void go_back(double distance) override {
        constexpr double near = 4e-3, counts_a_metre = 15000;
        push_ = {distance > near ? static_cast<int>(std::min<double>(full, counts_a_metre * distance)) : 0, 0,
                 0};
        send();
    }
    /// Ends, and is started again.
    void break_it(DeviceFault) override {
        push_ = {0, 0, 0};
        send();
        cap_.reset();
    }
    void repair() override { cap_ = std::make_unique<fulcrum::test::FakeSpacenavd>(path_, 1); }
    const char* refusal(DeviceFault) const override { return "systemctl restart spacenavd"; }

  private:
    static constexpr int full = 350;
    /// The nearer, the slower: the screen shows late where the instrument is.
    static int counts_for(double distance) {
        constexpr double arrives_in_s = 0.2;
        const double share = std::abs(distance) / (arrives_in_s * hapticd::space_mouse_speed);
        int counts = 0;
        while (counts < full && hapticd::space_mouse_response(counts) < share) ++counts;
        return distance < 0 ? -counts : counts;
    }
    void send() const { cap_->send_event(0, {push_[0], push_[1], push_[2], 0, turn_, 0, 16}); }
    fulcrum::test::OwnFolder folder_;
    std::string path_ = (folder_.path() / "spnav.sock").string();
    fulcrum::test::Variable socket_{"SPNAV_SOCKET", path_};
    std::unique_ptr<fulcrum::test::FakeSpacenavd> cap_ =
        std::make_unique<fulcrum::test::FakeSpacenavd>(path_, 1);
    std::array<int, 3> push_{0, 0, 0};
    int turn_ = 0;
    bool closed_ = false;
};

template <typename Device>
std::unique_ptr<HeldDevice> made_of_kind(bool) {
    return std::make_unique<Device>();
}
std::unique_ptr<HeldDevice> made_joystick(bool named) {
    return std::make_unique<HeldJoystick>(named);
}

}  // namespace

const std::vector<HeldKind>& held_kinds() {
    using F = DeviceFault;
    static const std::vector<HeldKind> kinds = {
        {"Touch", made_of_kind<HeldTouch>, {F::warm_motors, F::too_much_force, F::driver, F::firmware}},
        {"ForceDimension",
         made_of_kind<HeldForceDimension>,
         {F::needs_calibration, F::too_fast, F::switched_off, F::no_answer}},
        {"Haply",
         made_of_kind<HeldHaply>,
         {F::haply_message, F::no_power, F::safety_brake, F::haply_silent, F::haply_ended}},
        {"SpaceMouse", made_of_kind<HeldCap>, {F::spacenavd}},
        {"Tracker",
         made_of_kind<HeldTracker>,
         {F::no_poses, F::not_a_pose, F::wrong_checksum, F::not_openigtlink, F::connection_ended}},
        {"Trainer",
         made_of_kind<HeldTrainer>,
         {F::trainer_silent, F::trainer_lines, F::trainer_checksum, F::trainer_values, F::trainer_unplugged}},
        {"Joystick", made_joystick, {F::trainer_unplugged, F::servo_stopped}}};
    return kinds;
}

const HeldKind& held_kind(const std::string& name) {
    for (const HeldKind& kind : held_kinds())
        if (name == kind.name) return kind;
    throw std::invalid_argument(name);
}

std::unique_ptr<HeldDevice> make_held(const std::string& kind, bool named) {
    return held_kind(kind).make(named);
}

}  // namespace fulcrum::app::program_test
