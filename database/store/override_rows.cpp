// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/override_rows.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "database/rows/enum_column.h"
#include "database/rows/json.h"
#include "database/rows/same_person.h"

namespace fulcrum::database {
namespace {

constexpr NameRow<StandingOverride::Kind> kinds[] = {{StandingOverride::Kind::unlocked, "unlocked", ""},
                                                     {StandingOverride::Kind::proficient, "proficient", ""}};
static_assert(in_order(kinds));

}  // namespace

namespace {

const QString decision_columns =
    "SELECT o.id, o.person_id, o.task_id, o.kind, o.author_id, o.time, o.reason, p.display_name, %1, %2 FROM "
    "standing_override o JOIN person p ON p.id = o.author_id ";

std::vector<OverrideRow> read_decisions(Query& rows) {
    std::vector<OverrideRow> result;
    while (rows.next()) {
        OverrideRow row;
        row.decision = {rows.text(0), rows.text(2),
                        enum_of(rows.text(3), kinds, "kind of decision " + rows.text(0)), rows.integer(5)};
        row.person_id = rows.text(1);
        row.author_id = rows.text(4);
        row.reason = rows.text(6);
        row.author_name = rows.text(7);
        row.owner_id = rows.text(8);
        row.own = !row.owner_id.empty() && rows.text(9) == row.owner_id;
        result.push_back(std::move(row));
    }
    return result;
}

}  // namespace

std::vector<OverrideRow> read_overrides(Connection& connection, const std::string& person_id) {
    Query rows(connection, decision_columns.arg(owner_of("o.person_id"), owner_of("o.author_id")) +
                               (person_id.empty() ? QString() : "WHERE " + belongs_to("o.person_id")) +
                               " ORDER BY o.time DESC, o.id");
    if (!person_id.empty()) rows.bind(person_id);
    return read_decisions(rows);
}

std::vector<OverrideRow> read_raw_overrides(Connection& connection) {
    Query rows(connection, decision_columns.arg("''", "''") + "ORDER BY o.time DESC, o.id");
    return read_decisions(rows);
}

void write_override(Connection& connection, const OverrideRow& row) {
    Query(connection,
          "INSERT INTO standing_override (id, person_id, task_id, kind, author_id, time, reason) "
          "VALUES (?, ?, ?, ?, ?, ?, ?)")
        .bind(row.decision.id)
        .bind(row.person_id)
        .bind(row.decision.task)
        .bind(std::string(row_of(kinds, row.decision.kind).name))
        .bind(row.author_id)
        .bind(row.decision.time)
        .bind(row.reason)
        .run();
}

std::string override_payload(const OverrideRow& row) {
    return json_object({{"kind", row_of(kinds, row.decision.kind).name},
                        {"person", row.person_id},
                        {"reason", row.reason},
                        {"task", row.decision.task}});
}

bool is_payload_of(const std::string& payload, const OverrideRow& row) {
    const auto parse = [](const std::string& json) {
        return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
    };
    const QJsonObject stored = parse(payload), made = parse(override_payload(row));
    for (auto member = made.begin(); member != made.end(); ++member)
        if (stored.value(member.key()) != member.value()) return false;
    return true;
}

}  // namespace fulcrum::database
