// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/force_devices.h"

#include <QJsonDocument>
#include <QJsonObject>

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

}  // namespace

std::string force_devices_text(const ForceDevices& devices) {
    QJsonObject hands;
    for (std::size_t h = 0; h < devices.size(); ++h) {
        if (!devices[h]) continue;
        QJsonObject values;
        for (const ForceKey& key : force_keys) values[QLatin1String(key.name)] = (*devices[h]).*key.value;
        hands[QLatin1String(hand_name(static_cast<Hand>(h)))] = values;
    }
    return hands.isEmpty() ? std::string()
                           : QJsonDocument(hands).toJson(QJsonDocument::Compact).toStdString();
}

ForceDevices force_devices_of(const std::string& text, const std::string& place) {
    ForceDevices devices;
    if (text.empty()) return devices;
    const auto corrupt = [&](const std::string& wrong) {
        throw StoreError(StoreErrorKind::corrupt, place + ": " + wrong,
                         "use the program version that wrote the store, or restore the newest backup");
    };
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isObject()) corrupt("the text is not a JSON object");
    const QJsonObject hands = document.object();
    for (const QString& name : hands.keys()) {
        const bool left = name == QLatin1String(hand_name(Hand::left));
        if (!left && name != QLatin1String(hand_name(Hand::right)))
            corrupt("'" + name.toStdString() + "' is not a hand");
        const QJsonObject values = hands[name].toObject();
        ForceOutput output;
        for (const ForceKey& key : force_keys) {
            const QJsonValue value = values[QLatin1String(key.name)];
            if (!value.isDouble()) corrupt(std::string("'") + key.name + "' is not a number");
            output.*key.value = value.toDouble();
        }
        if (!is_usable(output)) corrupt("a value of the " + name.toStdString() + " hand is out of range");
        devices[left ? 0 : 1] = output;
    }
    return devices;
}

}  // namespace fulcrum::database
