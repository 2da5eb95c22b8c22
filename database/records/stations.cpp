// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/stations.h"

#include <algorithm>

#include "database/rows/connection.h"
#include "database/store/signing_keys.h"

namespace fulcrum::database {

std::vector<KnownStation> known_stations(const Store& store, const Session& session) {
    store.require(session, Operation::view_audit);
    Connection& connection = store.connection();
    Query rows(
        connection,
        "SELECT s.id, s.name, s.created, COALESCE(a.attempts, 0), COALESCE(a.newest, 0), "
        "COALESCE((SELECT MAX(e.time) FROM audit_entry e WHERE e.station_id = s.id), 0) "
        "FROM station s LEFT JOIN (SELECT station_id, COUNT(*) AS attempts, MAX(started) AS newest FROM "
        "attempt GROUP BY station_id) a ON a.station_id = s.id ORDER BY s.name, s.id");
    std::vector<KnownStation> stations;
    while (rows.next()) {
        KnownStation one;
        one.id = rows.text(0);
        one.name = rows.text(1);
        one.own = one.id == store.station_id();
        one.created = rows.integer(2);
        one.attempts = rows.integer(3);
        one.newest = std::max(rows.integer(4), rows.integer(5));
        stations.push_back(std::move(one));
    }
    for (KnownStation& one : stations) {
        const std::vector<SigningKey> keys = signing_keys(connection, one.id);
        if (!keys.empty()) one.key = keys.back().fingerprint;
    }
    std::stable_partition(stations.begin(), stations.end(), [](const KnownStation& one) { return one.own; });
    return stations;
}

}  // namespace fulcrum::database
