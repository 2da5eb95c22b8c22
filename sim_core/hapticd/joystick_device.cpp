// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/joystick_device.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "sim_core/hapticd/trainer_device.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

constexpr auto joystick_period = std::chrono::milliseconds(4);
constexpr auto joystick_patience = std::chrono::seconds(3);
constexpr std::int64_t joystick_silence = 500LL * 1'000'000;  // ns: the library hangs
constexpr double joystick_length = 0.34;                      // m from handle to tip

}  // namespace

JoystickSpecification joystick_specification(const std::string& specification) {
    const std::size_t colon = specification.find(':');
    const std::string rest = colon == std::string::npos ? std::string() : specification.substr(colon + 1);
    JoystickSpecification wanted;
    if (rest == "raw" || rest.rfind("raw,", 0) == 0) {
        if (rest.size() > 4) wanted.name = rest.substr(4);
        return wanted;
    }
    if (rest.empty())
        throw InputError("joystick", "", QT_TRANSLATE_NOOP("errors", "is not calibrated"),
                         QT_TRANSLATE_NOOP("errors",
                                           "run `fulcrum devices --calibrate joystick`, or use the button "
                                           "Calibrate on the page Settings"));
    wanted.mapping = read_joystick_mapping(rest);
    wanted.name = wanted.mapping->name;
    return wanted;
}

JoystickDevice::~JoystickDevice() {
    if (shared_ == nullptr) return;
    std::unique_lock lock(shared_->mutex);
    shared_->stop = true;
    shared_->changed.notify_all();
    shared_->changed.wait_for(lock, joystick_patience, [this] { return shared_->ended; });
}

void JoystickDevice::run(const std::shared_ptr<Shared>& shared, const std::string& name) {
    try {
        Joystick joystick(name);
        Read now;
        if (!joystick.read(now.now)) shared->gone = true;
        {
            const std::lock_guard lock(shared->mutex);
            shared->name = joystick.name();
            shared->axes = joystick.axes();
            shared->opened = true;
            shared->changed.notify_all();
        }
        auto next = std::chrono::steady_clock::now();
        for (bool stop = false; !stop && !shared->gone;) {
            now.time = monotonic_ns();
            ++now.count;
            shared->newest.write(now);
            next = std::max(next + joystick_period, std::chrono::steady_clock::now() - joystick_period);
            {
                std::unique_lock lock(shared->mutex);
                shared->changed.wait_until(lock, next, [&] { return shared->stop; });
                stop = shared->stop;
            }
            if (!joystick.read(now.now)) shared->gone = true;
        }
    } catch (const InputError&) {
        const std::lock_guard lock(shared->mutex);
        shared->error = std::current_exception();
    }
    const std::lock_guard lock(shared->mutex);
    shared->ended = true;
    shared->changed.notify_all();
}

void JoystickDevice::open() {
    shared_ = std::make_shared<Shared>();
    std::thread([shared = shared_, name = wanted_.name] { run(shared, name); }).detach();
    std::unique_lock lock(shared_->mutex);
    shared_->changed.wait_for(lock, joystick_patience, [this] { return shared_->opened || shared_->ended; });
    if (shared_->error) std::rethrow_exception(shared_->error);
    if (!shared_->opened)
        throw InputError("joystick", "", QT_TRANSLATE_NOOP("errors", "the library SDL 2 does not answer"),
                         QT_TRANSLATE_NOOP("errors", "unplug the joystick and connect it again"));
    facts_.kind = "joystick";
    facts_.title = shared_->name;
    for (int h = 0; h < 2; ++h) {
        facts_.slot[h] = !wanted_.mapping || wanted_.mapping->part[h].used();
        facts_.clutch[h] = facts_.slot[h] && wanted_.mapping && wanted_.mapping->part[h].clutch >= 0;
    }
    if (!wanted_.mapping) return;
    for (const JoystickPart& part : wanted_.mapping->part)
        for (const JoystickAxis& axis : part.motion)
            if (axis.axis >= shared_->axes)
                throw InputError(
                    "joystick", "",
                    {QT_TRANSLATE_NOOP("errors", "%1 has fewer axes than it was calibrated with"),
                     shared_->name},
                    QT_TRANSLATE_NOOP("errors",
                                      "calibrate it again: `fulcrum devices --calibrate joystick`"));
}

/// As a trainer's pose.
void JoystickDevice::move(const Read& newest, std::int64_t now, DevicePose (&poses)[device_slots]) noexcept {
    for (int h = 0; h < 2; ++h) {
        if (!facts_.slot[h]) continue;
        const JoystickPart& part = wanted_.mapping->part[h];
        const auto value = [&](JoystickMotion motion) {
            return part.motion[static_cast<int>(motion)].value(newest.now);
        };
        if (newest.count != last_.count) {
            TrainerPose pose;
            pose.pitch = value(JoystickMotion::pitch);
            pose.yaw = value(JoystickMotion::yaw);
            pose.insertion = value(JoystickMotion::insertion);
            pose.roll = value(JoystickMotion::roll);
            handle_[h].take(handle_of(pose, joystick_length), now);
        }
        const TrackedHandle& handle = handle_[h].at(now);
        for (int axis = 0; axis < 3; ++axis) poses[h].position[axis] = handle.position[axis];
        poses[h].roll = handle.roll;
        poses[h].jaw = value(JoystickMotion::jaw);
        const auto pressed = [&](int button) {
            return button >= 0 && (newest.now.buttons >> static_cast<unsigned>(button) & 1U) != 0;
        };
        poses[h].buttons = (pressed(part.jaws) ? unsigned{button_primary} : 0U) |
                           (pressed(part.energy) ? unsigned{button_energy} : 0U) |
                           (pressed(part.exchange) ? unsigned{button_exchange} : 0U) |
                           (pressed(part.clutch) ? unsigned{button_clutch} : 0U);
    }
}

void JoystickDevice::read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept {
    Read newest = last_;
    shared_->newest.read(newest);
    // A joystick reports changes alone: that it is there is known from the library.
    if (fault_ == DeviceFault::none && shared_->gone) fault_ = DeviceFault::trainer_unplugged;
    if (fault_ == DeviceFault::none && newest.time != 0 && now - newest.time > joystick_silence)
        fault_ = DeviceFault::servo_stopped;
    const bool present = fault_ == DeviceFault::none && newest.count > 0;
    ++sequence_;
    if (wanted_.mapping)
        move(newest, now, poses);
    else
        put_raw(newest.now, most_joystick_axes, poses);
    std::uint64_t absent = 0;
    for (int h = 0; h < 2; ++h) {
        if (!facts_.slot[h]) continue;
        poses[h].sequence = sequence_;
        poses[h].present = present ? 1 : 0;
        if (!present) {
            poses[h].buttons = 0;
            absent |= std::uint64_t{1} << static_cast<unsigned>(h);
        }
    }
    last_ = newest;
    report_.fault = static_cast<std::uint64_t>(fault_);
    report_.hands = fault_ == DeviceFault::none ? 0 : absent;
}

}  // namespace fulcrum::hapticd
