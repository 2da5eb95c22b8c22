// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/enrolment.h"

#include <algorithm>

#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/schema/server_version.h"
#include "database/store/audit.h"
#include "database/store/station_key.h"
#include "database/sync/enrolment_proof.h"
#include "database/sync/enrolment_token.h"
#include "database/sync/server_link.h"

namespace fulcrum::database {
namespace {

[[noreturn]] void refuse_token(const Sentence& problem, const Sentence& hint) {
    throw StoreError(StoreErrorKind::conflict, problem, hint);
}

const char* const ask_for_another =
    QT_TRANSLATE_NOOP("errors", "ask the server's owner for a new one (`fulcrum server enrol`)");

bool is_refused_account(const StoreError& error) {
    const auto* refused = dynamic_cast<const ConnectError*>(&error);
    return refused != nullptr &&
           (refused->why() == ServerRefusal::password || refused->why() == ServerRefusal::account);
}

/// A connection that the server refuses for the token's account says nothing of why.
[[noreturn]] void refuse_unknown(const Store& store, const EnrolmentToken& token, const std::string& server) {
    if (token.until < store.now())
        refuse_token({QT_TRANSLATE_NOOP("errors", "the token was good until %1"), iso_utc(token.until)},
                     ask_for_another);
    refuse_token(
        {QT_TRANSLATE_NOOP("errors", "%1: does not know this token"), server},
        QT_TRANSLATE_NOOP("errors",
                          "it is for another server, or it was withdrawn: check the address, or ask the "
                          "server's owner for a new one (`fulcrum server enrol`)"));
}

StationKey key_of_store(const Store& store) {
    Transaction transaction(store.connection());
    StationKey key = Audit(store).next_key();
    transaction.commit();
    return key;
}

struct Answer {
    std::string answer, about;
    UtcMilliseconds since = 0;
};

[[noreturn]] void refuse_answer(const Store& store, const EnrolmentToken& token, const Answer& said,
                                const std::string& server) {
    if (said.answer == "used" && said.about == store.station_id())
        refuse_token({QT_TRANSLATE_NOOP("errors", "this station has used this token already, on %1"),
                      iso_utc(said.since)},
                     QT_TRANSLATE_NOOP("errors",
                                       "run `fulcrum sync`; if the password of its account was lost, ask the "
                                       "server's owner for a new token (`fulcrum server enrol`)"));
    if (said.answer == "used")
        refuse_token(
            {QT_TRANSLATE_NOOP("errors", "another station has used this token, on %1: %2"),
             iso_utc(said.since), said.about},
            QT_TRANSLATE_NOOP("errors",
                              "each station needs its own: ask the server's owner for a new one "
                              "(`fulcrum server enrol`), and tell them if that station is not known"));
    if (said.answer == "withdrawn")
        refuse_token({QT_TRANSLATE_NOOP("errors", "the token was withdrawn on %1"), iso_utc(said.since)},
                     ask_for_another);
    if (said.answer == "expired")
        refuse_token({QT_TRANSLATE_NOOP("errors", "the token was good until %1"), iso_utc(said.since)},
                     ask_for_another);
    if (said.answer == "other_key")
        refuse_token(QT_TRANSLATE_NOOP("errors", "the server knows this station with another signing key"),
                     {QT_TRANSLATE_NOOP(
                          "errors",
                          "put the copy of its key back; if the key is lost, have the server's owner run "
                          "`fulcrum server withdraw %1` first"),
                      store.station_id()});
    if (said.answer == "no_proof")
        refuse_token({QT_TRANSLATE_NOOP("errors",
                                        "the server does not accept the signature by which this station "
                                        "proves that it holds its key %1"),
                      Audit(store).signing_key()},
                     QT_TRANSLATE_NOOP("errors",
                                       "the token was not used: install the same version of Fulcrum here and "
                                       "where `fulcrum server create` is run, then give the token again"));
    refuse_unknown(store, token, server);
}

void require_proof(Connection& server) {
    if (server_asks_for_proof(server)) return;
    throw StoreError(StoreErrorKind::older_schema,
                     {QT_TRANSLATE_NOOP("errors",
                                        "%1: was made by an older program, which does not ask a station to "
                                        "prove that it holds its key"),
                      server.path()},
                     Sentence(QT_TRANSLATE_NOOP("errors",
                                                "have its administrator run `fulcrum server create --to "
                                                "%1` with this program; nothing is lost"),
                              server.path()));
}

Answer ask_server(Connection& server, const Store& store, const EnrolmentToken& token, const StationKey& key,
                  const ServerLink& link) {
    const std::string verifier = scram_verifier(link.password);
    const Bytes signature = key.sign_enrolment(
        enrolment_statement(link.server_id, token.id, store.station_id(), key.public_half(), verifier));
    Query row(server, "SELECT answer, about, since FROM enrol_station(?, ?, ?, ?, ?)");
    row.bind(token.proof()).bind(store.station_id()).bind(key.public_half()).bind(verifier).bind(signature);
    if (!row.next()) return {};
    return {row.text(0), row.text(1), row.integer(2)};
}

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find(' ', from), text.size());
        if (end > from) words.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return words;
}

