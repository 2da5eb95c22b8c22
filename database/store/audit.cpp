// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/audit.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <map>
#include <set>

#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/store/signing_keys.h"
#include "database/store/station_key.h"

namespace fulcrum::database {

Sentence audit_place(const Connection& connection, const std::string& station, std::int64_t sequence) {
    // A server has the logs of many stations.
    if (connection.is_server())
        return {QT_TRANSLATE_NOOP("errors", "station %1, audit row %2"), station, sequence};
    return {QT_TRANSLATE_NOOP("errors", "audit row %1"), sequence};
}

namespace {

constexpr std::size_t hash_size = 32, salt_size = 32;

void add_number(Bytes& bytes, std::int64_t value) {
    for (int shift = 0; shift < 64; shift += 8) {
        bytes.push_back(
            static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> static_cast<unsigned>(shift)));
    }
}

// With its length before it, so that no two rows give the same bytes.
template <typename Text>
void add_text(Bytes& bytes, const Text& text) {
    add_number(bytes, static_cast<std::int64_t>(text.size()));
    bytes.insert(bytes.end(), text.begin(), text.end());
}

Bytes row_hash(const Bytes& previous, std::int64_t sequence, std::int64_t time, const std::string& station,
               const std::string& actor, const std::string& object, const std::string& operation,
               const Bytes& digest) {
    Bytes bytes;
    add_text(bytes, previous);
    add_number(bytes, sequence);
    add_number(bytes, time);
    add_text(bytes, station);
    add_text(bytes, actor);
    add_text(bytes, object);
    add_text(bytes, operation);
    add_text(bytes, digest);
    return blake2b(bytes, hash_size);
}

Bytes payload_digest(const Bytes& salt, const std::string& payload) {
    Bytes bytes = salt;
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    return blake2b(bytes, hash_size);
}

constexpr const char* role_key = "as";
constexpr const char* erasure = "payload.erase";
constexpr const char* erased_key = "rows";

/// The payload as it is stored: role, what the caller says, digests of records.
std::string stored_payload(Connection& connection, const std::string& payload, Role role,
                           const std::vector<RecordName>& records) {
    std::string text = std::string("{\"") + role_key + "\": \"" + role_name(role) + "\"";
    text += payload == "{}" ? "}" : ", " + payload.substr(1);
    if (records.empty()) return text;
    QJsonObject digests;
    RecordDigests digest(connection);
    for (const RecordName& name : records)
        digests.insert(QString::fromStdString(name.text()), QString::fromStdString(digest.of(name)));
    text.pop_back();
    return text + ", \"" + records_key +
           "\": " + QJsonDocument(digests).toJson(QJsonDocument::Compact).toStdString() + "}";
}

/// Sequences that a row of this operation says were erased.
void add_erased(const std::string& payload, std::set<std::int64_t>& erased) {
    const QJsonObject said = QJsonDocument::fromJson(QByteArray::fromStdString(payload)).object();
    for (const QString& row : said.value(QLatin1String(erased_key)).toString().split(QLatin1Char(' ')))
        erased.insert(row.toLongLong());
}

bool is_about_an_attempt(const std::string& operation) {
    for (const char* group : {"attempt.", "score.", "comment.", "rating.", "error."}) {
        if (operation.rfind(group, 0) == 0) return true;
    }
    return false;
}

/// Takes the role out, and what whoever views the log may not read.
void show_payload(const std::string& payload, AuditEntry& entry) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(payload));
    if (!document.isObject()) {
        entry.payload = "unreadable";
        return;
    }
    QJsonObject members = document.object();
    entry.role = members.take(QLatin1String(role_key)).toString().toStdString();
    members.remove(QLatin1String(records_key));
    members.remove(QLatin1String(verifier_key));
    // Why an attempt became practice the program itself has found; it is nobody's opinion.
    if (is_about_an_attempt(entry.operation) && entry.operation != "attempt.practice") {
        for (const char* words : {"reason", "text", "state"}) {
            if (members.contains(QLatin1String(words)))
                members.insert(QLatin1String(words), QStringLiteral("withheld"));
        }
    }
    entry.payload = QJsonDocument(members).toJson(QJsonDocument::Compact).toStdString();
}

