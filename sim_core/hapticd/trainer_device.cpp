// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/trainer_device.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "sim_core/devices/usb_devices.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

constexpr std::int64_t trainer_ms = 1'000'000;                // ns
constexpr std::int64_t first_pose_limit = 1000 * trainer_ms;  // after the hello
constexpr std::int64_t ask_every = 250 * trainer_ms;          // until it sends
constexpr double least_reach = 0.01;                          // m of the shaft that is outside
constexpr std::int64_t microsecond = 1000;
constexpr std::uint32_t longest_step_us = 250 * 1000;

struct Baud {
    int bits;
    speed_t speed;
};
constexpr Baud bauds[] = {{9600, B9600},     {19200, B19200},   {38400, B38400},
                          {57600, B57600},   {115200, B115200}, {230400, B230400},
                          {460800, B460800}, {921600, B921600}, {1000000, B1000000}};

[[noreturn]] void refuse_trainer_word(const std::string& word) {
    throw InputError("trainer", "", {QT_TRANSLATE_NOOP("errors", "'%1' is not known"), word},
                     QT_TRANSLATE_NOOP("errors",
                                       "use trainer:PORT, then baud=BITS (9600 to 1000000) or length=MM (100 "
                                       "to 600), each after a comma"));
}

int whole_number(const std::string& text, const std::string& word) {
    const bool digits =
        !text.empty() && text.size() <= 7 && text.find_first_not_of("0123456789") == std::string::npos;
    if (!digits) refuse_trainer_word(word);
    return std::stoi(text);
}

speed_t speed_of(int bits) {
    for (const Baud& one : bauds)
        if (one.bits == bits) return one.speed;
    return B0;
}

/// The only port that can be a trainer's.
std::string only_port() {
    const DeviceRow& row = *device_row("trainer");
    const std::vector<std::string> ports = serial_ports_of(row, usb_devices());
    if (ports.size() == 1) return ports.front();
    if (ports.empty())
        throw InputError(
            "trainer", "", QT_TRANSLATE_NOOP("errors", "no serial port of a micro-controller was found"),
            QT_TRANSLATE_NOOP("errors", "plug the trainer in, or name its port: trainer:/dev/ttyUSB0"));
    std::string all;
    for (const std::string& port : ports) all += (all.empty() ? "" : ", ") + port;
    throw InputError("trainer", "",
                     {QT_TRANSLATE_NOOP("errors", "more than one port can be the trainer's: %1"), all},
                     {QT_TRANSLATE_NOOP("errors", "name it: trainer:%1"), ports.front()});
}

Sentence hint_of_port(int error) {
    if (error == EACCES || error == EPERM) return device_row("trainer")->rule;
    if (error == EBUSY || error == EWOULDBLOCK)
        return QT_TRANSLATE_NOOP("errors",
                                 "end the other program that uses it, such as the serial monitor of the "
                                 "Arduino program");
    if (error == ENOTTY) return QT_TRANSLATE_NOOP("errors", "name a serial port, such as /dev/ttyACM0");
    return QT_TRANSLATE_NOOP("errors", "plug the trainer in; `fulcrum devices` shows whether it is found");
}

[[noreturn]] void refuse_port(const std::string& port, int error) {
    throw InputError(port, "",
                     {QT_TRANSLATE_NOOP("errors", "the trainer's port does not open: %1"),
                      std::string(std::strerror(error))},
                     hint_of_port(error));
}

}  // namespace

/// "zero-left=PITCH;YAW;ROLL", mrad.
static void read_zero(const std::string& word, std::size_t equals, double (&zero)[3]) {
    std::string rest = word.substr(equals + 1);
    for (int i = 0; i < 3; ++i) {
        const std::size_t end = rest.find(';');
        if ((end == std::string::npos) != (i == 2)) refuse_trainer_word(word);
        std::string digits = rest.substr(0, end);
        const bool below = !digits.empty() && digits.front() == '-';
        if (below) digits.erase(0, 1);
        const int mrad = (below ? -1 : 1) * whole_number(digits, word);
        if (std::abs(mrad) > (i == 2 ? 10000 : 1500)) refuse_trainer_word(word);
        zero[i] = 1e-3 * mrad;
        rest = end == std::string::npos ? std::string() : rest.substr(end + 1);
    }
}

TrainerSpecification trainer_specification(const std::string& specification) {
    TrainerSpecification wanted;
    const std::size_t colon = specification.find(':');
    std::string rest = colon == std::string::npos ? std::string() : specification.substr(colon + 1);
    for (bool first = true; !rest.empty(); first = false) {
        const std::string word = rest.substr(0, rest.find(','));
        rest = word.size() < rest.size() ? rest.substr(word.size() + 1) : std::string();
        const std::size_t equals = word.find('=');
        const std::string key = word.substr(0, equals);
        const bool zero = key == "zero-left" || key == "zero-right";
        if (first && key != "baud" && key != "length" && !zero) {
            wanted.port = word;
        } else if (key == "baud" && equals != std::string::npos) {
            wanted.baud = whole_number(word.substr(equals + 1), word);
            if (speed_of(wanted.baud) == B0) refuse_trainer_word(word);
        } else if (key == "length" && equals != std::string::npos) {
            const int length = whole_number(word.substr(equals + 1), word);
            if (length < 100 || length > 600) refuse_trainer_word(word);
            wanted.length = 1e-3 * length;
        } else if (zero && equals != std::string::npos) {
            read_zero(word, equals, wanted.zero[key == "zero-left" ? 0 : 1]);
        } else {
            refuse_trainer_word(word);
        }
    }
    return wanted;
}

