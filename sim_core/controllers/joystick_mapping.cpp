// SPDX-License-Identifier: Apache-2.0
#include "sim_core/controllers/joystick_mapping.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_core/devices/device_page.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

using nlohmann::json;

constexpr double least_range = 0.4;   // of 2, that counts as moved
constexpr double end_share = 0.15;    // of the range, that counts as its end
constexpr double still_range = 0.03;  // of 2, by which an axis at rest may change
constexpr double still_s = 0.5;
constexpr double usual_angle = 0.7853981633974483;  // rad: 45 degrees
constexpr double usual_turn = 3.141592653589793;    // rad
constexpr double usual_depth = 0.2;                 // m
constexpr int buttons_per_hand = 4;

struct ButtonKey {
    const char* name;
    int JoystickPart::*button;
};
constexpr ButtonKey button_keys[] = {{"jaws", &JoystickPart::jaws},
                                     {"energy", &JoystickPart::energy},
                                     {"exchange", &JoystickPart::exchange},
                                     {"clutch", &JoystickPart::clutch}};
struct AxisKey {
    const char* name;
    double JoystickAxis::*value;
};
constexpr AxisKey axis_keys[] = {{"low", &JoystickAxis::low},         {"rest", &JoystickAxis::rest},
                                 {"high", &JoystickAxis::high},       {"at_low", &JoystickAxis::at_low},
                                 {"at_rest", &JoystickAxis::at_rest}, {"at_high", &JoystickAxis::at_high}};

class MappingReader {
  public:
    explicit MappingReader(std::string path) : path_(std::move(path)) {}
    JoystickMapping read() {
        require_regular_file(path_);
        std::ifstream file(path_, std::ios::binary);
        std::string text(65537, '\0');
        file.read(text.data(), static_cast<std::streamsize>(text.size()));
        text.resize(static_cast<std::size_t>(file.gcount()));
        if (text.size() > 65536) bad("", QT_TRANSLATE_NOOP("errors", "is larger than 64 KiB"));
        const json root = json::parse(text, nullptr, false);
        if (!root.is_object() || root.value("format", json()) != json("fulcrum-joystick"))
            bad("/format", QT_TRANSLATE_NOOP("errors", "must be \"fulcrum-joystick\""));
        JoystickMapping mapping;
        const json name = root.value("name", json());
        if (!name.is_string()) bad("/name", QT_TRANSLATE_NOOP("errors", "is missing"));
        mapping.name = name.get<std::string>();
        for (int h = 0; h < 2; ++h)
            if (root.contains(device_slot_names[h]))
                mapping.part[h] =
                    part(root.at(device_slot_names[h]), std::string("/") + device_slot_names[h]);
        if (!mapping.part[0].used() && !mapping.part[1].used())
            bad("", QT_TRANSLATE_NOOP("errors", "gives no hand the axes for pitch, yaw and insertion"));
        return mapping;
    }

