// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/igtl_device.h"

#include <algorithm>
#include <cmath>

#include "sim_core/hapticd/tool_axes.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr int connect_limit_ms = 2000;
constexpr std::int64_t pose_limit = 2000 * ms;   // for the first pose
constexpr std::int64_t ask_after = 700 * ms;     // then TDATA is asked for
constexpr std::int64_t others_limit = 400 * ms;  // for the other tools, after the first
constexpr std::int64_t fault_memory = 1000 * ms;
constexpr std::int32_t tdata_every_ms = 10;
constexpr const char* jaw_names[2] = {"LeftJaw", "RightJaw"};
constexpr std::uint32_t known_buttons = 0xf;
constexpr std::size_t most_tools = 16;

[[noreturn]] void refuse_word(const std::string& word) {
    throw InputError(
        "openigtlink", "", {QT_TRANSLATE_NOOP("errors", "'%1' is not known"), word},
        QT_TRANSLATE_NOOP("errors",
                          "use openigtlink:HOST:PORT, then left=NAME, right=NAME, scope=NAME, length=MM, "
                          "shaft=+z or axes=+x+y+z, each after a comma"));
}

void take_word(IgtlSpecification& wanted, const std::string& word) {
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(0, equals);
    const std::string value = equals == std::string::npos ? std::string() : word.substr(equals + 1);
    for (std::size_t i = 0; i < device_slots; ++i) {
        if (key != device_slot_names[i]) continue;
        if (value.empty() || value.size() > igtl::device_size) refuse_word(word);
        wanted.tool[i] = value;
        wanted.named[i] = true;
        return;
    }
    if (key == "length") {
        const bool digits =
            !value.empty() && value.size() <= 4 && value.find_first_not_of("0123456789") == std::string::npos;
        if (!digits || std::stoi(value) > 1000) refuse_word(word);
        wanted.length = 1e-3 * std::stoi(value);
    } else if (key == "shaft") {
        const auto direction = direction_of(value);
        if (!direction) refuse_word(word);
        wanted.shaft = *direction;
    } else if (key == "axes") {
        const auto axes = axes_of(value);
        if (!axes) refuse_word(word);
        wanted.axes = *axes;
        if (wanted.axes.determinant() < 0.5)
            throw InputError("openigtlink", "",
                             {QT_TRANSLATE_NOOP("errors", "%1 is not a right-handed frame"), word},
                             QT_TRANSLATE_NOOP("errors",
                                               "name the axis of the tracker that points to the right, the "
                                               "one that points up and the one towards the person"));
    } else {
        refuse_word(word);
    }
}

}  // namespace

IgtlSpecification igtl_specification(const std::string& specification) {
    IgtlSpecification wanted;
    const std::size_t colon = specification.find(':');
    if (colon == std::string::npos) return wanted;
    std::string rest = specification.substr(colon + 1);
    const std::string first = rest.substr(0, rest.find(','));
    if (first.find('=') == std::string::npos) {
        wanted.address = igtl::parse_address(first, "openigtlink");
        rest = first.size() < rest.size() ? rest.substr(first.size() + 1) : std::string();
    }
    while (!rest.empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        take_word(wanted, rest.substr(0, comma));
        rest = rest.substr(std::min(comma + 1, rest.size()));
    }
    // With names of their own, tools that are not named are not looked for.
    const bool any = std::any_of(wanted.named.begin(), wanted.named.end(), [](bool named) { return named; });
    for (std::size_t i = 0; i < device_slots; ++i)
        if (any && !wanted.named[i]) wanted.tool[i].clear();
    return wanted;
}

TrackedHandle handle_of(const igtl::Pose& pose, const IgtlSpecification& specification) noexcept {
    TrackedHandle handle;
    const Vector3 axis = specification.axes * (pose.rotation * specification.shaft);
    handle.position = specification.axes * pose.place - specification.length * axis;
    handle.roll = roll_of(specification.axes * pose.rotation, specification.shaft);
    return handle;
}

