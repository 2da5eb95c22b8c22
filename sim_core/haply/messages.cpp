// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haply/messages.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace fulcrum::haply {
namespace {

using nlohmann::json;

constexpr const char* axis_names[] = {"x", "y", "z"};
constexpr double largest_place_m = 10, unit_error = 0.01;
constexpr std::size_t most_devices = 8;

const json* member(const json& object, const char* name) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(name);
    return found != object.end() ? &*found : nullptr;
}

std::string text_of(const json& object, const char* name) {
    const json* const value = member(object, name);
    return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

bool flag_of(const json& object, const char* name, bool otherwise) {
    const json* const value = member(object, name);
    if (value == nullptr) return otherwise;
    if (value->is_boolean()) return value->get<bool>();
    return value->is_number() ? value->get<double>() != 0 : otherwise;
}

std::optional<Vector3> vector_of(const json& object) {
    Vector3 vector;
    for (int axis = 0; axis < 3; ++axis) {
        const json* const value = member(object, axis_names[axis]);
        if (value == nullptr || !value->is_number()) return std::nullopt;
        vector[axis] = value->get<double>();
    }
    return vector.allFinite() ? std::optional<Vector3>(vector) : std::nullopt;
}

std::optional<Quaternion> turn_of(const json& object) {
    const std::optional<Vector3> imaginary = vector_of(object);
    const json* const real = member(object, "w");
    if (!imaginary || real == nullptr || !real->is_number()) return std::nullopt;
    const Quaternion turn(real->get<double>(), imaginary->x(), imaginary->y(), imaginary->z());
    return std::abs(turn.norm() - 1) < unit_error ? std::optional<Quaternion>(turn.normalized())
                                                  : std::nullopt;
}

/// False where a number is not one.
bool read_inverse3(const json& one, Inverse3& device) {
    device.id = text_of(one, "device_id");
    if (const json* const config = member(one, "config")) device.handedness = text_of(*config, "handedness");
    if (const json* const status = member(one, "status")) {
        device.calibrated = flag_of(*status, "calibrated", true);
        device.powered = flag_of(*status, "power_supply", true);
        device.in_use = flag_of(*status, "in_use", false);
    }
    const json* const state = member(one, "state");
    if (state == nullptr) return true;
    if (const json* const force = member(*state, "current_cursor_force")) device.force = vector_of(*force);
    const json* const position = member(*state, "cursor_position");
    if (position == nullptr) return true;
    device.position = vector_of(*position);
    if (device.position && device.position->norm() > largest_place_m) device.position.reset();
    return device.position.has_value();
}

bool read_grip(const json& one, Grip& grip) {
    grip.id = text_of(one, "device_id");
    const json* const state = member(one, "state");
    if (state == nullptr) return true;
    // A wired grip has one button, a wireless one three, whose names differ between versions.
    grip.button[0] = flag_of(*state, "button", false);
    if (const json* const buttons = member(*state, "buttons")) {
        constexpr const char* names[][2] = {{"a", "button_0"}, {"b", "button_1"}, {"c", "button_2"}};
        for (std::size_t i = 0; i < std::size(names); ++i)
            grip.button[i] = grip.button[i] || flag_of(*buttons, names[i][0], false) ||
                             flag_of(*buttons, names[i][1], false);
    }
    const json* const orientation = member(*state, "orientation");
    if (orientation == nullptr) return true;
    grip.orientation = turn_of(*orientation);
    return grip.orientation.has_value();
}

}  // namespace

Understood read_message(const std::string& text, Message& message) {
    message = {};
    const json document = json::parse(text, nullptr, false);
    if (document.is_discarded()) return Understood::not_json;
    const json* const devices = member(document, "inverse3");
    if (member(document, "error") != nullptr || member(document, "errors") != nullptr)
        return Understood::refused;
    if (devices == nullptr || !devices->is_array()) return Understood::other_service;
    bool good = true;
    for (const json& one : *devices) {
        if (message.devices.size() == most_devices) break;
        Inverse3 device;
        good = read_inverse3(one, device) && good;
        if (!device.id.empty()) message.devices.push_back(std::move(device));
    }
    for (const char* kind : {"verse_grip", "wireless_verse_grip"}) {
        const json* const grips = member(document, kind);
        if (grips == nullptr || !grips->is_array()) continue;
        for (const json& one : *grips) {
            if (message.grips.size() == most_devices) break;
            Grip grip;
            good = read_grip(one, grip) && good;
            message.grips.push_back(std::move(grip));
        }
    }
    return good ? Understood::yes : Understood::not_numbers;
}

std::optional<Event> read_event(const std::string& text) {
    const json document = json::parse(text, nullptr, false);
    Event event;
    event.name = text_of(document, "name");
    if (event.name.empty()) return std::nullopt;
    if (const json* const data = member(document, "data")) event.device = text_of(*data, "device_id");
    return event;
}

std::string force_command(const std::vector<std::pair<std::string, Vector3>>& forces, ForceForm form) {
    json devices = json::array();
    for (const auto& [id, force] : forces) {
        json numbers;
        for (int axis = 0; axis < 3; ++axis) numbers[axis_names[axis]] = force[axis];
        devices.push_back(
            {{"device_id", id},
             {"commands",
              {{"set_cursor_force", {{form == ForceForm::vector ? "vector" : "values", numbers}}}}}});
    }
    return json{{"inverse3", std::move(devices)}}.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace fulcrum::haply
