// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/force_dimension_device.h"

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

constexpr double rate = 1000;  // Hz
constexpr std::int64_t period = 1'000'000, second_ns = 1000 * period;
constexpr std::uint64_t check_every = 20;           // ticks
constexpr std::int64_t rest_ns = 1000 * 1'000'000;  // from switching itself off to force again
constexpr double jaw_step = 1 / (0.15 * rate);      // of the opening a tick: a button closes jaws in 0.15 s
constexpr double widest_gripper = 0.5;              // rad
constexpr int servo_priority = 84;                  // below the device process
// The library states no limits. These are within those of the weakest device, the Falcon; the damping is that
// of Eq. 8 for the stiffness at this rate.
constexpr double peak_n = 8, continuous_n = 4, stiffness_n_m = 1000;

const DeviceRow& own_row() {
    return *device_row("force-dimension");
}

int number_of(const std::string& text, const std::string& specification) {
    if (text.empty()) return -1;
    if (text.size() > 1 || text[0] < '0' || text[0] > '9')
        throw InputError(
            "device", "", {QT_TRANSLATE_NOOP("errors", "'%1' does not number the devices"), specification},
            QT_TRANSLATE_NOOP(
                "errors",
                "write force-dimension:LEFT,RIGHT with numbers from 0 on, for example force-dimension:1,0"));
    return text[0] - '0';
}

}  // namespace

ForceDimensionNumbers force_dimension_numbers(const std::string& specification) {
    ForceDimensionNumbers numbers;
    const std::size_t colon = specification.find(':');
    if (colon == std::string::npos) return numbers;
    const std::string list = specification.substr(colon + 1);
    const std::size_t comma = list.find(',');
    numbers.given = true;
    numbers.hand[0] = number_of(list.substr(0, comma), specification);
    numbers.hand[1] = comma == std::string::npos ? -1 : number_of(list.substr(comma + 1), specification);
    if (comma == std::string::npos || numbers.hand[0] == numbers.hand[1])
        throw InputError(
            "device", "",
            {QT_TRANSLATE_NOOP("errors", "'%1' does not give each hand a device of its own"), specification},
            QT_TRANSLATE_NOOP("errors", "write force-dimension:LEFT,RIGHT, for example force-dimension:1,0"));
    return numbers;
}

/// What the maker publishes for its models, about the middle of the device; none: another model.
static std::optional<WorkspaceBox> workspace_of(const std::string& model) {
    struct Model {
        const char* name;
        double across, deep;  // m: diameter, depth towards the person
    };
    constexpr Model models[] = {{"omega", 0.16, 0.11},
                                {"delta", 0.40, 0.26},
                                {"sigma", 0.19, 0.13},
                                {"lambda", 0.24, 0.17},
                                {"falcon", 0.10, 0.10}};
    std::string small = model;
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const Model& one : models) {
        if (small.find(one.name) == std::string::npos) continue;
        const Vector3 half = 0.5 * Vector3(one.across, one.across, one.deep);
        return WorkspaceBox{-half, half};
    }
    return std::nullopt;
}

ForceDimensionDevice::ForceDimensionDevice(ForceDimensionNumbers numbers) : numbers_(numbers) {
    facts_.kind = "force-dimension";
    facts_.title = "Force Dimension";
    facts_.rate = rate;
}

Sentence ForceDimensionDevice::last_error() const {
    const char* const words = library_.last_error();
    return {QT_TRANSLATE_NOOP("errors", "the maker's driver reports %1"),
            "'" + std::string(words != nullptr ? words : "") + "'"};
}

void ForceDimensionDevice::open_hand(int hand, int number) {
    Hand& one = hands_[hand];
    const std::string shown = "device " + std::to_string(number);
    const bool opened = library_.open(static_cast<char>(number)) >= 0;
    if (!opened && names_firmware(library_.last_error()))
        throw InputError(own_row().title, shown,
                         {QT_TRANSLATE_NOOP("errors", "the device does not open: %1"), last_error()},
                         firmware_hint());
    if (!opened)
        refuse_to_open(
            own_row(), shown, {QT_TRANSLATE_NOOP("errors", "the device does not open: %1"), last_error()},
            QT_TRANSLATE_NOOP("errors", "check its cable and power, and end other programs that use it"));
    one.id = static_cast<char>(number);
    if (const char* const name = library_.name(one.id); name != nullptr && *name != '\0') facts_.title = name;
    if (library_.set_max_force(peak_n, one.id) < 0 || library_.enable_force(1, one.id) < 0)
        throw InputError(own_row().title, shown,
                         {QT_TRANSLATE_NOOP("errors", "force cannot be switched on: %1"), last_error()},
                         QT_TRANSLATE_NOOP("errors", "test the device with a program of the maker's SDK"));
    double angle = 0;
    one.gripper = library_.get_gripper(&angle, one.id) >= 0;
    ForceOutput force;
    force.peak = peak_n;
    force.continuous = continuous_n;
    force.stiffness = stiffness_n_m;
    force.damping = stiffness_n_m / (2 * rate);
    facts_.force[hand] = force;
    facts_.slot[hand] = true;
    facts_.clutch[hand] = true;
    facts_.workspace[hand] = workspace_of(facts_.title);
}

