// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/touch_device.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::hapticd {
namespace {

constexpr double rate = 1000;                   // Hz
constexpr std::uint64_t calibrate_every = 100;  // ticks
constexpr double jaw_step = 1 / (0.15 * rate);  // of the opening a tick: a button closes jaws in 0.15 s
constexpr int most_errors = 16;                 // taken from the queue at a time
constexpr int most_inits = 10;
// Where a driver reports limits that are not possible: those of the smallest device of the series.
constexpr double peak_n = 3.3, continuous_n = 0.88, stiffness_n_mm = 0.4;

const DeviceRow& own_row() {
    return *device_row("touch");
}

std::string number_words(std::uint32_t code) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%04x", code);
    return text;
}

DeviceFault fault_of(std::uint32_t code) noexcept {
    if (code == hd::warm_motors) return DeviceFault::warm_motors;
    if (code == hd::exceeded_max_velocity) return DeviceFault::too_fast;
    if (code > hd::warm_motors && code <= hd::force_error) return DeviceFault::too_much_force;
    if (code >= hd::device_fault && code <= hd::timer_error) return DeviceFault::no_answer;
    return DeviceFault::driver;
}

double in_range(double value, double low, double high, double otherwise) {
    return value >= low && value <= high ? value : otherwise;
}

}  // namespace

TouchNames touch_names(const std::string& specification) {
    TouchNames names;
    const std::size_t colon = specification.find(':');
    if (colon == std::string::npos) {
        names.hand[1] = "";
        return names;
    }
    const std::string list = specification.substr(colon + 1);
    const std::size_t comma = list.find(',');
    if (comma == std::string::npos || list.size() == 1 || list.find(',', comma + 1) != std::string::npos)
        throw InputError(
            "device", "", {QT_TRANSLATE_NOOP("errors", "'%1' does not name the devices"), specification},
            QT_TRANSLATE_NOOP("errors",
                              "write touch:LEFT,RIGHT with the names that the maker's setup program shows"));
    if (comma > 0) names.hand[0] = list.substr(0, comma);
    if (comma + 1 < list.size()) names.hand[1] = list.substr(comma + 1);
    if (names.hand[0] == names.hand[1])
        throw InputError("device", "",
                         {QT_TRANSLATE_NOOP("errors", "'%1' names one device for both hands"), specification},
                         QT_TRANSLATE_NOOP("errors", "give each hand a device of its own"));
    return names;
}

TouchDevice::TouchDevice(TouchNames names) : names_(std::move(names)) {
    facts_.kind = "touch";
    facts_.title = "3D Systems Touch";
    facts_.rate = rate;
}

std::uint32_t TouchDevice::first_error() noexcept {
    std::uint32_t first = hd::success;
    for (int i = 0; i < most_errors; ++i) {
        const hd::ErrorInfo error = library_.get_error();
        if (error.code == hd::success) break;
        if (first == hd::success) first = error.code;
    }
    return first;
}

/// As the place of an error.
static std::string shown_name(const std::string& name) {
    return name.empty() ? "default device" : name;
}

std::string TouchDevice::words_of_error(std::uint32_t code) const {
    const char* const words = library_.error_string(code);
    return number_words(code) + (words != nullptr && *words != '\0' ? " " + std::string(words) : "");
}

