// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/limits_in_force.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <map>
#include <string>
#include <utility>

#include "sim_core/numerics/name_table.h"
#include "sim_core/scene/standard_names.h"

namespace fulcrum::database {

std::vector<LimitsPutInForce> limits_put_in_force(Connection& connection) {
    Query rows(connection,
               "SELECT a.digest, a.time, t.text FROM asset_acceptance a JOIN asset_text t ON t.digest = "
               "a.digest WHERE a.file NOT LIKE 'curricula/%' ORDER BY a.time, a.digest");
    std::map<std::pair<std::string, DeviceClass>, int> newest;  // version by what the set is for
    std::vector<LimitsPutInForce> limits;
    while (rows.next()) {
        const QJsonObject set = QJsonDocument::fromJson(QByteArray::fromStdString(rows.text(2))).object();
        const auto word = [&](const char* key) {
            return set.value(QLatin1String(key)).toString().toStdString();
        };
        const auto* device = find_row(device_classes, word("device_class"));
        const QJsonValue provisional = set.value(QLatin1String("provisional"));
        if (device == nullptr || !provisional.isBool() || word("variant_family") != standard_variant ||
            word("fidelity") != standard_fidelity)
            continue;
        int& known = newest[{word("task"), device->kind}];
        const int version = set.value(QLatin1String("version")).toInt();
        if (version <= known) continue;
        known = version;
        limits.push_back({rows.text(0), word("task"), device->kind, rows.integer(1), provisional.toBool()});
    }
    return limits;
}

}  // namespace fulcrum::database
