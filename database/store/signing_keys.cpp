// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/signing_keys.h"

#include <map>

#include "database/rows/connection.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "database/store/station_key.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t public_half_size = 32;

/// The key with which this machine signs: the prepared one where the log has it already, and the program that
/// rotated it was cut off before it took its place.
std::optional<StationKey> own_key(Connection& connection, const std::string& station) {
    if (station.empty()) return std::nullopt;
    std::optional<StationKey> next = StationKey::prepared(station);
    if (!next) return StationKey::existing(station);
    Query announced(connection,
                    "SELECT 1 FROM audit_entry WHERE station_id = ? AND operation = ? AND object_id = ?");
    announced.bind(station).bind(key_rotation).bind(to_hex(next->public_half()));
    return announced.next() ? std::move(next) : StationKey::existing(station);
}

/// Whose turn it is to sign, of one station, row after row.
class Turns {
  public:
    explicit Turns(SignatureCheck& check) : check_(check) {}

    /// Of a row whose signature fits.
    void take(const Sentence& place, std::int64_t row, const std::string& operation,
              const std::string& object, const Bytes& key) {
        if (!announced_.empty() && key != announced_) {
            add(QT_TRANSLATE_NOOP("errors", "%1: signed by the key %2, but the key %3 was announced"), place,
                key, key_fingerprint(announced_));
        } else if (present_.empty() || key == announced_) {
            present_ = key;
        } else if (key != present_) {
            change(place, row, key);
        }
        announced_.clear();
        if (operation == key_rotation && key == present_) end_present(place, row, object);
    }

  private:
    void add(const char* what, const Sentence& place, const Bytes& key, const Sentence& other) {
        check_.problems.push_back({what, place, key_fingerprint(key), other});
    }
    void change(const Sentence& place, std::int64_t row, const Bytes& key) {
        const auto ended = ended_.find(key);
        if (ended != ended_.end())
            return add(QT_TRANSLATE_NOOP("errors", "%1: signed by the key %2, which ended with row %3"),
                       place, key, std::to_string(ended->second));
        check_.notes.push_back(
            {QT_TRANSLATE_NOOP("errors",
                               "%1: from here on the key %2 signs, which the key before, %3, "
                               "did not announce (its file was lost, or somebody else wrote "
                               "this)"),
             place, key_fingerprint(key), key_fingerprint(present_)});
        ended_[present_] = row - 1;
        present_ = key;
    }
    void end_present(const Sentence& place, std::int64_t row, const std::string& object) {
        announced_ = from_hex(object);
        if (announced_.size() != public_half_size || announced_ == present_ ||
            ended_.count(announced_) != 0) {
            check_.problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "%1: does not announce a new key"), place});
            announced_.clear();
            return;
        }
        ended_[present_] = row;
        present_ = announced_;
    }
    SignatureCheck& check_;
    Bytes present_, announced_;
    std::map<Bytes, std::int64_t> ended_;  ///< and with which row
};

}  // namespace

SignatureCheck verify_audit_signatures(Connection& connection, const std::string& own_station) {
    const std::optional<StationKey> own = own_key(connection, own_station);
    Query rows(
        connection,
        "SELECT e.station_id, e.sequence, e.hash, s.public_half, s.signature, e.operation, e.object_id "
        "FROM audit_entry e LEFT JOIN audit_signature s ON s.station_id = e.station_id AND s.sequence = "
        "e.sequence ORDER BY e.station_id, e.sequence");
    SignatureCheck check;
    std::string station;
    std::optional<Turns> turns;  // the rows before the first signature are from before there were keys
    while (rows.next()) {
        if (rows.text(0) != station) turns.reset();
        station = rows.text(0);
        const std::int64_t sequence = rows.integer(1);
        const Sentence place = audit_place(connection, station, sequence);
        const bool is_ours = own && station == own_station && sequence >= own->first_row();
        if (rows.is_null(3)) {
            if (turns || is_ours)
                check.problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: not signed"), place});
            continue;
        }
        if (!turns) turns.emplace(check);
        ++check.count;
        const Bytes key = rows.bytes(3);
        if (!row_signature_holds(key, rows.bytes(2), rows.bytes(4))) {
            check.problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: its signature does not fit"), place});
            continue;
        }
        if (is_ours && key != own->public_half())
            check.problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "%1: signed by the key %2, not by this station's, %3"), place,
                 key_fingerprint(key), key_fingerprint(own->public_half())});
        turns->take(place, sequence, rows.text(5), rows.text(6), key);
    }
    return check;
}