void IgtlDevice::note(std::string_view tool) {
    const std::string name(tool);
    if (other_tools_.size() < most_tools &&
        std::find(other_tools_.begin(), other_tools_.end(), name) == other_tools_.end())
        other_tools_.push_back(name);
}

void IgtlDevice::take_pose(std::string_view tool, const std::optional<igtl::Pose>& pose,
                           std::int64_t now) noexcept {
    std::size_t i = 0;
    while (i < device_slots && (wanted_.tool[i].empty() || tool != wanted_.tool[i])) ++i;
    if (i == device_slots) {
        if (opening_) note(tool);
        return;
    }
    if (!pose) {
        bad_pose_at_ = now;
        return;
    }
    slots_[i].handle.take(handle_of(*pose, wanted_), now);
}

void IgtlDevice::take_jaw(std::string_view device, const igtl::Sensor& sensor, std::int64_t now) noexcept {
    for (std::size_t h = 0; h < 2; ++h) {
        if (device != jaw_names[h] || sensor.count < 1) continue;
        const double jaw = sensor.values[0], buttons = sensor.count > 1 ? sensor.values[1] : 0;
        if (!std::isfinite(jaw) || !std::isfinite(buttons)) {
            bad_pose_at_ = now;
            return;
        }
        slots_[h].jaw = std::clamp(jaw, 0.0, 1.0);
        slots_[h].buttons = static_cast<std::uint32_t>(std::clamp(buttons, 0.0, 65535.0)) & known_buttons;
    }
}

void IgtlDevice::take(const igtl::Message& message, std::int64_t now) noexcept {
    igtl::Transform transform;
    igtl::Position position;
    igtl::Sensor sensor;
    if (message.type == "TRANSFORM" && igtl::read_transform(message.content, transform)) {
        take_pose(message.device, igtl::pose_of(transform), now);
    } else if (message.type == "POSITION" && igtl::read_position(message.content, position)) {
        take_pose(message.device, igtl::pose_of(position), now);
    } else if (message.type == "TDATA") {
        const std::size_t count = igtl::count_of_tdata(message.content).value_or(0);
        for (std::size_t i = 0; i < count; ++i) {
            const igtl::Tracked tracked = igtl::element_of_tdata(message.content, i);
            take_pose(tracked.name, igtl::pose_of(tracked.transform), now);
        }
    } else if (message.type == "SENSOR" && igtl::read_sensor(message.content, sensor)) {
        take_jaw(message.device, sensor, now);
    }
}

void IgtlDevice::take_arrived(std::int64_t now) noexcept {
    using Found = igtl::Decoder::Found;
    if (ended_ != DeviceFault::none) return;
    const bool connected = connection_.read_into(decoder_);
    igtl::Message message;
    for (Found found = decoder_.next(message); found != Found::nothing; found = decoder_.next(message)) {
        if (found == Found::broken) {
            ended_ = DeviceFault::not_openigtlink;
            return;
        }
        if (found == Found::wrong_checksum || found == Found::wrong_content) wrong_checksum_at_ = now;
        if (found == Found::message) take(message, now);
    }
    if (!connected) ended_ = DeviceFault::connection_ended;
}

bool IgtlDevice::all_seen(bool named_only) const noexcept {
    bool any = false, all = true;
    for (std::size_t i = 0; i < device_slots; ++i) {
        if (wanted_.tool[i].empty()) continue;
        any = any || slots_[i].handle.seen();
        all = all && (slots_[i].handle.seen() || (named_only && !wanted_.named[i]));
    }
    return any && all;
}

