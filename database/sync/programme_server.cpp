// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/programme_server.h"

#include <QDateTime>

#include "database/store/audit.h"
#include "database/sync/erasure.h"
#include "database/sync/server_schema.h"

namespace fulcrum::database {

ServerSchema create_programme_server(const ServerAddress& address) {
    Connection server(address);
    return create_server(server, QDateTime::currentMSecsSinceEpoch());
}

ServerCheck check_programme_server(const ServerAddress& address) {
    Connection server(address);
    require_server(server);
    ServerCheck check;
    Query counts(server, "SELECT COUNT(DISTINCT station_id), COUNT(*) FROM audit_entry");
    if (counts.next()) {
        check.stations = counts.integer(0);
        check.audit_rows = counts.integer(1);
    }
    AuditRows erased;
    Query rows(server, "SELECT station_id, sequence FROM erased_payload");
    while (rows.next()) erased[rows.text(0)].insert(rows.integer(1));
    check.problems = verify_audit_chains(server, erased);
    for (std::string& problem : verify_audit_signatures(server, {}, check.signatures))
        check.problems.push_back(std::move(problem));
    return check;
}

std::vector<ErasedRows> erase_at_programme_server(const ServerAddress& address, const std::string& person_id,
                                                  bool dry_run) {
    Connection server(address);
    require_server(server);
    std::vector<ErasedRows> rows = rows_to_erase(server, person_id);
    if (!dry_run) erase_on_server(server, person_id, QDateTime::currentMSecsSinceEpoch());
    return rows;
}

}  // namespace fulcrum::database
