// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QString>

namespace fulcrum::database {

std::string json_object(std::initializer_list<std::pair<const char*, std::string>> members) {
    std::string text = "{";
    for (const auto& [key, value] : members) {
        if (text.size() > 1) text += ", ";
        // An array of one string gives Qt's escaping with the least code.
        const QByteArray escaped =
            QJsonDocument(QJsonArray{QString::fromStdString(value)}).toJson(QJsonDocument::Compact);
        text += "\"" + std::string(key) + "\": " + escaped.mid(1, escaped.size() - 2).toStdString();
    }
    return text + "}";
}

std::string json_intervals(const std::vector<std::pair<double, double>>& intervals) {
    QJsonArray array;
    for (const auto& [begin, end] : intervals) array.append(QJsonArray{begin, end});
    return QJsonDocument(array).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<std::pair<double, double>> parse_intervals(const std::string& text) {
    std::vector<std::pair<double, double>> intervals;
    const QJsonArray array = QJsonDocument::fromJson(QByteArray::fromStdString(text)).array();
    for (const QJsonValue& value : array) {
        const QJsonArray pair = value.toArray();
        if (pair.size() == 2 && pair.at(0).isDouble() && pair.at(1).isDouble()) {
            intervals.emplace_back(pair.at(0).toDouble(), pair.at(1).toDouble());
        }
    }
    return intervals;
}

}  // namespace fulcrum::database
