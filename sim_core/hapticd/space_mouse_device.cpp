// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/space_mouse_device.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "sim_core/devices/spacenavd_socket.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

constexpr std::int32_t greeting = 0x7faa5501, greeting_mask = 0x7fffff00;
constexpr int greeting_limit_ms = 300;
constexpr double dead_zone = 0.04, linear_part = 0.25;
constexpr std::int64_t held_limit = 300'000'000;  // ns: a cap that is held sends more often than this
constexpr double longest_step = 4e-3;             // s: a process that was held up makes no jump
constexpr std::int32_t largest_kind = 15, largest_count = 4096;
enum EventKindOfSpnav : std::int32_t { spnav_motion, spnav_press, spnav_release };

}  // namespace

double space_mouse_response(std::int32_t counts) noexcept {
    const double pushed = std::min(std::abs(static_cast<double>(counts)) / space_mouse_full, 1.0);
    const double beyond = (pushed - dead_zone) / (1 - dead_zone);
    if (!(beyond > 0)) return 0;
    return std::copysign(beyond * (linear_part + (1 - linear_part) * beyond * beyond), counts);
}

int space_mouse_slot(const std::string& specification) {
    constexpr const char* words[device_slots] = {"space-mouse:left", "space-mouse:right",
                                                 "space-mouse:scope"};
    for (int i = 0; i < device_slots; ++i)
        if (specification == words[i]) return i;
    if (specification == "space-mouse") return scope_slot;
    throw InputError("space-mouse", "", {QT_TRANSLATE_NOOP("errors", "'%1' is not known"), specification},
                     QT_TRANSLATE_NOOP("errors", "use space-mouse, space-mouse:left or space-mouse:right"));
}

SpaceMouseDevice::~SpaceMouseDevice() {
    if (socket_ >= 0) ::close(socket_);
}

void SpaceMouseDevice::open() {
    const std::string path = spacenavd_socket();
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const bool fits = path.size() < sizeof address.sun_path;
    if (fits) std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
    socket_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (!fits || socket_ < 0 ||
        connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        const int why = fits ? errno : ENAMETOOLONG;
        if (why == EACCES || why == EPERM)
            throw InputError(
                path, "",
                QT_TRANSLATE_NOOP("errors", "you have no permission to use the socket of spacenavd"),
                {QT_TRANSLATE_NOOP("errors",
                                   "ask the administrator for the right to it: `sudo chmod a+rw %1`, and a+x "
                                   "for the folder that it is in"),
                 path});
        throw InputError(
            path, "",
            {QT_TRANSLATE_NOOP("errors", "spacenavd, which reads the SpaceMouse, does not answer: %1"),
             std::strerror(why)},
            QT_TRANSLATE_NOOP("errors",
                              "install it (package spacenavd) and start it with `sudo systemctl "
                              "restart spacenavd`; SPNAV_SOCKET names another socket"));
    }
    greet();
    facts_.kind = "space-mouse";
    facts_.title = "SpaceMouse";
    facts_.slot[slot_] = true;
}

void SpaceMouseDevice::greet() {
    send(socket_, &greeting, sizeof greeting, MSG_NOSIGNAL);
    pollfd one{socket_, POLLIN, 0};
    std::int32_t answer = 0;
    const bool answered = poll(&one, 1, greeting_limit_ms) > 0 &&
                          recv(socket_, &answer, sizeof answer, MSG_DONTWAIT | MSG_PEEK) ==
                              static_cast<ssize_t>(sizeof answer) &&
                          (answer & greeting_mask) == (greeting & greeting_mask);
    if (answered) {
        recv(socket_, &answer, sizeof answer, MSG_DONTWAIT);
        protocol_ = 1;
        return;
    }
    // An old one took the greeting as a sensitivity that is not a number.
    const float sensitivity = 1;
    send(socket_, &sensitivity, sizeof sensitivity, MSG_NOSIGNAL);
}

void SpaceMouseDevice::take(const Event& event, std::int64_t now) noexcept {
    const std::int32_t kind = event[0];
    if (kind < 0 || kind > largest_kind) {
        ended_ = true;  // these are no events
        return;
    }
    if (kind == spnav_motion) {
        for (std::size_t i = 0; i < deflection_.size(); ++i) {
            ended_ = ended_ || event[i + 1] < -largest_count || event[i + 1] > largest_count;
            deflection_[i] = std::clamp(event[i + 1], -largest_count, largest_count);
        }
        moved_at_ = now;
    } else if ((kind == spnav_press || kind == spnav_release) && event[1] >= 0 && event[1] < 3) {
        pressed_[event[1]] = kind == spnav_press;
    }
}

void SpaceMouseDevice::take_arrived(std::int64_t now) noexcept {
    // At most so many in a tick: a flood does not stop the loop.
    for (int events = 0; events < 64 && !ended_; ++events) {
        const ssize_t got = recv(socket_, partial_.data() + have_, partial_.size() - have_, MSG_DONTWAIT);
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return;
        if (got <= 0) {
            ended_ = true;
            return;
        }
        have_ += static_cast<std::size_t>(got);
        if (have_ < partial_.size()) continue;
        have_ = 0;
        Event event;
        std::memcpy(event.data(), partial_.data(), sizeof event);
        take(event, now);
    }
}

void SpaceMouseDevice::read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept {
    if (before_ == 0) before_ = now;
    const double period = std::clamp(static_cast<double>(now - before_) * 1e-9, 0.0, longest_step);
    before_ = now;
    if (!ended_) take_arrived(now);
    // spacenavd that stopped while the cap was pushed must not move the instrument on.
    if (ended_ || now - moved_at_ > held_limit) deflection_ = {};
    // Its z points away from the person.
    const Vector3 speed(space_mouse_response(deflection_[0]), space_mouse_response(deflection_[1]),
                        -space_mouse_response(deflection_[2]));
    position_ += space_mouse_speed * period * speed;
    roll_ -= space_mouse_turn * period * space_mouse_response(deflection_[4]);  // about its upward axis
    ++sequence_;
    DevicePose& pose = poses[slot_];
    pose.sequence = sequence_;
    for (int axis = 0; axis < 3; ++axis) pose.position[axis] = position_[axis];
    pose.roll = roll_;
    pose.jaw = 1;
    pose.buttons = (pressed_[0] ? std::uint32_t{button_primary} : 0U) |
                   (pressed_[1] ? std::uint32_t{button_energy} : 0U) |
                   (pressed_[2] ? std::uint32_t{button_exchange} : 0U);
    pose.present = ended_ ? 0 : 1;
}

FaultReport SpaceMouseDevice::fault() const noexcept {
    FaultReport report;
    if (!ended_) return report;
    report.fault = static_cast<std::uint64_t>(DeviceFault::spacenavd);
    report.hands = slot_ < scope_slot ? std::uint64_t{1} << slot_ : 0;
    return report;
}

}  // namespace fulcrum::hapticd