void IgtlDevice::refuse() const {
    const std::string where = wanted_.address.text();
    if (ended_ == DeviceFault::not_openigtlink)
        throw InputError(
            where, "", QT_TRANSLATE_NOOP("errors", "what it sends is not OpenIGTLink"),
            QT_TRANSLATE_NOOP("errors", "check that this is the port of the OpenIGTLink server"));
    if (ended_ != DeviceFault::none)
        throw InputError(where, "", QT_TRANSLATE_NOOP("errors", "the server closed the connection"),
                         QT_TRANSLATE_NOOP("errors",
                                           "end other programs that are connected to it, or "
                                           "restart it"));
    if (wrong_checksum_at_ != 0)
        throw InputError(where, "", QT_TRANSLATE_NOOP("errors", "its messages have wrong checksums"),
                         QT_TRANSLATE_NOOP("errors", "install the newest version of the program that sends"));
    if (bad_pose_at_ != 0)
        throw InputError(where, "", QT_TRANSLATE_NOOP("errors", "it sends poses that cannot be used"),
                         QT_TRANSLATE_NOOP("errors",
                                           "calibrate the tracker, and send a rotation and a place "
                                           "in millimetres"));
    std::string wanted, others;
    for (std::size_t i = 0; i < device_slots; ++i)
        if (!wanted_.tool[i].empty() && !slots_[i].handle.seen())
            wanted += (wanted.empty() ? "" : ", ") + wanted_.tool[i];
    for (const std::string& name : other_tools_) others += (others.empty() ? "" : ", ") + name;
    if (others.empty())
        throw InputError(where, "", {QT_TRANSLATE_NOOP("errors", "sent no pose of %1"), wanted},
                         QT_TRANSLATE_NOOP("errors", "start tracking there, with the tools in its view"));
    throw InputError(
        where, "", {QT_TRANSLATE_NOOP("errors", "sent no pose of %1, only of %2"), wanted, others},
        {QT_TRANSLATE_NOOP("errors", "name its tools: openigtlink:%1,left=NAME,right=NAME"), where});
}

void IgtlDevice::open() {
    connection_ = igtl::Connection(wanted_.address, connect_limit_ms);
    opening_ = true;
    const std::int64_t begin = monotonic_ns();
    std::int64_t until = begin + pose_limit, first_at = 0;
    bool asked = false;
    while (ended_ == DeviceFault::none && !all_seen(false)) {
        const std::int64_t now = monotonic_ns();
        if (now > until) break;
        if (all_seen(true) && first_at == 0) {
            first_at = now;
            until = std::min(until, now + others_limit);
        }
        if (!asked && now - begin > ask_after) {  // some servers send TDATA only to those that ask
            igtl::Bytes request;
            igtl::append_start_tracking(request, "", 0, {tdata_every_ms, ""});
            connection_.send(request);
            asked = true;
        }
        connection_.wait(10);
        take_arrived(monotonic_ns());
    }
    opening_ = false;
    if (ended_ != DeviceFault::none || !all_seen(true)) refuse();
    facts_.kind = "openigtlink";
    facts_.title = "OpenIGTLink " + wanted_.address.text();
    for (std::size_t i = 0; i < device_slots; ++i) {
        facts_.slot[i] = slots_[i].handle.seen();
        facts_.clutch[i] = facts_.slot[i];
    }
}

void IgtlDevice::read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept {
    take_arrived(now);
    ++sequence_;
    std::uint64_t absent = 0;
    bool any_absent = false;
    for (int i = 0; i < device_slots; ++i) {
        Slot& slot = slots_[i];
        const TrackedHandle& handle = slot.handle.at(now);
        DevicePose& pose = poses[i];
        pose.sequence = sequence_;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = handle.position[axis];
        pose.roll = handle.roll;
        pose.jaw = slot.jaw;
        pose.buttons = slot.buttons;
        pose.present = slot.handle.fresh(now) && ended_ == DeviceFault::none ? 1 : 0;
        if (!facts_.slot[i] || pose.present != 0) continue;
        any_absent = true;
        if (i < scope_slot) absent |= std::uint64_t{1} << i;
    }
    DeviceFault fault = ended_;
    if (fault == DeviceFault::none && any_absent)
        fault = wrong_checksum_at_ != 0 && now - wrong_checksum_at_ < fault_memory
                    ? DeviceFault::wrong_checksum
                : bad_pose_at_ != 0 && now - bad_pose_at_ < fault_memory ? DeviceFault::not_a_pose
                                                                         : DeviceFault::no_poses;
    report_.fault = static_cast<std::uint64_t>(fault);
    report_.hands = absent;
}

}  // namespace fulcrum::hapticd
