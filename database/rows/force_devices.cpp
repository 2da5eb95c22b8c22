// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/force_devices.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <utility>

#include "database/rows/errors.h"

namespace fulcrum::database {
namespace {

struct ForceKey {
    const char* name;
    double ForceOutput::*value;
};
constexpr ForceKey force_keys[] = {
    {"damping_n_s_m", &ForceOutput::damping},   {"peak_n", &ForceOutput::peak},
    {"continuous_n", &ForceOutput::continuous}, {"stiffness_n_m", &ForceOutput::stiffness},
    {"torque_n_m", &ForceOutput::torque},       {"scale", &ForceOutput::scale}};

/// Only where a device has a limit of its own.
constexpr const char* slew_name = "slew_n_s";

constexpr const char* use_key = "device";
constexpr const char* part_keys[] = {"left", "right", "scope"};
constexpr std::pair<const char*, double RigUse::*> use_keys[] = {
    {"stated_hz", &RigUse::stated}, {"measured_hz", &RigUse::measured}, {"motion", &RigUse::motion}};

[[noreturn]] void damaged(const std::string& place, const Sentence& wrong) {
    throw StoreError(
        StoreErrorKind::corrupt, {"%1: %2", place, wrong},
        QT_TRANSLATE_NOOP("errors",
                          "use the program version that wrote the store, or restore the newest backup"));
}

QJsonObject object_of(const std::string& text, const std::string& place) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isObject()) damaged(place, QT_TRANSLATE_NOOP("errors", "the text is not a JSON object"));
    return document.object();
}

double number_of(const QJsonObject& values, const char* name, const std::string& place) {
    const QJsonValue value = values[QLatin1String(name)];
    if (!value.isDouble()) damaged(place, {QT_TRANSLATE_NOOP("errors", "'%1' is not a number"), name});
    return value.toDouble();
}

QJsonObject json_of(const RigUse& use) {
    QJsonObject values;
    for (const auto& [name, member] : use_keys) values[QLatin1String(name)] = use.*member;
    for (std::size_t i = 0; i < use.part.size(); ++i) values[QLatin1String(part_keys[i])] = use.part[i];
    values[QLatin1String("pedal")] = use.pedal;
    return values;
}

}  // namespace

std::string force_devices_text(const ForceDevices& devices, const std::optional<RigUse>& use) {
    QJsonObject hands;
    for (std::size_t h = 0; h < devices.size(); ++h) {
        if (!devices[h]) continue;
        QJsonObject values;
        for (const ForceKey& key : force_keys) values[QLatin1String(key.name)] = (*devices[h]).*key.value;
        if (std::isfinite(devices[h]->slew)) values[QLatin1String(slew_name)] = devices[h]->slew;
        hands[QLatin1String(hand_name(static_cast<Hand>(h)))] = values;
    }
    if (use && is_usable(*use)) hands[QLatin1String(use_key)] = json_of(*use);
    return hands.isEmpty() ? std::string()
                           : QJsonDocument(hands).toJson(QJsonDocument::Compact).toStdString();
}

ForceDevices force_devices_of(const std::string& text, const std::string& place) {
    ForceDevices devices;
    if (text.empty()) return devices;
    const QJsonObject hands = object_of(text, place);
    for (const QString& name : hands.keys()) {
        if (name == QLatin1String(use_key)) continue;
        const bool left = name == QLatin1String(hand_name(Hand::left));
        if (!left && name != QLatin1String(hand_name(Hand::right)))
            damaged(place, {QT_TRANSLATE_NOOP("errors", "'%1' is not a hand"), name.toStdString()});
        const QJsonObject values = hands[name].toObject();
        ForceOutput output;
        for (const ForceKey& key : force_keys) output.*key.value = number_of(values, key.name, place);
        if (values.contains(QLatin1String(slew_name))) output.slew = number_of(values, slew_name, place);
        if (!is_usable(output))
            damaged(place, {QT_TRANSLATE_NOOP("errors", "a value of the %1 hand is out of range"),
                            name.toStdString()});
        devices[left ? 0 : 1] = output;
    }
    return devices;
}

std::optional<RigUse> rig_use_of(const std::string& text, const std::string& place) {
    if (text.empty()) return std::nullopt;
    const QJsonObject hands = object_of(text, place);
    if (!hands.contains(QLatin1String(use_key))) return std::nullopt;
    const QJsonObject values = hands[QLatin1String(use_key)].toObject();
    RigUse use;
    for (const auto& [name, member] : use_keys) use.*member = number_of(values, name, place);
    for (std::size_t i = 0; i < use.part.size(); ++i)
        use.part[i] = static_cast<int>(std::clamp(number_of(values, part_keys[i], place), -9.0, 9.0));
    use.pedal = static_cast<int>(std::clamp(number_of(values, "pedal", place), -9.0, 9.0));
    if (!is_usable(use)) damaged(place, QT_TRANSLATE_NOOP("errors", "a value of the device is out of range"));
    return use;
}

std::string device_json(const std::string& title, const std::optional<RigUse>& use) {
    QJsonObject device = use ? json_of(*use) : QJsonObject();
    device[QLatin1String("title")] = QString::fromStdString(title);
    return QJsonDocument(device).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace fulcrum::database