hd::Handle TouchDevice::init(const std::string& name) {
    // Which name the default device has depends on the version of the driver.
    const char* const names[] = {name.empty() ? nullptr : name.c_str(), "Default Device", "Default PHANToM"};
    std::uint32_t error = hd::success;
    for (std::size_t i = 0; i < (name.empty() ? std::size(names) : 1); ++i) {
        for (int again = 0; again < most_inits; ++again) {
            const hd::Handle handle = library_.init_device(names[i]);
            const std::uint32_t code = first_error();
            if (code == hd::success && handle != hd::invalid_handle) return handle;
            if (error == hd::success || code == hd::invalid_license) error = code;
            if (handle != hd::invalid_handle) library_.disable_device(handle);
            first_error();
            if (code != hd::already_initiated) break;
        }
        if (error == hd::invalid_license) break;
    }
    const std::string shown = shown_name(name);
    const Sentence said(QT_TRANSLATE_NOOP("errors", "the maker's driver reports %1"), words_of_error(error));
    if (error == hd::invalid_license)
        throw InputError(own_row().title, shown, said,
                         QT_TRANSLATE_NOOP("errors", "install the licence of OpenHaptics"));
    if (names_firmware(library_.error_string(error)))
        throw InputError(own_row().title, shown, said, firmware_hint());
    if (error == hd::already_initiated)
        throw InputError(own_row().title, shown, said,
                         QT_TRANSLATE_NOOP("errors", "end the other program that uses the device"));
    if (fault_of(error) == DeviceFault::no_answer)
        refuse_to_open(
            own_row(), shown, {QT_TRANSLATE_NOOP("errors", "the device does not answer: %1"), said},
            QT_TRANSLATE_NOOP("errors",
                              "check its cable and power, then test it with the maker's Touch Diagnostic"));
    throw InputError(
        own_row().title, shown, said,
        QT_TRANSLATE_NOOP(
            "errors", "check the device's name in the maker's Touch Setup; touch:LEFT,RIGHT names devices"));
}

void TouchDevice::read_limits(int hand) {
    double stiffness = 0, peak = 0, continuous = 0;
    library_.get_double(hd::nominal_max_stiffness, &stiffness);
    library_.get_double(hd::nominal_max_force, &peak);
    library_.get_double(hd::nominal_continuous_force, &continuous);
    std::int32_t styles = 0;
    library_.get_integer(hd::calibration_style, &styles);
    first_error();
    ForceOutput force;
    force.peak = in_range(peak, 0.1, 50, peak_n);
    force.continuous = std::min(in_range(continuous, 0.05, 50, continuous_n), force.peak);
    force.stiffness = 1000 * in_range(stiffness, 0.05, 10, stiffness_n_mm);
    // The maker states that the device renders this stiffness at this rate; by Eq. 8 it then has at least
    // this damping.
    force.damping = force.stiffness / (2 * rate);
    facts_.force[hand] = force;
    const auto has = [styles](hd::CalibrationStyle style) {
        return (static_cast<std::uint32_t>(styles) & style) != 0;
    };
    hands_[hand].style = has(hd::automatic) ? hd::automatic : has(hd::inkwell) ? hd::inkwell : 0U;
}

void TouchDevice::read_workspace(int hand) {
    double mm[6] = {};
    library_.get_double(hd::usable_workspace, mm);
    const WorkspaceBox box{1e-3 * Vector3(mm[0], mm[1], mm[2]), 1e-3 * Vector3(mm[3], mm[4], mm[5])};
    const bool stated = first_error() == hd::success && is_usable(box);
    facts_.workspace[hand] = stated ? box : published_workspace(own_row());
}

void TouchDevice::read_versions() {
    const char* const driver = library_.get_string(hd::device_driver_version);
    if (driver != nullptr && *driver != '\0') facts_.firmware = "driver " + std::string(driver);
    double firmware = 0;
    library_.get_double(hd::device_firmware_version, &firmware);
    if (first_error() == hd::success && std::isfinite(firmware) && firmware > 0)
        facts_.firmware += (facts_.firmware.empty() ? "firmware " : ", firmware ") +
                           decimal_text(firmware, firmware == std::floor(firmware) ? 0 : 2);
}

void TouchDevice::open_hand(int hand, const std::string& name) {
    Hand& one = hands_[hand];
    one.handle = init(name);
    library_.make_current(one.handle);
    const char* const model = library_.get_string(hd::device_model_type);
    if (model != nullptr && *model != '\0') facts_.title = "3D Systems " + std::string(model);
    read_limits(hand);
    read_workspace(hand);
    read_versions();
    library_.enable(hd::force_output);
    library_.enable(hd::max_force_clamping);
    if (const std::uint32_t error = first_error(); error != hd::success)
        throw InputError(
            own_row().title, shown_name(name),
            {QT_TRANSLATE_NOOP("errors", "force cannot be switched on: %1"), words_of_error(error)},
            QT_TRANSLATE_NOOP("errors", "test the device with the maker's Touch Diagnostic"));
    facts_.slot[hand] = true;
}

