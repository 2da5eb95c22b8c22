// SPDX-License-Identifier: GPL-3.0-or-later
// Devices that a test moves, breaks and repairs: each behind its real entry, with a fake of its maker's
// library, its service, its server or its port. Together they have every DeviceFault.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "sim_core/controllers/joystick_mapping.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/numerics/files.h"
#include "tests/fakes/fake_force_dimension.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/fakes/fake_touch.h"
#include "tests/support/built.h"
#include "tests/support/fake_haply.h"
#include "tests/support/fake_spacenavd.h"
#include "tests/support/fake_tracker.h"
#include "tests/support/fake_trainer.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {

class Breakable {
  public:
    virtual ~Breakable() = default;
    /// Device frame of docs/DEVICES.md, m.
    virtual void put(int hand, const Vector3& position) = 0;
    virtual Vector3 begin() const { return Vector3::Zero(); }
    /// Has this fault until it is repaired; one of those of its kind.
    virtual void break_it(DeviceFault fault) = 0;
    virtual void repair() = 0;
    /// What is said where it is opened again in vain while it has this fault; empty: it opens.
    virtual const char* refusal(DeviceFault /*fault*/) const { return ""; }
    /// Begins at 0 when it is opened again: moves it on towards its instrument, which is so far away (m).
    virtual void go_back(double /*distance*/) {}
    virtual double force() const { return 0; }  ///< N, what the device got last
    const char *lines = "", *title = "";
    const char* library = "";  ///< of its maker
    DeviceClass device_class = DeviceClass::tracked;
    bool feels() const { return device_class == DeviceClass::haptic; }
};

class BreakableTouch : public Breakable {
  public:
    static std::vector<DeviceFault> faults() {
        return {DeviceFault::warm_motors, DeviceFault::too_much_force, DeviceFault::driver,
                DeviceFault::firmware};
    }
    BreakableTouch() {
        lines = "Stylus";
        title = "3D Systems Touch";
        library = "libHD.so";
        device_class = DeviceClass::haptic;
    }
    void put(int hand, const Vector3& p) override {
        for (int axis = 0; axis < 3; ++axis) page_->device[hand].position[axis] = 1e3 * p[axis];
    }
    void break_it(DeviceFault fault) override {
        page_->old_firmware = fault == DeviceFault::firmware ? 1 : 0;
        page_->device[1].tick_error = fault == DeviceFault::warm_motors      ? 0x0200
                                      : fault == DeviceFault::too_much_force ? 0x0201
                                      : fault == DeviceFault::driver         ? 0x0103
                                                                             : 0x0300;
    }
    void repair() override { page_->device[1].tick_error = page_->old_firmware = 0; }
    double force() const override {
        double most = 0;
        for (const auto& device : page_->device)
            for (const auto& f : device.force) most = std::max(most, std::abs(f.load()));
        return most;
    }

  private:
    fulcrum::test::FakePage<fulcrum::test::FakeTouchPage> page_{"FAKE_TOUCH_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBHD", fulcrum::test::fake_library("libHD.so")};
    fulcrum::test::Variable device_{"FULCRUM_DEVICE", "touch:Left Device,Right Device"};
};

class BreakableForceDimension : public Breakable {
  public:
    static std::vector<DeviceFault> faults() {
        return {DeviceFault::needs_calibration, DeviceFault::too_fast, DeviceFault::switched_off,
                DeviceFault::no_answer};
    }
    BreakableForceDimension() {
        lines = "Handle of the device";
        title = "omega.7";
        library = "libdrd.so";
        device_class = DeviceClass::haptic;
    }
    void put(int hand, const Vector3& p) override {
        const double place[3] = {p.z(), p.x(), p.y()};  // towards the person, to the right, up
        for (int axis = 0; axis < 3; ++axis) page_->device[hand].position[axis] = place[axis];
    }
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
    double force() const override {
        double most = 0;
        for (const auto& device : page_->device)
            for (const auto& f : device.force) most = std::max(most, std::abs(f.load()));
        return most;
    }

  private:
    static constexpr int reset = 3, force_on = 5, force_off_cause = 14, by_button = 1, by_velocity = 2;
    fulcrum::test::FakePage<fulcrum::test::FakeForceDimensionPage> page_{"FAKE_FORCE_DIMENSION_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBDRD", fulcrum::test::fake_library("libdrd.so")};
    fulcrum::test::Variable device_{"FULCRUM_DEVICE", "force-dimension"};
};

