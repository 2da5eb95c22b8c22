// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/tissues.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <cmath>

#include "database/rows/connection.h"
#include "database/store/audit.h"

namespace fulcrum::database {
namespace {

QJsonObject json_of(const TissueSetting& setting) {
    QJsonObject tissues;
    for (const auto& [tissue, values] : setting.values) {
        QJsonObject named;
        for (const auto& [name, value] : values) named.insert(QString::fromStdString(name), value);
        tissues.insert(QString::fromStdString(tissue), named);
    }
    return {{QStringLiteral("version"), setting.version}, {QStringLiteral("values"), tissues}};
}

bool is_blank(const std::string& words) {
    return words.find_first_not_of(" \t\r\n") == std::string::npos;
}

}  // namespace

std::vector<TissueSetting> Tissues::read(const std::string& task_id, int limit) const {
    std::vector<TissueSetting> settings;
    Query rows(
        store_.connection(),
        "SELECT s.version, p.display_name, s.reason, s.time FROM tissue_setting s JOIN person p ON p.id = "
        "s.person_id WHERE s.task_id = ? ORDER BY s.version DESC LIMIT ?");
    rows.bind(task_id).bind(limit);
    while (rows.next()) {
        TissueSetting setting{
            static_cast<int>(rows.integer(0)), {}, rows.text(1), rows.text(2), rows.integer(3)};
        Query values(store_.connection(),
                     "SELECT tissue, name, value FROM tissue_value WHERE task_id = ? AND version = ?");
        values.bind(task_id).bind(setting.version);
        while (values.next()) setting.values[values.text(0)][values.text(1)] = values.real(2);
        settings.push_back(std::move(setting));
    }
    return settings;
}

TissueSetting Tissues::in_force(const Session& session, const std::string& task_id) const {
    store_.require(session, Operation::read_tissues);
    std::vector<TissueSetting> newest = read(task_id, 1);
    return newest.empty() ? TissueSetting() : std::move(newest.front());
}

std::vector<TissueSetting> Tissues::history(const Session& session, const std::string& task_id) const {
    store_.require(session, Operation::read_tissues);
    return read(task_id, 1000);
}

int Tissues::set(const Session& educator, const std::string& task_id, int seen, const TissueValues& values,
                 const std::string& reason) const {
    store_.require(educator, Operation::set_tissues);
    if (is_blank(reason))
        throw StoreError(StoreErrorKind::bad_value, QT_TRANSLATE_NOOP("errors", "no reason was given"),
                         QT_TRANSLATE_NOOP("errors", "say in a few words why the values change"));
    for (const auto& [tissue, named] : values) {
        for (const auto& [name, value] : named) {
            if (!std::isfinite(value))
                throw StoreError(StoreErrorKind::bad_value,
                                 {QT_TRANSLATE_NOOP("errors", "%1: %2 is not a number"), tissue, name},
                                 QT_TRANSLATE_NOOP("errors", "give a number"));
        }
    }
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    const TissueSetting before = in_force(educator, task_id);
    if (before.version != seen)
        throw StoreError(StoreErrorKind::conflict,
                         {QT_TRANSLATE_NOOP("errors", "version %1 by %2 came into force in the meantime"),
                          before.version, before.author_name},
                         QT_TRANSLATE_NOOP("errors", "look at its values and set yours again"));
    if (before.values == values)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "these values are in force already"),
                         QT_TRANSLATE_NOOP("errors", "change one of them"));
    TissueSetting after;
    after.version = before.version + 1;
    after.values = values;
    Query(connection,
          "INSERT INTO tissue_setting (task_id, version, person_id, time, reason) VALUES (?, ?, ?, ?, ?)")
        .bind(task_id)
        .bind(after.version)
        .bind(educator.person_id())
        .bind(store_.now())
        .bind(reason)
        .run();
    for (const auto& [tissue, named] : values) {
        for (const auto& [name, value] : named) {
            Query(connection,
                  "INSERT INTO tissue_value (task_id, version, tissue, name, value) VALUES (?, ?, ?, ?, ?)")
                .bind(task_id)
                .bind(after.version)
                .bind(tissue)
                .bind(name)
                .bind(value)
                .run();
        }
    }
    const QJsonObject payload{{QStringLiteral("before"), json_of(before)},
                              {QStringLiteral("after"), json_of(after)},
                              {QStringLiteral("reason"), QString::fromStdString(reason)}};
    Audit(store_).append(educator, task_id, "tissue.set",
                         QJsonDocument(payload).toJson(QJsonDocument::Compact).toStdString(),
                         {{RecordKind::tissues, task_id + " " + std::to_string(after.version)}});
    transaction.commit();
    return after.version;
}

}  // namespace fulcrum::database
