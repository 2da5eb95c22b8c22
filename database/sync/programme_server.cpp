// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/programme_server.h"

#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <map>
#include <set>

#include "database/records/people_rows.h"
#include "database/schema/server_version.h"
#include "database/store/audit.h"
#include "database/store/record_digests.h"
#include "database/store/server_roles.h"
#include "database/store/signing_keys.h"
#include "database/sync/erasure.h"
#include "database/sync/server_enrolment.h"
#include "database/sync/server_schema.h"

namespace fulcrum::database {
namespace {

/// What is written once: its digest is in the signed log of the station where it was made.
constexpr RecordKind written_once[] = {
    RecordKind::attempt,         RecordKind::trace,          RecordKind::score,
    RecordKind::attempt_void,    RecordKind::comment,        RecordKind::correction,
    RecordKind::decision,        RecordKind::rating,         RecordKind::reassignment,
    RecordKind::curriculum_move, RecordKind::rating_release, RecordKind::error_review};

/// Compares the rows of attempts, scores and reviews with the digests that the stations signed.
void check_server_records(Connection& server, ServerCheck& check) {
    std::map<std::string, std::set<std::string>> known;
    {
        std::map<std::string, std::string> newest;  // of one station
        std::string station;
        const auto take = [&] {
            for (auto& [name, digest] : newest) known[name].insert(std::move(digest));
            newest.clear();
        };
        Query rows(server,
                   "SELECT e.station_id, p.payload FROM audit_entry e JOIN audit_payload p ON p.station_id = "
                   "e.station_id AND p.sequence = e.sequence WHERE e.operation <> 'sync.receive' ORDER BY "
                   "e.station_id, "
                   "e.sequence");
        while (rows.next()) {
            if (rows.text(0) != station) take();
            station = rows.text(0);
            const QJsonObject said =
                QJsonDocument::fromJson(QByteArray::fromStdString(rows.text(1))).object();
            const QJsonObject records = said.value(QLatin1String(records_key)).toObject();
            for (auto one = records.begin(); one != records.end(); ++one)
                newest[one.key().toStdString()] = one.value().toString().toStdString();
        }
        take();
    }
    RecordDigests digests(server);
    const auto was_signed_before = [&digests](const RecordName& name,
                                              const std::set<std::string>& signed_as) {
        const std::string before = digests.of_before_origins(name);
        return !before.empty() && signed_as.count(before) != 0;
    };
    for (const RecordKind kind : written_once) {
        for (std::string& id : digests.ids(kind)) {
            const RecordName name{kind, std::move(id)};
            ++check.records;
            const auto found = known.find(name.text());
            if (found == known.end())
                check.problems.push_back(
                    {QT_TRANSLATE_NOOP("errors",
                                       "%1: there without an audit row (if a sync was cut off, the station's "
                                       "next one brings it, unless its store was replaced by an older copy)"),
                     name.text()});
            else if (found->second.count(digests.of(name)) == 0 && !was_signed_before(name, found->second))
                check.problems.push_back(
                    {QT_TRANSLATE_NOOP("errors", "%1: not as the station that made it has signed it"),
                     name.text()});
        }
    }
}

}  // namespace

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
    check.audit_head = server_audit_head(server);
    AuditRows erased;
    Query rows(server, "SELECT station_id, sequence FROM erased_payload");
    while (rows.next()) erased[rows.text(0)].insert(rows.integer(1));
    check.problems = verify_audit_chains(server, erased);
    SignatureCheck signatures = verify_audit_signatures(server, {});
    check.signatures = signatures.count;
    for (Sentence& problem : signatures.problems) check.problems.push_back(std::move(problem));
    check.notes = std::move(signatures.notes);
    for (Sentence& note : claims_that_were_refused(server)) check.notes.push_back(std::move(note));
    for (Sentence& problem : stations_with_other_keys(server)) check.problems.push_back(std::move(problem));
    check_proofs(server, check.problems, check.notes);
    check_server_records(server, check);
    for (Sentence& problem : merged_into_erased(server)) check.problems.push_back(std::move(problem));
    return check;
}

ServerAccount grant_at_programme_server(const ServerAddress& address, const std::string& login) {
    Connection server(address);
    require_server(server);
    Transaction transaction(server);
    ServerAccount account;
    {
        Query person(
            server,
            "SELECT id, login, display_name, active FROM person WHERE login_key = ? AND kind = 'real'");
        person.bind(login_key(login));
        if (!person.next())
            throw StoreError(
                StoreErrorKind::not_found,
                {QT_TRANSLATE_NOOP("errors", "%1: has no person with the login %2"), address.text(), login},
                QT_TRANSLATE_NOOP("errors", "sync the station that knows the person first"));
        account.name = person.text(0);
        account.login = person.text(1);
        account.display_name = person.text(2);
        if (person.flag(3))
            for (const Role role : roles_of(server, account.name))
                if (std::count(std::begin(server_roles), std::end(server_roles), role) > 0)
                    account.roles.push_back(role);
    }
    {
        Query there(server, "SELECT 1 FROM pg_roles WHERE rolname = ?");
        there.bind(account.name);
        account.made = !there.next();
    }
    if (account.made && account.roles.empty())
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "%1 is not an active trainee, educator or director"), account.login},
            QT_TRANSLATE_NOOP("errors",
                              "accounts of a server are for these; give the person the role first"));
    const QString name = '"' + QString::fromStdString(account.name).replace('"', "\"\"") + '"';
    if (account.made) server.execute("CREATE ROLE " + name + " LOGIN");
    for (const Role role : server_roles) {
        const bool held = std::find(account.roles.begin(), account.roles.end(), role) != account.roles.end();
        Query member(server,
                     "SELECT 1 FROM pg_auth_members m JOIN pg_roles g ON g.oid = m.roleid JOIN pg_roles p ON "
                     "p.oid = m.member WHERE g.rolname = ? AND p.rolname = ?");
        member.bind(server_group(role)).bind(account.name);
        if (member.next() == held) continue;
        server.execute(QString(held ? "GRANT %1 TO %2" : "REVOKE %1 FROM %2")
                           .arg(QString::fromStdString(server_group(role)), name));
    }
    transaction.commit();
    ServerAddress own = address;
    own.user = account.name;
    account.address = own.text();
    return account;
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
