// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/server_enrolment.h"

#include <QDateTime>
#include <algorithm>

#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/schema/server_version.h"
#include "database/store/signing_keys.h"
#include "database/store/station_key.h"
#include "database/sync/enrolment_token.h"

namespace fulcrum::database {
namespace {

UtcMilliseconds server_now(Connection& server) {
    Query row(server, "SELECT (extract(epoch FROM clock_timestamp()) * 1000)::bigint");
    return row.next() ? row.integer(0) : 0;
}

void write_log(Connection& server, const char* operation, const std::string& object,
               const std::string& detail) {
    Query(server,
          "INSERT INTO server_log (time, account, operation, object, detail) VALUES ((extract(epoch FROM "
          "clock_timestamp()) * 1000)::bigint, session_user::text, ?, ?, ?)")
        .bind(operation)
        .bind(object)
        .bind(detail)
        .run();
}

std::vector<std::string> cohort_ids(Connection& server, const std::vector<std::string>& cohorts) {
    std::vector<std::string> ids;
    for (const std::string& cohort : cohorts) {
        Query row(server, "SELECT id FROM cohort WHERE id = ? OR name = ? ORDER BY id = ? DESC");
        row.bind(cohort).bind(cohort).bind(cohort);
        if (!row.next())
            throw StoreError(
                StoreErrorKind::not_found,
                {QT_TRANSLATE_NOOP("errors", "%1: has no cohort %2"), server.path(), cohort},
                QT_TRANSLATE_NOOP("errors",
                                  "sync the station where the cohort was made first, and write its name as "
                                  "there"));
        if (std::find(ids.begin(), ids.end(), row.text(0)) == ids.end()) ids.push_back(row.text(0));
    }
    return ids;
}

std::vector<std::string> names_of_cohorts(Connection& server, const std::string& enrolment) {
    Query rows(server,
               "SELECT c.name FROM enrolment_cohort m JOIN cohort c ON c.id = m.cohort_id WHERE "
               "m.enrolment_id = ? ORDER BY c.name");
    rows.bind(enrolment);
    std::vector<std::string> names;
    while (rows.next()) names.push_back(rows.text(0));
    return names;
}

/// Of ids of enrolments only: digits and small letters.
QString role_named(const char* prefix, const std::string& id) {
    return QString("\"%1%2\"").arg(QLatin1String(prefix), QString::fromStdString(id));
}

bool has_role(Connection& server, const std::string& name) {
    Query row(server, "SELECT 1 FROM pg_roles WHERE rolname = ?");
    row.bind(name);
    return row.next();
}

/// An account without rights but that of its group.
void drop_token_account(Connection& server, const std::string& id) {
    if (!has_role(server, EnrolmentToken::token_account_prefix + id)) return;
    server.execute("DROP ROLE " + role_named(EnrolmentToken::token_account_prefix, id));
}

void drop_ended_accounts(Connection& server, UtcMilliseconds now) {
    std::vector<std::string> ended;
    {
        Query rows(server, "SELECT id FROM enrolment WHERE expires < ?");
        rows.bind(now);
        while (rows.next()) ended.push_back(rows.text(0));
    }
    for (const std::string& id : ended) drop_token_account(server, id);
}

}  // namespace

TokenMade make_enrolment_token(const ServerAddress& address, const std::string& name,
                               const std::vector<std::string>& cohorts, int hours) {
    if (hours < shortest_token_h || hours > longest_token_h)
        throw StoreError(StoreErrorKind::bad_value,
                         {QT_TRANSLATE_NOOP("errors", "a token is good for %1 to %2 hours (not %3)"),
                          shortest_token_h, longest_token_h, hours},
                         QT_TRANSLATE_NOOP("errors", "choose as long as it takes to reach the station"));
    Connection server(address);
    const std::string server_id = require_server(server);
    Transaction transaction(server);
    const UtcMilliseconds now = server_now(server);
    constexpr UtcMilliseconds ms_per_hour = 3600 * 1000;
    const EnrolmentToken token = EnrolmentToken::make(server_id, now + hours * ms_per_hour);
    drop_ended_accounts(server, now);
    Query(server,
          "INSERT INTO enrolment (id, name, made, made_by, expires, proof) VALUES (?, ?, ?, "
          "session_user::text, ?, ?)")
        .bind(token.id)
        .bind(name)
        .bind(now)
        .bind(token.until)
        .bind(token.proof())
        .run();
    for (const std::string& id : cohort_ids(server, cohorts))
        Query(server, "INSERT INTO enrolment_cohort (enrolment_id, cohort_id) VALUES (?, ?)")
            .bind(token.id)
            .bind(id)
            .run();
    const QString until =
        QDateTime::fromMSecsSinceEpoch(token.until, Qt::UTC).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"));
    server.execute(QString("CREATE ROLE %1 LOGIN PASSWORD '%2' VALID UNTIL '%3+00' IN ROLE fulcrum_enrol")
                       .arg(role_named(EnrolmentToken::token_account_prefix, token.id),
                            QString::fromStdString(scram_verifier(token.password())), until));
    TokenMade made{token.text(), token.id, token.until, names_of_cohorts(server, token.id)};
    write_log(server, "enrolment.make", token.id, name);
    transaction.commit();
    return made;
}

std::vector<EnrolledStation> enrolled_stations(const ServerAddress& address) {
    Connection server(address);
    const std::string server_id = require_server(server);
    std::vector<EnrolledStation> stations;
    const UtcMilliseconds now = server_now(server);
    {
        const char* kept =
            server_asks_for_proof(server) ? "COALESCE(e.statement, ''), COALESCE(e.signature, '')" : "'', ''";
        Query rows(server,
                   "SELECT e.id, e.name, e.made_by, COALESCE(e.station_id, ''), e.made, e.expires, "
                   "COALESCE(e.used, 0), COALESCE(e.withdrawn, 0), e.public_half, COALESCE((SELECT a.time "
                   "FROM audit_entry a WHERE a.station_id = e.station_id ORDER BY a.sequence DESC LIMIT 1), "
                   "0), " +
                       QString(kept) + " FROM enrolment e ORDER BY e.made DESC, e.id");
        while (rows.next()) {
            EnrolledStation one;
            one.id = rows.text(0);
            one.name = rows.text(1);
            one.made_by = rows.text(2);
            one.station_id = rows.text(3);
            one.made = rows.integer(4);
            one.expires = rows.integer(5);
            one.used = rows.integer(6);
            one.withdrawn = rows.integer(7);
            if (!rows.is_null(8)) one.key = key_fingerprint(rows.bytes(8));
            one.last_row = rows.integer(9);
            if (one.used != 0)
                one.proof = look_at_proof(
                    server_id, {one.id, one.station_id, rows.text(10), rows.bytes(8), rows.bytes(11)});
            one.state = one.withdrawn != 0   ? EnrolledStation::State::withdrawn
                        : one.used != 0      ? EnrolledStation::State::enrolled
                        : one.expires >= now ? EnrolledStation::State::open
                                             : EnrolledStation::State::ended;
            if (one.used != 0) one.account = EnrolmentToken::station_account_prefix + one.id;
            stations.push_back(std::move(one));
        }
    }
    for (EnrolledStation& one : stations) one.cohorts = names_of_cohorts(server, one.id);
    return stations;
}

void withdraw_enrolment(const ServerAddress& address, const std::string& id) {
    Connection server(address);
    require_server(server);
    Transaction transaction(server);
    const UtcMilliseconds now = server_now(server);
    std::vector<std::string> found;
    {
        Query rows(
            server,
            "SELECT id FROM enrolment WHERE (id = ? OR station_id = ?) AND withdrawn IS NULL FOR UPDATE");
        rows.bind(id).bind(id);
        while (rows.next()) found.push_back(rows.text(0));
    }
    if (found.empty())
        throw StoreError(
            StoreErrorKind::not_found,
            {QT_TRANSLATE_NOOP("errors", "%1: has no token and no enrolled station %2"), address.text(), id},
            QT_TRANSLATE_NOOP("errors", "give an id that `fulcrum server stations` prints"));
    for (const std::string& one : found) {
        Query(server, "UPDATE enrolment SET withdrawn = ? WHERE id = ?").bind(now).bind(one).run();
        const std::string account = EnrolmentToken::station_account_prefix + one;
        if (has_role(server, account)) {
            const QString role = role_named(EnrolmentToken::station_account_prefix, one);
            server.execute("ALTER ROLE " + role + " NOLOGIN");
            server.execute("REVOKE fulcrum_station FROM " + role);
        }
        write_log(server, "enrolment.withdraw", one, {});
    }
    transaction.commit();
}

std::vector<Sentence> stations_with_other_keys(Connection& server) {
    std::vector<Sentence> problems;
    Query rows(server,
               "SELECT station_id, public_half FROM enrolment WHERE used IS NOT NULL AND withdrawn IS NULL");
    while (rows.next()) {
        const std::vector<SigningKey> keys = signing_keys(server, rows.text(0));
        const std::string enrolled = key_fingerprint(rows.bytes(1));
        if (!keys.empty() && !leads_to_newest(keys, enrolled))
            problems.push_back(
                {QT_TRANSLATE_NOOP(
                     "errors",
                     "station %1: its log is signed by the key %2, not by %3, with which it was "
                     "enrolled, nor by one that leads from it"),
                 rows.text(0), keys.back().fingerprint, enrolled});
    }
    return problems;
}

std::vector<Sentence> claims_that_were_refused(Connection& server) {
    std::vector<Sentence> notes;
    Query rows(
        server,
        "SELECT detail, object, time FROM server_log WHERE operation = 'claim.refuse' ORDER BY number");
    while (rows.next())
        notes.push_back(
            {QT_TRANSLATE_NOOP(
                 "errors",
                 "station %1: on %3 it named the person or cohort %2, which the server never gave "
                 "to it, and was refused; if you cannot explain that, end its access (`fulcrum "
                 "server withdraw %1`) and examine the station"),
             rows.text(0), rows.text(1), iso_utc(rows.integer(2))});
    return notes;
}

}  // namespace fulcrum::database
