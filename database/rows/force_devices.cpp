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
    const auto corrupt = [&](const Sentence& wrong) {
        throw StoreError(
            StoreErrorKind::corrupt, {"%1: %2", place, wrong},
            QT_TRANSLATE_NOOP("errors",
                              "use the program version that wrote the store, or restore the newest backup"));
    };
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isObject()) corrupt(QT_TRANSLATE_NOOP("errors", "the text is not a JSON object"));
    const QJsonObject hands = document.object();
    for (const QString& name : hands.keys()) {
        const bool left = name == QLatin1String(hand_name(Hand::left));
        if (!left && name != QLatin1String(hand_name(Hand::right)))
            corrupt({QT_TRANSLATE_NOOP("errors", "'%1' is not a hand"), name.toStdString()});
        const QJsonObject values = hands[name].toObject();
        ForceOutput output;
        for (const ForceKey& key : force_keys) {
            const QJsonValue value = values[QLatin1String(key.name)];
            if (!value.isDouble()) corrupt({QT_TRANSLATE_NOOP("errors", "'%1' is not a number"), key.name});
            output.*key.value = value.toDouble();
        }
        if (!is_usable(output))
            corrupt(
                {QT_TRANSLATE_NOOP("errors", "a value of the %1 hand is out of range"), name.toStdString()});
        devices[left ? 0 : 1] = output;
    }
    return devices;
}

}  // namespace fulcrum::database
