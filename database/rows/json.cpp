// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QString>
#include <charconv>
#include <cmath>
#include <optional>

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

namespace {

/// Of what json_intervals() writes; empty for any other text. A tenth of the time of a document.
std::optional<std::vector<std::pair<double, double>>> written_intervals(const std::string& text) {
    const char *at = text.data(), *const end = at + text.size();
    const auto take = [&](char c) { return at != end && *at == c ? (++at, true) : false; };
    const auto number = [&](double& value) {
        const std::from_chars_result read = std::from_chars(at, end, value);
        const bool is_read = read.ec == std::errc() && std::isfinite(value);
        at = read.ptr;
        return is_read;
    };
    std::vector<std::pair<double, double>> intervals;
    if (!take('[')) return std::nullopt;
    if (take(']')) return at == end ? std::make_optional(intervals) : std::nullopt;
    do {
        std::pair<double, double> one;
        if (!take('[') || !number(one.first) || !take(',') || !number(one.second) || !take(']'))
            return std::nullopt;
        intervals.push_back(one);
    } while (take(','));
    return take(']') && at == end ? std::make_optional(std::move(intervals)) : std::nullopt;
}

}  // namespace

std::vector<std::pair<double, double>> parse_intervals(const std::string& text) {
    if (auto written = written_intervals(text)) return *std::move(written);
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