  private:
    [[noreturn]] void bad(const std::string& place, const Sentence& problem) const {
        throw InputError(path_, place, problem,
                         QT_TRANSLATE_NOOP("errors",
                                           "calibrate the joystick again: `fulcrum devices --calibrate "
                                           "joystick`"));
    }
    double number(const json& from, const char* key, const std::string& place, double least, double most) {
        const json value = from.is_object() ? from.value(key, json()) : json();
        const double number = value.is_number() ? value.get<double>() : NAN;
        if (!(number >= least && number <= most))
            bad(place + "/" + key, QT_TRANSLATE_NOOP("errors", "is not a usable number"));
        return number;
    }
    JoystickPart part(const json& from, const std::string& place) {
        if (!from.is_object()) bad(place, QT_TRANSLATE_NOOP("errors", "must be an object"));
        JoystickPart made;
        for (int m = 0; m < joystick_motions; ++m) {
            const char* const name = joystick_motion_names[m];
            if (!from.contains(name)) {
                // Without an axis of their own jaws are open, until their button is pressed.
                if (static_cast<JoystickMotion>(m) == JoystickMotion::jaw) made.motion[m].at_rest = 1;
                continue;
            }
            const std::string at = place + "/" + name;
            const json& object = from.at(name);
            JoystickAxis& axis = made.motion[m];
            axis.axis = static_cast<int>(number(object, "axis", at, 0, most_joystick_axes - 1));
            for (const AxisKey& key : axis_keys) {
                const bool reading = std::string(key.name).rfind("at_", 0) != 0;
                axis.*key.value = number(object, key.name, at, reading ? -1 : -10, reading ? 1 : 10);
            }
            limit(static_cast<JoystickMotion>(m), axis, at);
        }
        for (const ButtonKey& key : button_keys)
            if (from.contains(key.name))
                made.*key.button = static_cast<int>(number(from, key.name, place, -1, 63));
        return made;
    }
    /// As the lines of a trainer (docs/TRAINER.md).
    void limit(JoystickMotion motion, const JoystickAxis& axis, const std::string& place) {
        const bool angle = motion == JoystickMotion::pitch || motion == JoystickMotion::yaw;
        const double least = angle ? -1.5 : motion == JoystickMotion::roll ? -10 : 0;
        const double most = angle                                 ? 1.5
                            : motion == JoystickMotion::roll      ? 10
                            : motion == JoystickMotion::insertion ? 0.32
                                                                  : 1;
        for (const double value : {axis.at_low, axis.at_rest, axis.at_high})
            if (!(value >= least && value <= most))
                bad(place, QT_TRANSLATE_NOOP("errors", "has an angle or length that is not possible"));
        if (std::abs(axis.high - axis.low) < 0.1)
            bad(place, QT_TRANSLATE_NOOP("errors", "has two ends that are the same"));
    }
    std::string path_;
};

}  // namespace

double JoystickAxis::value(const JoystickReading& reading) const noexcept {
    if (axis < 0 || axis >= most_joystick_axes) return at_rest;
    const double at = std::clamp(reading.axis[axis], std::min(low, high), std::max(low, high));
    const bool up = high > low ? at >= rest : at <= rest;
    const double end = up ? high : low, at_end = up ? at_high : at_low;
    const double way = end - rest;
    // A rest at an end, as of a trigger: one line.
    if (std::abs(way) < 1e-6) return at_rest;
    return at_rest + (at - rest) / way * (at_end - at_rest);
}

JoystickMapping read_joystick_mapping(const std::string& path) {
    return MappingReader(path).read();
}

std::string joystick_mapping_text(const JoystickMapping& mapping) {
    json root = {{"format", "fulcrum-joystick"}, {"name", mapping.name}};
    for (int h = 0; h < 2; ++h) {
        const JoystickPart& part = mapping.part[h];
        if (!part.used()) continue;
        json& made = root[device_slot_names[h]];
        for (int m = 0; m < joystick_motions; ++m) {
            const JoystickAxis& axis = part.motion[m];
            if (axis.axis < 0) continue;
            json& one = made[joystick_motion_names[m]];
            one["axis"] = axis.axis;
            for (const AxisKey& key : axis_keys) one[key.name] = axis.*key.value;
        }
        for (const ButtonKey& key : button_keys) made[key.name] = part.*key.button;
    }
    return root.dump(2) + "\n";
}

void JoystickCalibration::begin_step() noexcept {
    for (Seen& one : seen_) one = {};
    any_ = false;
    still_since_ = now_;
}

void JoystickCalibration::see(const JoystickReading& reading, int axes, double now) noexcept {
    axes_ = std::clamp(axes, 0, most_joystick_axes);
    now_ = now;
    if (!any_) still_since_ = now;
    any_ = true;
    for (int i = 0; i < axes_; ++i) {
        Seen& one = seen_[i];
        one.now = reading.axis[i];
        one.least = std::min(one.least, one.now);
        one.most = std::max(one.most, one.now);
    }
    if (step_ != 0) return;
    for (int i = 0; i < axes_; ++i) {
        if (seen_[i].range() <= still_range) continue;
        begin_step();
        return;
    }
    rest_ = reading;
}