std::vector<SigningKey> signing_keys(Connection& connection, const std::string& station_id) {
    Query rows(
        connection,
        "SELECT k.public_half, k.first, k.last, f.time, l.time, b.operation, b.object_id FROM (SELECT "
        "public_half, MIN(sequence) AS first, MAX(sequence) AS last FROM audit_signature WHERE station_id "
        "= ? GROUP BY public_half) k JOIN audit_entry f ON f.station_id = ? AND f.sequence = k.first JOIN "
        "audit_entry l ON l.station_id = ? AND l.sequence = k.last LEFT JOIN audit_entry b ON "
        "b.station_id = ? AND b.sequence = k.first - 1 ORDER BY k.first");
    for (int i = 0; i < 4; ++i) rows.bind(station_id);
    std::vector<SigningKey> keys;
    while (rows.next()) {
        SigningKey key;
        key.public_half = rows.bytes(0);
        key.fingerprint = key_fingerprint(key.public_half);
        key.first_row = rows.integer(1);
        key.last_row = rows.integer(2);
        key.from = rows.integer(3);
        key.until = rows.integer(4);
        key.announced = rows.text(5) == key_rotation && rows.text(6) == to_hex(key.public_half) &&
                        !keys.empty() && keys.back().last_row == key.first_row - 1;
        keys.push_back(std::move(key));
    }
    return keys;
}

bool leads_to_newest(const std::vector<SigningKey>& keys, const std::string& fingerprint) {
    for (const SigningKey& key : keys)
        if (key.last_row > keys.back().last_row) return false;  // a key that had ended signed the newest row
    for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
        if (key->fingerprint.compare(0, fingerprint.size(), fingerprint) == 0) return true;
        if (!key->announced) return false;
    }
    return false;
}

SigningKey rotate_station_key(const Store& store, const Session& administrator, const std::string& reason) {
    store.require(administrator, Operation::rotate_key);
    if (reason.find_first_not_of(" \t\n") == std::string::npos)
        throw StoreError(StoreErrorKind::bad_value, QT_TRANSLATE_NOOP("errors", "a new key needs a reason"),
                         QT_TRANSLATE_NOOP("errors", "say why: planned, or what may have been copied"));
    Connection& connection = store.connection();
    const std::string& station = store.station_id();
    {
        // Where another program rotates at this moment, it is first, and its key announces this one.
        Transaction transaction(connection);
        const Audit audit(store);
        const Bytes present = audit.next_key().public_half();
        Query last(connection, "SELECT COALESCE(MAX(sequence), 0) FROM audit_entry WHERE station_id = ?");
        last.bind(station);
        const std::int64_t first_row = last.next() ? last.integer(0) + 2 : 2;
        const StationKey next = StationKey::prepare(station, first_row, present);
        const std::string object = to_hex(next.public_half()), name = key_fingerprint(next.public_half());
        audit.append(administrator, object, key_rotation,
                     json_object({{"new", name}, {"old", key_fingerprint(present)}, {"reason", reason}}));
        store.use_key(next);
        audit.append(administrator, object, key_beginning,
                     json_object({{"after", key_fingerprint(present)}, {"key", name}}));
        transaction.commit();
    }
    if (!connection.in_transaction()) StationKey::adopt_prepared(station);
    return signing_keys(connection, station).back();
}

}  // namespace fulcrum::database