/// The newest row of this station's log; sequence 0 before the first.
struct LastRow {
    std::int64_t sequence = 0;
    Bytes hash = Bytes(hash_size, 0);
    std::string operation, object;
};

LastRow last_row(const Store& store) {
    Query last(store.connection(),
               "SELECT sequence, hash, operation, object_id FROM audit_entry WHERE station_id = ? ORDER BY "
               "sequence DESC LIMIT 1");
    last.bind(store.station_id());
    if (!last.next()) return {};
    return {last.integer(0), last.bytes(1), last.text(2), last.text(3)};
}

/// The key whose turn it is after this row: the one that a rotation announces, else the one that signed it.
const StationKey& key_after(const Store& store, const LastRow& last) {
    Bytes expected;
    if (last.operation == key_rotation) {
        expected = from_hex(last.object);
    } else {
        Query row(store.connection(),
                  "SELECT public_half FROM audit_signature WHERE station_id = ? AND sequence = ?");
        row.bind(store.station_id()).bind(last.sequence);
        if (row.next()) expected = row.bytes(0);
    }
    return store.key(last.sequence + 1, expected);
}

void sign_row(const Store& store, const LastRow& last, const Bytes& hash) {
    if (store.found_schema() < schema_with_signatures) return;
    const StationKey& key = key_after(store, last);
    const std::int64_t sequence = last.sequence + 1;
    Query(store.connection(), "INSERT OR IGNORE INTO station_key (station_id, public_half) VALUES (?, ?)")
        .bind(store.station_id())
        .bind(key.public_half())
        .run();
    Query(store.connection(),
          "INSERT INTO audit_signature (station_id, sequence, public_half, signature) VALUES (?, ?, ?, ?)")
        .bind(store.station_id())
        .bind(sequence)
        .bind(key.public_half())
        .bind(key.sign(hash))
        .run();
}

}  // namespace

bool signed_row_holds(const SignedRow& row) {
    return payload_digest(row.salt, row.payload) == row.digest &&
           row_hash(row.previous, row.sequence, row.time, row.station_id, row.actor_id, row.object_id,
                    row.operation, row.digest) == row.hash &&
           row_signature_holds(row.public_half, row.hash, row.signature);
}

const StationKey& Audit::next_key() const {
    return key_after(store_, last_row(store_));
}

