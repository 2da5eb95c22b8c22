// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/rating_seen.h"

#include <vector>

#include "database/records/attempt_query.h"
#include "database/records/ratings.h"

namespace fulcrum::database {
namespace {

/// This attempt itself was opened, or is a copy of one that was.
bool is_noted(Connection& connection, const Session& rater, const std::string& attempt_id) {
    Query seen(connection, "SELECT 1 FROM rating_seen WHERE attempt_id = ? AND person_id = ?");
    seen.bind(attempt_id).bind(rater.person_id());
    return seen.next();
}

/// The attempt and the copies that a reassignment made of it, of those that are not noted yet and that the
/// account sees. A station of some cohorts may have the copy and not the original.
std::vector<std::string> to_note_at_server(Connection& server, const Session& rater,
                                           const std::string& attempt_id) {
    Query rows(server,
               "WITH RECURSIVE same (id) AS (SELECT a.id FROM attempt a WHERE a.id = ? UNION SELECT c.to_id "
               "FROM attempt_reassignment c JOIN same ON c.from_id = same.id) SELECT same.id FROM same JOIN "
               "attempt a ON a.id = same.id WHERE NOT EXISTS (SELECT 1 FROM rating_seen s WHERE s.attempt_id "
               "= same.id AND s.person_id = ?)");
    rows.bind(attempt_id).bind(rater.person_id());
    std::vector<std::string> ids;
    while (rows.next()) ids.push_back(rows.text(0));
    return ids;
}

/// The only rows that are written at a server, with a right of their own: without them somebody could look an
/// attempt up there and then rate it "blind" at a station.
void note_seen_at_server(Connection& server, const Session& rater, const std::string& attempt_id,
                         UtcMilliseconds now) {
    const std::vector<std::string> ids = to_note_at_server(server, rater, attempt_id);
    if (ids.empty()) return;
    Transaction transaction(server);
    server.execute("SET TRANSACTION READ WRITE");
    for (const std::string& id : ids)
        Query(server,
              "INSERT INTO rating_seen (attempt_id, person_id, time) VALUES (?, ?, ?) ON CONFLICT DO NOTHING")
            .bind(id)
            .bind(rater.person_id())
            .bind(now)
            .run();
    transaction.commit();
}

}  // namespace

QString seen_attempts() {
    return QStringLiteral(
        "WITH RECURSIVE seen (id) AS (SELECT attempt_id FROM rating_seen WHERE person_id = ? UNION SELECT "
        "c.to_id FROM attempt_reassignment c JOIN seen ON c.from_id = seen.id) SELECT id FROM seen");
}

bool has_seen(Connection& connection, const Session& rater, const std::string& attempt_id) {
    Query seen(connection, "SELECT 1 WHERE ? IN (" + seen_attempts() + ")");
    seen.bind(attempt_id).bind(rater.person_id());
    return seen.next();
}

void note_copies(Connection& connection, const QString& whose, const std::string& value) {
    Query(connection,
          "INSERT INTO rating_seen (attempt_id, person_id, time) WITH RECURSIVE seen (attempt_id, person_id, "
          "time) AS (SELECT s.attempt_id, s.person_id, s.time FROM rating_seen s WHERE " +
              whose +
              " UNION SELECT c.to_id, seen.person_id, seen.time FROM attempt_reassignment c JOIN seen ON "
              "c.from_id = seen.attempt_id) SELECT attempt_id, person_id, MIN(time) FROM seen WHERE 1 = 1 "
              "GROUP BY attempt_id, person_id ON CONFLICT DO NOTHING")
        .bind(value)
        .run();
}

bool Ratings::is_blind(const Session& rater, const std::string& attempt_id) const {
    Query row(
        store_.connection(),
        "SELECT 1 FROM rating WHERE attempt_id = ? AND rater_id = ? AND handed_in = 0 AND blinding = 'kept'");
    row.bind(attempt_id).bind(rater.person_id());
    return row.next();
}

void Ratings::note_seen(const Session& rater, const std::string& attempt_id) const {
    const std::string person = person_of(store_, attempt_id);
    Connection& connection = store_.connection();
    if (store_.is_server()) {
        if (scope_of(rater.role(), Operation::rate) != Scope::none && person != rater.person_id())
            note_seen_at_server(connection, rater, attempt_id, store_.now());
        return;
    }
    if (store_.is_read_only() || !store_.allowed(rater, Operation::rate, Subject::person(person))) return;
    if (is_noted(connection, rater, attempt_id) && !is_blind(rater, attempt_id)) return;
    Transaction transaction(connection);
    if (!is_noted(connection, rater, attempt_id))
        Query(connection, "INSERT INTO rating_seen (attempt_id, person_id, time) VALUES (?, ?, ?)")
            .bind(attempt_id)
            .bind(rater.person_id())
            .bind(store_.now())
            .run();
    note_copies(connection, "s.attempt_id = ?", attempt_id);
    Query(connection,
          "UPDATE rating SET blinding = 'lifted' WHERE attempt_id = ? AND rater_id = ? AND handed_in = 0 AND "
          "blinding = 'kept'")
        .bind(attempt_id)
        .bind(rater.person_id())
        .run();
    transaction.commit();
}

}  // namespace fulcrum::database