class BreakableHaply : public Breakable {
  public:
    static std::vector<DeviceFault> faults() {
        return {DeviceFault::haply_message, DeviceFault::no_power, DeviceFault::safety_brake,
                DeviceFault::haply_silent, DeviceFault::haply_ended};
    }
    BreakableHaply() {
        lines = "Grip of the Inverse3";
        title = "Haply";
        device_class = DeviceClass::haptic;
        for (int hand = 0; hand < hand_count; ++hand) BreakableHaply::put(hand, BreakableHaply::begin());
    }
    void put(int hand, const Vector3& p) override {
        haply_.move(static_cast<std::size_t>(hand), Vector3(p.x(), -p.z(), p.y()));
    }
    Vector3 begin() const override { return {0.01, 0.1, 0.15}; }
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
    double force() const override { return std::max(haply_.rendered(0).norm(), haply_.rendered(1).norm()); }

  private:
    fulcrum::test::FakeHaply haply_{{{"0A11", "left"}, {"0B22", "right"}}};
    fulcrum::test::Variable device_{"FULCRUM_DEVICE", haply_.specification()};
};

class BreakableTracker : public Breakable {
  public:
    static std::vector<DeviceFault> faults() {
        return {DeviceFault::no_poses, DeviceFault::not_a_pose, DeviceFault::wrong_checksum,
                DeviceFault::not_openigtlink, DeviceFault::connection_ended};
    }
    BreakableTracker() {
        lines = "Tracked instrument";
        title = "OpenIGTLink";
    }
    void put(int hand, const Vector3& position) override {
        place_[hand] = position;
        igtl::Pose pose;
        pose.place = position;
        tracker_->move(static_cast<std::size_t>(hand), pose);
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
        for (int hand = 0; hand < hand_count; ++hand) BreakableTracker::put(hand, place_[hand]);
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
    Vector3 place_[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    std::unique_ptr<fulcrum::test::FakeTracker> tracker_ = make(0);
    int port_ = tracker_->port();
    fulcrum::test::Variable device_{
        "FULCRUM_DEVICE",
        "openigtlink:" + tracker_->address() + ",left=LeftTipToPatient,right=RightTipToPatient,length=0"};
};

/// A deflection is a speed: a place is reached where the cap is let go.
class BreakableSpaceMouse : public Breakable {
  public:
    static std::vector<DeviceFault> faults() { return {DeviceFault::spacenavd}; }
    BreakableSpaceMouse() {
        lines = "Cap to the side";
        title = "SpaceMouse";
        device_class = DeviceClass::controller;
    }
    void put(int, const Vector3&) override { push(full); }
    /// The nearer, the slower: a window that looks seldom must not let it run past its instrument and away.
    void go_back(double distance) override {
        constexpr double near = 4e-3, counts_a_metre = 15000;
        push(distance > near ? static_cast<int>(std::min<double>(full, counts_a_metre * distance)) : 0);
    }
    /// Ends, and is started again.
    void break_it(DeviceFault) override {
        push(0);
        cap_.reset();
    }
    void repair() override { cap_ = std::make_unique<fulcrum::test::FakeSpacenavd>(path_, 1); }
    const char* refusal(DeviceFault) const override { return "systemctl restart spacenavd"; }

  private:
    static constexpr int full = 350;
    void push(int counts) const { cap_->send_event(0, {counts, 0, 0, 0, 0, 0, 16}); }
    fulcrum::test::OwnFolder folder_;
    std::string path_ = (folder_.path() / "spnav.sock").string();
    fulcrum::test::Variable socket_{"SPNAV_SOCKET", path_};
    std::unique_ptr<fulcrum::test::FakeSpacenavd> cap_ =
        std::make_unique<fulcrum::test::FakeSpacenavd>(path_, 1);
    fulcrum::test::Variable device_{"FULCRUM_DEVICE", "space-mouse:left"};
};

class BreakableTrainer : public Breakable {
  public:
    static std::vector<DeviceFault> faults() {
        return {DeviceFault::trainer_silent, DeviceFault::trainer_lines, DeviceFault::trainer_checksum,
                DeviceFault::trainer_values, DeviceFault::trainer_unplugged};
    }
    BreakableTrainer() {
        lines = "Instrument of the trainer";
        title = "Box";
    }
    void put(int hand, const Vector3& handle) override { trainer_.move(hand == 0 ? 'L' : 'R', handle); }
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
    fulcrum::test::FakeTrainer trainer_{"LR"};
    bool unplugged_ = false;
    fulcrum::test::Variable device_{"FULCRUM_DEVICE", trainer_.specification()};
};

/// A joystick of SDL 2 whose six axes are the angles and the lengths of two instruments.
class BreakableJoystick : public Breakable {
  public:
    static std::vector<DeviceFault> faults() {
        return {DeviceFault::trainer_unplugged, DeviceFault::servo_stopped};
    }
    BreakableJoystick() {
        lines = "Instrument on the joystick";
        title = name;
        page_->controller[0].known = 0;
        std::snprintf(page_->controller[0].name, sizeof page_->controller[0].name, "%s", name);
        for (int hand = 0; hand < hand_count; ++hand)
            BreakableJoystick::put(hand, BreakableJoystick::begin());
        page_->controller[0].plugged = 1;
        write_whole_file(file_, joystick_mapping_text(mapping()));
    }
    void put(int hand, const Vector3& handle) override {
        const Vector3 to_the_tip = -handle.normalized();
        const double of_instrument[] = {std::asin(to_the_tip.y()),
                                        std::atan2(to_the_tip.x(), -to_the_tip.z()),
                                        fulcrum::test::trainer_length - handle.norm()};
        for (int i = 0; i < axes_of_hand; ++i) {
            const double share = (of_instrument[i] - least[i]) / (most[i] - least[i]);
            page_->controller[0].axis[axes_of_hand * hand + i] =
                static_cast<std::int32_t>(std::lround(65535 * share)) - 32768;
        }
    }
    Vector3 begin() const override { return {0, 0, 0.24}; }
    /// Or the library hangs.
    void break_it(DeviceFault fault) override {
        if (fault == DeviceFault::trainer_unplugged) page_->controller[0].plugged = 0;
        if (fault == DeviceFault::servo_stopped) page_->hang = 1;
    }
    void repair() override {
        page_->hang = 0;
        page_->controller[0].plugged = 1;
    }
    const char* refusal(DeviceFault fault) const override {
        return fault == DeviceFault::servo_stopped ? "unplug the joystick and connect it again"
                                                   : "of the name Odd Stick is connected; connect it";
    }

  private:
    static constexpr int axes_of_hand = 3;
    static constexpr double least[axes_of_hand] = {-0.8, -0.8, 0}, most[axes_of_hand] = {0.8, 0.8, 0.3};
    static constexpr const char* name = "Odd Stick";
    static JoystickMapping mapping() {
        JoystickMapping made;
        made.name = name;
        for (int hand = 0; hand < hand_count; ++hand)
            for (int i = 0; i < axes_of_hand; ++i) {
                JoystickAxis& axis = made.part[hand].motion[i];
                axis.axis = axes_of_hand * hand + i;
                axis.at_low = least[i];
                axis.at_high = most[i];
                axis.at_rest = 0.5 * (least[i] + most[i]);
            }
        return made;
    }
    fulcrum::test::FakePage<fulcrum::test::FakeSdlPage> page_{"FAKE_SDL_PAGE"};
    fulcrum::test::Variable library_{"FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so")};
    fulcrum::test::OwnFolder folder_;
    std::string file_ = (folder_.path() / "joystick.json").string();
    fulcrum::test::Variable device_{"FULCRUM_DEVICE", "joystick:" + file_};
};

struct BreakableKind {
    const char* name;
    std::unique_ptr<Breakable> (*make)();
    std::vector<DeviceFault> (*faults)();
};
template <typename Device>
std::unique_ptr<Breakable> make_breakable() {
    return std::make_unique<Device>();
}
inline constexpr BreakableKind breakable_kinds[] = {
    {"Touch", make_breakable<BreakableTouch>, BreakableTouch::faults},
    {"ForceDimension", make_breakable<BreakableForceDimension>, BreakableForceDimension::faults},
    {"Haply", make_breakable<BreakableHaply>, BreakableHaply::faults},
    {"SpaceMouse", make_breakable<BreakableSpaceMouse>, BreakableSpaceMouse::faults},
    {"OpenIGTLink", make_breakable<BreakableTracker>, BreakableTracker::faults},
    {"Trainer", make_breakable<BreakableTrainer>, BreakableTrainer::faults},
    {"Joystick", make_breakable<BreakableJoystick>, BreakableJoystick::faults}};

}  // namespace fulcrum::app::program_test