TrackedHandle handle_of(const TrainerPose& pose, double length) noexcept {
    // Without angles the shaft points away from the person.
    const Vector3 to_the_tip(std::sin(pose.yaw) * std::cos(pose.pitch), std::sin(pose.pitch),
                             -std::cos(pose.yaw) * std::cos(pose.pitch));
    return {(pose.insertion - length) * to_the_tip, pose.roll};
}

TrainerDevice::~TrainerDevice() {
    if (port_ < 0) return;
    tcflush(port_, TCOFLUSH);  // else the system would wait for a board that takes nothing
    ::close(port_);
}

void TrainerDevice::open_port() {
    if (wanted_.port.empty()) wanted_.port = only_port();
    port_ = ::open(wanted_.port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (port_ < 0) refuse_port(wanted_.port, errno);
    if (flock(port_, LOCK_EX | LOCK_NB) != 0) refuse_port(wanted_.port, errno == EWOULDBLOCK ? EBUSY : errno);
    termios settings{};
    if (tcgetattr(port_, &settings) != 0) refuse_port(wanted_.port, errno);
    cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
    cfsetspeed(&settings, speed_of(wanted_.baud));
    if (tcsetattr(port_, TCSANOW, &settings) != 0) refuse_port(wanted_.port, errno);
    tcflush(port_, TCIOFLUSH);
}

void TrainerDevice::ask() noexcept {
    constexpr char question[] = "F1,?*BB67\n";  // trainer_line("F1,?")
    // A port that takes nothing now is asked again.
    if (write(port_, question, sizeof question - 1) < 0 && errno == EIO) ended_ = true;
}

void TrainerDevice::refuse() const {
    const std::string where = wanted_.port;
    if (ended_)
        throw InputError(
            where, "", QT_TRANSLATE_NOOP("errors", "the trainer was unplugged"),
            QT_TRANSLATE_NOOP("errors", "plug it in, and use a cable and a port that hold it firmly"));
    if (other_version_ != 0)
        throw InputError(
            where, "",
            {QT_TRANSLATE_NOOP("errors", "the trainer speaks version %1 of the protocol, Fulcrum version %2"),
             other_version_, trainer_version},
            QT_TRANSLATE_NOOP("errors", "load the sketch that came with this version of Fulcrum"));
    if (values_at_ != 0)
        throw InputError(
            where, "",
            QT_TRANSLATE_NOOP("errors", "the trainer sends angles or lengths that are not possible"),
            QT_TRANSLATE_NOOP("errors", "set the ranges of its sensors in its sketch (docs/TRAINER.md)"));
    if (checksum_at_ != 0)
        throw InputError(where, "", QT_TRANSLATE_NOOP("errors", "the trainer's lines have wrong checksums"),
                         QT_TRANSLATE_NOOP("errors", "use a shorter cable, or a lower rate on both sides"));
    if (!greeted_ && any_bytes_)
        throw InputError(
            where, "", QT_TRANSLATE_NOOP("errors", "what it sends are not the lines of a trainer"),
            QT_TRANSLATE_NOOP(
                "errors", "load the sketch of docs/trainer, and name its rate: trainer:PORT,baud=115200"));
    if (!greeted_)
        throw InputError(
            where, "", QT_TRANSLATE_NOOP("errors", "no trainer answers"),
            QT_TRANSLATE_NOOP("errors", "check that this is its port, and load the sketch of docs/trainer"));
    throw InputError(where, "", QT_TRANSLATE_NOOP("errors", "the trainer sends no pose of its instruments"),
                     QT_TRANSLATE_NOOP("errors", "press the reset button of its board"));
}

bool TrainerDevice::all_seen() const noexcept {
    for (std::size_t i = 0; i < device_slots; ++i)
        if (hello_.part[i] && !parts_[i].handle.seen()) return false;
    return true;
}

void TrainerDevice::open() {
    open_port();
    std::int64_t until = monotonic_ns() + wanted_.patience;
    while (!ended_ && other_version_ == 0 && !(greeted_ && all_seen())) {
        const std::int64_t now = monotonic_ns();
        if (now > until) break;
        if (now - asked_at_ > ask_every) {
            ask();
            asked_at_ = now;
        }
        pollfd one{port_, POLLIN, 0};
        poll(&one, 1, 10);
        const bool greeted_before = greeted_;
        take_arrived(monotonic_ns());
        if (greeted_ && !greeted_before)
            until = monotonic_ns() + std::min(wanted_.patience, first_pose_limit);
    }
    if (ended_ || !greeted_ || !all_seen()) refuse();
    facts_.kind = "trainer";
    facts_.title = hello_.name.data();
    for (std::size_t i = 0; i < device_slots; ++i) {
        facts_.slot[i] = hello_.part[i];
        facts_.clutch[i] = facts_.slot[i];
    }
}

void TrainerDevice::take_pose(const TrainerPose& pose, std::int64_t now) noexcept {
    if (pose.insertion > wanted_.length - least_reach) {
        values_at_ = now;
        return;
    }
    Part& part = parts_[pose.part];
    TrainerPose straight = pose;
    if (pose.part < scope_slot) {
        const double(&zero)[3] = wanted_.zero[pose.part];
        straight.pitch -= zero[0];
        straight.yaw -= zero[1];
        straight.roll -= zero[2];
    }
    const std::uint32_t step = pose.time_us - part.time_us;
    const auto ahead = static_cast<std::uint16_t>(pose.sequence - part.sequence);
    // A line that is sent again, or comes late, is nothing new: a trainer that hangs is silent.
    const bool same = ahead == 0 && step == 0, older = ahead == 0 || ahead > INT16_MAX || step == 0;
    if (part.any && (part.again ? same : older)) return;
    const bool plausible = part.any && !part.again && step < longest_step_us;
    part.handle.take(handle_of(straight, wanted_.length), now,
                     plausible ? step * microsecond : 1000 * trainer_ms / hello_.rate);
    part.jaw = pose.jaw;
    part.buttons = pose.buttons;
    part.sequence = pose.sequence;
    part.time_us = pose.time_us;
    part.any = true;
    part.again = false;
}

void TrainerDevice::take(const TrainerMessage& message, std::int64_t now) noexcept {
    using Kind = TrainerMessage::Kind;
    switch (message.kind) {
        case Kind::hello:
            // A board that began again counts from 0 and may have other instruments: these stay.
            for (Part& part : parts_) part.again = true;
            if (!greeted_) hello_ = message.hello;
            greeted_ = true;
            break;
        case Kind::pose:
            if (greeted_ && hello_.part[message.pose.part]) take_pose(message.pose, now);
            break;
        case Kind::wrong_checksum:
            checksum_at_ = now;
            break;
        case Kind::wrong_values:
            values_at_ = now;
            break;
        case Kind::other_version:
            other_version_ = message.version;
            line_at_ = now;
            break;
        case Kind::not_a_line:
            line_at_ = now;
            break;
        case Kind::nothing:
            break;
    }
}

void TrainerDevice::take_arrived(std::int64_t now) noexcept {
    // At most so many reads in a tick: a flood does not stop the loop.
    for (int reads = 0; reads < 8 && !ended_; ++reads) {
        const ssize_t got = ::read(port_, decoder_.space(), decoder_.room());
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return;
        if (got <= 0) {  // hung up
            ended_ = true;
            return;
        }
        any_bytes_ = true;
        decoder_.take(static_cast<std::size_t>(got));
        for (TrainerMessage message = decoder_.next(); message.kind != TrainerMessage::Kind::nothing;
             message = decoder_.next())
            take(message, now);
    }
}

DeviceFault TrainerDevice::fault_at(std::int64_t now) const noexcept {
    if (ended_) return DeviceFault::trainer_unplugged;
    const std::pair<DeviceFault, std::int64_t> seen[] = {{DeviceFault::trainer_values, values_at_},
                                                         {DeviceFault::trainer_checksum, checksum_at_},
                                                         {DeviceFault::trainer_lines, line_at_}};
    for (const auto& [fault, at] : seen)
        if (at != 0 && now - at < fault_row(fault).remembered * trainer_ms) return fault;
    return DeviceFault::trainer_silent;
}

void TrainerDevice::read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept {
    if (!ended_) take_arrived(now);
    ++sequence_;
    bool any_absent = false;
    std::uint64_t absent = 0;
    for (std::size_t i = 0; i < device_slots; ++i) {
        if (!facts_.slot[i]) continue;
        Part& part = parts_[i];
        const TrackedHandle& handle = part.handle.at(now);
        const bool present = !ended_ && part.handle.fresh(now);
        DevicePose& pose = poses[i];
        pose.sequence = sequence_;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = handle.position[axis];
        pose.roll = handle.roll;
        pose.jaw = part.jaw;
        pose.buttons = present ? part.buttons : 0U;
        pose.present = present ? 1 : 0;
        if (present) continue;
        any_absent = true;
        if (i < scope_slot) absent |= std::uint64_t{1} << i;
    }
    // A board that began again waits to be asked. The port never makes the loop wait.
    if (any_absent && !ended_ && now - asked_at_ > ask_every) {
        ask();
        asked_at_ = now;
    }
    report_.fault = static_cast<std::uint64_t>(any_absent ? fault_at(now) : DeviceFault::none);
    report_.hands = absent;
}

}  // namespace fulcrum::hapticd