void TouchDevice::open() {
    require_ready(own_row(), library_.load());
    try {
        for (int h = 0; h < 2; ++h)
            if (names_.hand[h]) open_hand(h, *names_.hand[h]);
        library_.set_rate(static_cast<unsigned long>(rate));
        scheduled_ = library_.schedule(&TouchDevice::servo, this, hd::highest_priority);
        library_.start_scheduler();
        running_ = true;
        if (const std::uint32_t error = first_error(); error != hd::success)
            throw InputError(
                own_row().title, "",
                {QT_TRANSLATE_NOOP("errors", "the maker's driver does not start: %1"), words_of_error(error)},
                QT_TRANSLATE_NOOP("errors",
                                  "unplug the device, connect it again and test it with Touch Diagnostic"));
    } catch (...) {
        close();
        throw;
    }
}

void TouchDevice::close() noexcept {
    if (running_) {
        wait_for_servo();  // it sends the last force, which is 0
        library_.stop_scheduler();
        library_.unschedule(scheduled_);
        running_ = false;
    }
    for (Hand& one : hands_) {
        if (one.handle != hd::invalid_handle) library_.disable_device(one.handle);
        one.handle = hd::invalid_handle;
    }
}

std::uint32_t TouchDevice::servo(void* device) noexcept {
    static_cast<TouchDevice*>(device)->tick();
    return hd::callback_continue;
}

void TouchDevice::tick() noexcept {
    const std::int64_t now = monotonic_ns();
    for (int h = 0; h < 2; ++h)
        if (hands_[h].handle != hd::invalid_handle) serve(h, now);
    ++ticks_;
}

void TouchDevice::calibrate(Hand& one) noexcept {
    library_.make_current(one.handle);
    one.state = library_.check_calibration();
    if (one.state == hd::needs_update && one.style != 0) library_.update_calibration(one.style);
}

void TouchDevice::serve(int hand, std::int64_t now) noexcept {
    Hand& one = hands_[hand];
    if (ticks_ % calibrate_every == 0) calibrate(one);
    if (one.state != hd::calibrated) one.memory.see(DeviceFault::needs_calibration, now);
    library_.begin_frame(one.handle);
    double position[3] = {}, gimbal[3] = {};
    std::int32_t buttons = 0;
    library_.get_double(hd::current_position, position);
    library_.get_double(hd::current_gimbal_angles, gimbal);
    library_.get_integer(hd::current_buttons, &buttons);
    const bool good = one.memory.at(now) == DeviceFault::none;
    const Vector3 force = good ? wanted_force(hand, now) : Vector3::Zero();
    const double sent[3] = {force.x(), force.y(), force.z()};
    library_.set_double(hd::current_force, sent);
    library_.end_frame(one.handle);
    take_errors(hand, now);
    const auto fault = one.memory.at(now);
    if (fault == DeviceFault::none) {
        for (int axis = 0; axis < 3; ++axis) one.last.position[axis] = 1e-3 * position[axis];
        one.last.roll = gimbal[2];
        const double wanted = (buttons & 1) != 0 ? 0 : 1;
        one.jaw += std::clamp(wanted - one.jaw, -jaw_step, jaw_step);
        one.last.jaw = one.jaw;
        one.last.buttons = (buttons & 2) != 0 ? button_energy : button_none;
    } else {
        one.last.buttons = button_none;
    }
    one.last.fault = static_cast<std::uint64_t>(fault);
    publish(hand, one.last);
}

void TouchDevice::take_errors(int hand, std::int64_t now) noexcept {
    for (int i = 0; i < most_errors; ++i) {
        const hd::ErrorInfo error = library_.get_error();
        if (error.code == hd::success) return;
        const int other = 1 - hand;
        const bool of_other =
            hands_[other].handle != hd::invalid_handle && error.device == hands_[other].handle;
        DeviceFault fault = fault_of(error.code);
        if (fault == DeviceFault::no_answer && names_firmware(library_.error_string(error.code)))
            fault = DeviceFault::firmware;
        hands_[of_other ? other : hand].memory.see(fault, now);
    }
}

}  // namespace fulcrum::hapticd