/// The axis that moved most and means nothing yet; -1: none moved enough.
int JoystickCalibration::moved() const noexcept {
    int most = -1;
    for (int i = 0; i < axes_; ++i)
        if (!taken_[i] && seen_[i].range() >= least_range &&
            (most < 0 || seen_[i].range() > seen_[most].range()))
            most = i;
    return most;
}

bool JoystickCalibration::ready() const noexcept {
    if (done() || !any_ || axes_ == 0) return false;
    if (step_ == 0) return now_ - still_since_ >= still_s;
    const int axis = moved();
    if (axis < 0) return false;
    const Seen& one = seen_[axis];
    return std::min(one.now - one.least, one.most - one.now) <= end_share * one.range();
}

bool JoystickCalibration::next() noexcept {
    if (!ready()) return false;
    if (step_ > 0) {
        const int axis = moved();
        const Seen& one = seen_[axis];
        const bool up = one.most - one.now < one.now - one.least;
        JoystickAxis& made = part_.motion[step_ - 1];
        made.axis = axis;
        made.low = up ? one.least : one.most;
        made.high = up ? one.most : one.least;
        made.rest = std::clamp(rest_.axis[axis], one.least, one.most);
        taken_[axis] = true;
    }
    ++step_;
    begin_step();
    return true;
}

void JoystickCalibration::skip() noexcept {
    if (!can_skip()) return;
    ++step_;
    begin_step();
}

JoystickPart JoystickCalibration::part() const {
    JoystickPart made = part_;
    for (int m = 0; m < joystick_motions; ++m) {
        JoystickAxis& axis = made.motion[m];
        const auto motion = static_cast<JoystickMotion>(m);
        const bool from_zero = motion == JoystickMotion::insertion || motion == JoystickMotion::jaw;
        const double most = motion == JoystickMotion::roll        ? usual_turn
                            : motion == JoystickMotion::insertion ? usual_depth
                            : motion == JoystickMotion::jaw       ? 1
                                                                  : usual_angle;
        axis.at_low = from_zero ? 0 : -most;
        axis.at_high = most;
        // One line from end to end, wherever it rested.
        if (from_zero)
            axis.at_rest = std::abs(axis.high - axis.low) > 0
                               ? most * std::clamp((axis.rest - axis.low) / (axis.high - axis.low), 0.0, 1.0)
                               : 0;
        if (axis.axis < 0 && motion == JoystickMotion::insertion) axis.at_rest = 0.5 * usual_depth;
        if (axis.axis < 0 && motion == JoystickMotion::jaw) axis.at_rest = 1;
    }
    const bool has_jaws = made.motion[static_cast<int>(JoystickMotion::jaw)].axis >= 0;
    int next = 0;
    if (!has_jaws) made.jaws = next++;
    made.energy = next++;
    made.exchange = next++;
    made.clutch = next;
    static_assert(buttons_per_hand >= 4);
    return made;
}

void put_raw(const JoystickReading& reading, int axes, DevicePose (&poses)[device_slots]) noexcept {
    for (int h = 0; h < 2; ++h) {
        const auto axis = [&](int i) { return 5 * h + i < axes ? reading.axis[5 * h + i] : 0.0; };
        for (int i = 0; i < 3; ++i) poses[h].position[i] = axis(i);
        poses[h].roll = axis(3);
        poses[h].jaw = axis(4);
        poses[h].buttons =
            static_cast<std::uint32_t>(reading.buttons >> (4U * static_cast<unsigned>(h)) & 0xfU);
    }
}

JoystickReading raw_of(const DevicePose& left, const DevicePose& right) noexcept {
    JoystickReading reading;
    const DevicePose* const poses[] = {&left, &right};
    for (int h = 0; h < 2; ++h) {
        for (int i = 0; i < 3; ++i) reading.axis[5 * h + i] = poses[h]->position[i];
        reading.axis[5 * h + 3] = poses[h]->roll;
        reading.axis[5 * h + 4] = poses[h]->jaw;
    }
    reading.buttons = (left.buttons & 0xfU) | std::uint64_t{right.buttons & 0xfU} << 4U;
    return reading;
}

}  // namespace fulcrum