/// Whether the server has the station's account, and only the answer was lost: takes the cohorts from there.
bool is_enrolled_there(ServerLink& link, const std::string& station_id) {
    try {
        Connection server(link.address, false, link.password);
        link.server_id = require_server(server);
        Query row(server, "SELECT station_id, cohorts FROM own_enrolment()");
        if (!row.next() || row.text(0) != station_id) return false;
        link.cohorts = words_of(row.text(1));
        return true;
    } catch (const StoreError& error) {
        if (is_refused_account(error)) return false;
        throw;
    }
}

Enrolment complete(const Store& store, const Session& session, const EnrolmentToken& token,
                   const ServerLink& link, const StationKey& key) {
    {
        Transaction transaction(store.connection());
        std::string cohorts;
        for (const std::string& id : link.cohorts) cohorts += (cohorts.empty() ? "" : " ") + id;
        Audit(store).append(session, store.station_id(), "station.enrol",
                            json_object({{"server", link.server_id},
                                         {"address", link.address.text()},
                                         {"token", token.id},
                                         {"key", key_fingerprint(key.public_half())},
                                         {"cohorts", cohorts}}));
        transaction.commit();
    }
    link.finish(store.station_id(), token.id);
    return {link.address, link.cohorts};
}

}  // namespace

Enrolment enrol_station(const Store& store, const Session& session, const ServerAddress& server,
                        const std::string& typed) {
    if (store.is_demo())
        throw StoreError(StoreErrorKind::sealed_demo,
                         QT_TRANSLATE_NOOP("errors", "the demonstration is never synchronised"),
                         QT_TRANSLATE_NOOP("errors", "name the store of the programme with --db"));
    if (!session.is_station() || store.has_administrator()) store.require(session, Operation::backup);
    const EnrolmentToken token = EnrolmentToken::parse(typed);
    const StationKey key = key_of_store(store);
    ServerLink link;
    link.address = server;
    link.address.user = token.station_account();
    std::optional<ServerLink> begun = ServerLink::unfinished(store.station_id(), token.id);
    // Whatever address leads to the server now: the account that it may have made has this password.
    if (begun) link.password = begun->password;
    try {
        ServerAddress asking = server;
        asking.user = token.account();
        Connection connection(asking, false, token.password());
        link.server_id = require_server(connection);
        if (link.server_id.compare(0, token.server.size(), token.server) != 0)
            refuse_unknown(store, token, server.text());
        require_proof(connection);
        if (!begun) {
            link.password = to_hex(random_bytes(24));
            if (!link.begin(store.station_id(), token.id)) {
                begun = ServerLink::unfinished(store.station_id(), token.id);
                if (begun) link.password = begun->password;
            }
        }
        const Answer said = ask_server(connection, store, token, key, link);
        if (said.answer == "enrolled") {
            link.cohorts = words_of(said.about);
            return complete(store, session, token, link, key);
        }
        // Answered before, and cut off before this station had written it down.
        const bool was_lost = said.answer == "used" && said.about == store.station_id() && begun &&
                              is_enrolled_there(link, store.station_id());
        if (!was_lost) refuse_answer(store, token, said, server.text());
    } catch (const StoreError& error) {
        if (!is_refused_account(error)) throw;
        // Its end has come; the enrolment may have been complete but for the answer.
        if (!begun || !is_enrolled_there(link, store.station_id()))
            refuse_unknown(store, token, server.text());
    }
    return complete(store, session, token, link, key);
}