void Audit::append(const Session& actor, const std::string& object_id, const std::string& operation,
                   const std::string& deed_json, const std::vector<RecordName>& records) const {
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    const std::string payload_json = stored_payload(connection, deed_json, actor.role(), records);
    const LastRow last = last_row(store_);
    const std::int64_t sequence = last.sequence + 1;
    const std::int64_t time = store_.now();
    const std::string actor_id = actor.is_station() ? store_.station_id() : actor.person_id();
    const Bytes salt = random_bytes(salt_size);
    const Bytes digest = payload_digest(salt, payload_json);
    const Bytes hash =
        row_hash(last.hash, sequence, time, store_.station_id(), actor_id, object_id, operation, digest);
    Query(connection,
          "INSERT INTO audit_entry (station_id, sequence, time, actor_id, object_id, operation, digest, "
          "previous_hash, hash) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(store_.station_id())
        .bind(sequence)
        .bind(time)
        .bind(actor_id)
        .bind(object_id)
        .bind(operation)
        .bind(digest)
        .bind(last.hash)
        .bind(hash)
        .run();
    sign_row(store_, last, hash);
    Query(connection, "INSERT INTO audit_payload (station_id, sequence, salt, payload) VALUES (?, ?, ?, ?)")
        .bind(store_.station_id())
        .bind(sequence)
        .bind(salt)
        .bind(payload_json)
        .run();
    transaction.commit();
}

void Audit::erase_payloads(const Session& actor, const std::vector<std::int64_t>& sequences,
                           const std::string& reason, const std::vector<RecordName>& records) const {
    Transaction transaction(store_.connection());
    std::string rows;
    for (const std::int64_t sequence : sequences) {
        Query(store_.connection(), "DELETE FROM audit_payload WHERE station_id = ? AND sequence = ?")
            .bind(store_.station_id())
            .bind(sequence)
            .run();
        rows += (rows.empty() ? "" : " ") + std::to_string(sequence);
    }
    append(actor, store_.station_id(), erasure, json_object({{erased_key, rows}, {"reason", reason}}),
           records);
    transaction.commit();
}

namespace {

struct StationHead {
    std::string station_id;
    Bytes hash, public_half;
};

std::vector<StationHead> heads_on_server(Connection& server) {
    Query rows(server, "SELECT station_id, hash, public_half FROM audit_heads() ORDER BY station_id");
    std::vector<StationHead> heads;
    while (rows.next()) heads.push_back({rows.text(0), rows.bytes(1), rows.bytes(2)});
    return heads;
}

}  // namespace

std::string server_audit_head(Connection& server) {
    const std::vector<StationHead> heads = heads_on_server(server);
    if (heads.size() == 1) return to_hex(heads.front().hash);
    std::string all;
    for (const StationHead& one : heads) all += one.station_id + " " + to_hex(one.hash) + "\n";
    return to_hex(heads.empty() ? Bytes(hash_size, 0) : blake2b(Bytes(all.begin(), all.end())));
}

std::string Audit::signing_key() const {
    if (store_.is_server()) {
        const std::vector<StationHead> heads = heads_on_server(store_.connection());
        const bool one = heads.size() == 1 && !heads.front().public_half.empty();
        return one ? key_fingerprint(heads.front().public_half) : std::string();
    }
    if (store_.found_schema() < schema_with_signatures) return {};
    Query last(store_.connection(),
               "SELECT s.public_half FROM audit_entry e LEFT JOIN audit_signature s ON s.station_id = "
               "e.station_id AND "
               "s.sequence = e.sequence WHERE e.station_id = ? ORDER BY e.sequence DESC LIMIT 1");
    last.bind(store_.station_id());
    return last.next() && !last.is_null(0) ? key_fingerprint(last.bytes(0)) : std::string();
}

std::string Audit::signer_of(const std::string& attempt_id) const {
    if (store_.is_server() || store_.found_schema() < schema_with_signatures) return {};
    Query row(store_.connection(),
              "SELECT s.public_half FROM audit_entry e LEFT JOIN audit_signature s ON s.station_id = "
              "e.station_id AND s.sequence = e.sequence WHERE (e.object_id = ? AND e.operation IN "
              "('attempt.finish', 'attempt.interrupted', 'attempt.import')) OR (e.operation = "
              "'attempt.reassign' AND e.object_id = (SELECT from_id FROM attempt_reassignment WHERE to_id = "
              "?)) ORDER BY e.time DESC, e.sequence DESC LIMIT 1");
    row.bind(attempt_id).bind(attempt_id);
    return row.next() && !row.is_null(0) ? key_fingerprint(row.bytes(0)) : std::string();
}

std::string Audit::head() const {
    if (store_.is_server()) return server_audit_head(store_.connection());
    Query last(store_.connection(),
               "SELECT hash FROM audit_entry WHERE station_id = ? ORDER BY sequence DESC LIMIT 1");
    last.bind(store_.station_id());
    return to_hex(last.next() ? last.bytes(0) : Bytes(hash_size, 0));
}

bool Audit::has_head(const std::string& hex) const {
    Query row(store_.connection(),
              "SELECT 1 FROM audit_entry WHERE substr(lower(hex(hash)), 1, ?) = lower(?)");
    row.bind(static_cast<std::int64_t>(hex.size())).bind(hex);
    return row.next();
}

std::int64_t Audit::count() const {
    Query rows(store_.connection(), "SELECT COUNT(*) FROM audit_entry");
    return rows.next() ? rows.integer(0) : 0;
}

std::vector<AuditEntry> Audit::entries(const Session& administrator, const AuditFilter& filter) const {
    store_.require(administrator, Operation::view_audit);
    QString sql =
        "SELECT e.sequence, e.time, e.station_id, e.actor_id, COALESCE(a.display_name, ''), "
        "e.object_id, e.operation, e.digest, e.previous_hash, e.hash, p.payload, "
        "COALESCE(w.id, ''), COALESCE(w.display_name, '') FROM audit_entry e "
        "LEFT JOIN audit_payload p ON p.station_id = e.station_id AND p.sequence = e.sequence "
        "LEFT JOIN person a ON a.id = e.actor_id "
        "LEFT JOIN score s ON s.id = e.object_id LEFT JOIN comment c ON c.id = e.object_id "
        "LEFT JOIN rating r ON r.id = e.object_id LEFT JOIN error_review v ON v.id = e.object_id "
        "LEFT JOIN attempt t ON t.id = COALESCE(s.attempt_id, c.attempt_id, r.attempt_id, v.attempt_id, "
        "e.object_id) "
        "LEFT JOIN person w ON w.id = COALESCE(t.person_id, e.object_id) WHERE e.station_id = ?";
    if (!filter.person_id.empty()) sql += " AND (e.actor_id = ? OR w.id = ?)";
    // One of them, or all of a group: "attempt" for "attempt.void".
    if (!filter.kind.empty())
        sql += " AND (e.operation = ? OR substr(e.operation, 1, length(?) + 1) = ? || '.')";
    sql += " AND e.time >= ?";
    if (filter.until > 0) sql += " AND e.time < ?";
    if (filter.before_sequence >= 0) sql += " AND e.sequence < ?";
    Query rows(store_.connection(), sql + " ORDER BY e.sequence DESC LIMIT ?");
    rows.bind(store_.station_id());
    if (!filter.person_id.empty()) rows.bind(filter.person_id).bind(filter.person_id);
    if (!filter.kind.empty()) rows.bind(filter.kind).bind(filter.kind).bind(filter.kind);
    rows.bind(filter.from);
    if (filter.until > 0) rows.bind(filter.until);
    if (filter.before_sequence >= 0) rows.bind(filter.before_sequence);
    rows.bind(filter.limit);
    std::vector<AuditEntry> entries;
    while (rows.next()) {
        AuditEntry entry;
        entry.sequence = rows.integer(0);
        entry.time = rows.integer(1);
        entry.station_id = rows.text(2);
        entry.actor_id = rows.text(3);
        entry.actor_name = entry.actor_id == entry.station_id ? "Station" : rows.text(4);
        entry.object_id = rows.text(5);
        entry.operation = rows.text(6);
        entry.digest = to_hex(rows.bytes(7));
        entry.previous_hash = to_hex(rows.bytes(8));
        entry.hash = to_hex(rows.bytes(9));
        entry.person_id = rows.text(11);
        entry.person_name = rows.text(12);
        if (rows.is_null(10)) {
            entry.payload = "payload erased";
        } else {
            show_payload(rows.text(10), entry);
        }
        entries.push_back(std::move(entry));
    }
    return entries;
}

std::vector<std::string> Audit::kinds(const Session& administrator) const {
    store_.require(administrator, Operation::view_audit);
    Query rows(store_.connection(),
               "SELECT DISTINCT operation FROM audit_entry WHERE station_id = ? ORDER BY operation");
    rows.bind(store_.station_id());
    std::vector<std::string> kinds;
    while (rows.next()) kinds.push_back(rows.text(0));
    return kinds;
}

std::vector<Sentence> Audit::verify() const {
    return verify_audit_chains(store_.connection());
}

std::vector<Sentence> verify_audit_chains(Connection& connection, AuditRows erased) {
    Query rows(connection,
               "SELECT e.station_id, e.sequence, e.time, e.actor_id, e.object_id, e.operation, e.digest, "
               "e.previous_hash, e.hash, "
               "p.salt, p.payload FROM audit_entry e "
               "LEFT JOIN audit_payload p ON p.station_id = e.station_id AND p.sequence = e.sequence "
               "ORDER BY e.station_id, e.sequence");
    std::vector<Sentence> problems;
    std::string station;
    Bytes previous(hash_size, 0);
    std::int64_t expected = 1;
    AuditRows missing;
    while (rows.next()) {
        if (rows.text(0) != station) {
            station = rows.text(0);
            previous.assign(hash_size, 0);
            expected = 1;
        }
        const std::int64_t sequence = rows.integer(1);
        const Sentence place = audit_place(connection, station, sequence);
        if (sequence != expected)
            problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "audit rows %1 to %2 are missing"), expected, sequence - 1});
        const Bytes digest = rows.bytes(6), stored_previous = rows.bytes(7), hash = rows.bytes(8);
        if (sequence == expected && stored_previous != previous)
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: not bound to the row before it"), place});
        if (row_hash(stored_previous, sequence, rows.integer(2), station, rows.text(3), rows.text(4),
                     rows.text(5), digest) != hash) {
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: changed after it was written"), place});
        }
        if (rows.is_null(9)) {
            missing[station].insert(sequence);
        } else if (payload_digest(rows.bytes(9), rows.text(10)) != digest) {
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: its payload was changed"), place});
        } else if (rows.text(5) == erasure) {
            add_erased(rows.text(10), erased[station]);
        }
        previous = hash;
        expected = sequence + 1;
    }
    for (const auto& [at, sequences] : missing) {
        for (const std::int64_t sequence : sequences) {
            if (erased[at].count(sequence) == 0)
                problems.push_back(
                    {QT_TRANSLATE_NOOP("errors",
                                       "%1: its payload is gone, and no erasure is in the audit log"),
                     audit_place(connection, at, sequence)});
        }
    }
    Query loose(connection,
                "SELECT p.sequence FROM audit_payload p WHERE NOT EXISTS (SELECT 1 FROM audit_entry e WHERE "
                "e.station_id = p.station_id AND e.sequence = p.sequence)");
    while (loose.next())
        problems.push_back(
            {QT_TRANSLATE_NOOP("errors", "audit row %1: only its payload is left"), loose.text(0)});
    return problems;
}