void ForceDimensionDevice::open() {
    require_ready(own_row(), library_.load());
    try {
        const int count = library_.device_count();
        if (count <= 0)
            refuse_to_open(own_row(), "", QT_TRANSLATE_NOOP("errors", "no device was found"),
                           QT_TRANSLATE_NOOP("errors", "connect it and its power supply"));
        if (!numbers_.given) {
            numbers_.hand[0] = count > 1 ? 0 : -1;
            numbers_.hand[1] = count > 1 ? 1 : 0;
        }
        for (int h = 0; h < 2; ++h)
            if (numbers_.hand[h] >= 0) open_hand(h, numbers_.hand[h]);
        runs_ = true;
        servo_ = std::thread([this] { run(); });
    } catch (...) {
        close();
        throw;
    }
}

void ForceDimensionDevice::close() noexcept {
    if (servo_.joinable()) {
        wait_for_servo();  // it sends the last force, which is 0
        runs_ = false;
        servo_.join();
    }
    for (Hand& one : hands_) {
        if (one.id < 0) continue;
        library_.enable_force(0, one.id);
        library_.close(one.id);
        one.id = -1;
    }
}

void ForceDimensionDevice::run() noexcept {
    sched_param parameter{};
    parameter.sched_priority = servo_priority;
    pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);  // the device process reports a refusal
    std::int64_t deadline = monotonic_ns();
    while (runs_.load(std::memory_order_relaxed)) {
        const std::int64_t now = monotonic_ns();
        for (int h = 0; h < 2; ++h)
            if (hands_[h].id >= 0) serve(h, now);
        ++ticks_;
        deadline = std::max(deadline + period, monotonic_ns() - period);
        timespec time{};
        time.tv_sec = deadline / second_ns;
        time.tv_nsec = deadline % second_ns;
        while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
        }
    }
}

void ForceDimensionDevice::check(Hand& one, std::int64_t now) noexcept {
    int status[dhd::status_count] = {};
    if (library_.get_status(status, one.id) < 0 || status[dhd::connected] == 0 || status[dhd::power] == 0 ||
        status[dhd::error] != 0 || (status[dhd::force] == 0 && status[dhd::force_off_cause] == dhd::usb)) {
        one.memory.see(names_firmware(library_.last_error()) ? DeviceFault::firmware : DeviceFault::no_answer,
                       now);
        return;
    }
    if (status[dhd::reset] != 0) one.memory.see(DeviceFault::needs_calibration, now);
    if (status[dhd::force] != 0) {
        one.slowed = 0;
        return;
    }
    const int cause = status[dhd::force_off_cause];
    if (cause != dhd::velocity && cause != dhd::watchdog) {  // a person did it, and a person undoes it
        one.memory.see(DeviceFault::switched_off, now);
        return;
    }
    one.memory.see(DeviceFault::too_fast, now);
    if (one.slowed == 0) one.slowed = now;
    if (now - one.slowed >= rest_ns) library_.enable_force(1, one.id);
}

bool ForceDimensionDevice::read_pose(Hand& one) noexcept {
    double x = 0, y = 0, z = 0, turn[3][3] = {}, angle = 0;
    if (library_.get_pose(&x, &y, &z, turn, one.id) < 0) return false;
    if (one.gripper && library_.get_gripper(&angle, one.id) < 0) return false;
    const unsigned int buttons = library_.get_buttons(one.id);
    one.last.position[0] = y;
    one.last.position[1] = z;
    one.last.position[2] = x;
    // The twist about x, which points to the person; the roll is positive from trocar to tip, away from it.
    one.last.roll = -2 * std::atan2(turn[2][1] - turn[1][2], 1 + turn[0][0] + turn[1][1] + turn[2][2]);
    if (one.gripper) {
        one.jaw = std::clamp(angle / widest_gripper, 0.0, 1.0);
        one.last.buttons = ((buttons & 1U) != 0 ? unsigned{button_energy} : 0U) |
                           ((buttons & 2U) != 0 ? unsigned{button_clutch} : 0U);
    } else {
        one.jaw += std::clamp(((buttons & 1U) != 0 ? 0 : 1) - one.jaw, -jaw_step, jaw_step);
        one.last.buttons = ((buttons & 2U) != 0 ? unsigned{button_energy} : 0U) |
                           ((buttons & 4U) != 0 ? unsigned{button_exchange} : 0U) |
                           ((buttons & 8U) != 0 ? unsigned{button_clutch} : 0U);
    }
    one.last.jaw = one.jaw;
    return true;
}

void ForceDimensionDevice::serve(int hand, std::int64_t now) noexcept {
    Hand& one = hands_[hand];
    if (ticks_ % check_every == 0) check(one, now);
    if (!read_pose(one)) one.memory.see(DeviceFault::no_answer, now);
    const bool good = one.memory.at(now) == DeviceFault::none;
    const Vector3 force = good ? wanted_force(hand, now) : Vector3::Zero();
    if (library_.set_force(force.z(), force.x(), force.y(), 0, 0, 0, 0, one.id) < 0)
        one.memory.see(DeviceFault::no_answer, now);
    const DeviceFault fault = one.memory.at(now);
    if (fault != DeviceFault::none) one.last.buttons = button_none;
    one.last.fault = static_cast<std::uint64_t>(fault);
    publish(hand, one.last);
}

}  // namespace fulcrum::hapticd