bool is_enrolled_at(const Store& store, const ServerAddress& server) {
    const std::optional<ServerLink> link = ServerLink::of(store.station_id());
    ServerAddress without_account = server;
    without_account.user.clear();
    return link && link->is_for(without_account);
}

namespace {

/// Ids of the cohorts whose people the store has; empty: everybody, as at a station of its own.
std::vector<std::string> cohorts_held(const Store& store) {
    if (store.is_demo() || store.connection().is_server()) return {};
    const std::optional<ServerLink> link = ServerLink::of(store.station_id());
    return link ? link->cohorts : std::vector<std::string>();
}

std::string name_of_cohort(const Store& store, const std::string& id) {
    Query name(store.connection(), "SELECT name FROM cohort WHERE id = ?");
    name.bind(id);
    return name.next() ? name.text(0) : id;
}

}  // namespace

std::optional<LinkedServer> linked_server(const Store& store, const Session& session) {
    store.require(session, Operation::backup);
    const std::optional<ServerLink> link = ServerLink::of(store.station_id());
    if (!link) return std::nullopt;
    LinkedServer linked;
    linked.address = link->address.text();
    for (const std::string& id : link->cohorts) linked.cohorts.push_back(name_of_cohort(store, id));
    Query last(store.connection(),
               "SELECT MAX(time) FROM audit_entry WHERE station_id = ? AND operation = 'sync.finish'");
    last.bind(store.station_id());
    if (last.next() && !last.is_null(0)) linked.last_sync = last.integer(0);
    return linked;
}

std::optional<Sentence> station_scope(const Store& store, const Session& session) {
    if (session.role() == Role::trainee) return std::nullopt;
    const std::vector<std::string> held = cohorts_held(store);
    if (held.empty()) return std::nullopt;
    // The names of cohorts that are not an educator's are none of their concern.
    if (session.role() == Role::educator)
        return Sentence(
            QT_TRANSLATE_NOOP("errors",
                              "This station holds only some of the programme's cohorts. Reports from "
                              "the programme server have all of yours."));
    constexpr std::size_t most_names = 5;
    std::vector<std::string> names;
    for (const std::string& id : held) names.push_back(name_of_cohort(store, id));
    std::sort(names.begin(), names.end());
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), most_names); ++i)
        list += (i == 0 ? "" : ", ") + names[i];
    if (names.size() > most_names) list += ", …";
    return Sentence(
        QT_TRANSLATE_NOOP("errors",
                          "This station holds %1 of the programme's cohorts: %2. Reports from the "
                          "programme server have all of them."),
        static_cast<std::int64_t>(names.size()), list);
}

void require_whole_programme(const Store& store) {
    if (cohorts_held(store).empty()) return;
    throw StoreError(StoreErrorKind::conflict,
                     QT_TRANSLATE_NOOP("errors", "this station holds only some of the programme's cohorts"),
                     QT_TRANSLATE_NOOP("errors",
                                       "export from the programme server, or at a station that has the whole "
                                       "programme: the counts of a part could be subtracted from the whole"));
}

}  // namespace fulcrum::database