std::vector<Sentence> verify_audit_end(Connection& connection, const std::string& station, int most) {
    Query rows(connection,
               "SELECT e.sequence, e.time, e.actor_id, e.object_id, e.operation, e.digest, e.previous_hash, "
               "e.hash, s.public_half, s.signature FROM audit_entry e LEFT JOIN audit_signature s ON "
               "s.station_id = e.station_id AND s.sequence = e.sequence WHERE e.station_id = ? ORDER BY "
               "e.sequence DESC LIMIT ?");
    rows.bind(station).bind(most);
    std::vector<Sentence> problems;
    Bytes wanted;  // the hash that the row after this one names
    std::int64_t after = 0;
    while (rows.next()) {
        const std::int64_t sequence = rows.integer(0);
        const Sentence place = audit_place(connection, station, sequence);
        const Bytes hash = rows.bytes(7);
        if (after > 0 && sequence != after - 1)
            problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "audit rows %1 to %2 are missing"), sequence + 1, after - 1});
        else if (after > 0 && hash != wanted)
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: not bound to the row before it"),
                                audit_place(connection, station, after)});
        if (row_hash(rows.bytes(6), sequence, rows.integer(1), station, rows.text(2), rows.text(3),
                     rows.text(4), rows.bytes(5)) != hash)
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: changed after it was written"), place});
        else if (!rows.is_null(8) && !row_signature_holds(rows.bytes(8), hash, rows.bytes(9)))
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: its signature does not fit"), place});
        wanted = rows.bytes(6);
        after = sequence;
    }
    return problems;
}

}  // namespace fulcrum::database
