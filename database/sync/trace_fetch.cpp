// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/trace_fetch.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "database/records/attempt_query.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/schema/server_version.h"
#include "database/store/audit.h"
#include "database/store/station_key.h"
#include "database/sync/exchange.h"
#include "database/sync/server_link.h"

namespace fulcrum::database {
namespace {

constexpr int chunks_at_once = 64;
constexpr std::size_t checksum_bytes = 16;
constexpr const char* trace_guards[] = {"trace_chunk_of_running", "attempt_product_of_running"};

[[noreturn]] void refuse_trace(const std::string& attempt_id, const Sentence& why) {
    throw StoreError(
        StoreErrorKind::corrupt,
        {QT_TRANSLATE_NOOP("errors", "the trace of attempt %1 was not taken from the server: %2"), attempt_id,
         why},
        QT_TRANSLATE_NOOP("errors", "tell the server's administrator, who runs `fulcrum server check`"));
}

/// What the station that recorded the attempt has signed of its trace.
struct SignedDigest {
    std::string digest, key;
};

SignedDigest signed_digest(Connection& server, const std::string& attempt_id) {
    const QString name = QString::fromStdString(RecordName{RecordKind::trace, attempt_id}.text());
    Query rows(server,
               "SELECT station_id, sequence, time, actor_id, object_id, operation, digest, previous_hash, "
               "hash, salt, payload, public_half, signature FROM trace_evidence(?)");
    rows.bind(attempt_id);
    bool was_unsigned = false;
    while (rows.next()) {
        const QJsonObject said = QJsonDocument::fromJson(QByteArray::fromStdString(rows.text(10))).object();
        const QString digest = said.value(QLatin1String(records_key)).toObject().value(name).toString();
        if (digest.isEmpty()) continue;
        if (rows.is_null(11)) {
            was_unsigned = true;
            continue;
        }
        SignedRow row;
        row.station_id = rows.text(0);
        row.sequence = rows.integer(1);
        row.time = rows.integer(2);
        row.actor_id = rows.text(3);
        row.object_id = rows.text(4);
        row.operation = rows.text(5);
        row.digest = rows.bytes(6);
        row.previous = rows.bytes(7);
        row.hash = rows.bytes(8);
        row.salt = rows.bytes(9);
        row.payload = rows.text(10);
        row.public_half = rows.bytes(11);
        row.signature = rows.bytes(12);
        if (!signed_row_holds(row))
            refuse_trace(
                attempt_id,
                {QT_TRANSLATE_NOOP("errors", "the signature of audit row %1 of station %2 does not fit"),
                 row.sequence, row.station_id});
        return {digest.toStdString(), key_fingerprint(row.public_half)};
    }
    refuse_trace(attempt_id,
                 was_unsigned
                     ? Sentence(QT_TRANSLATE_NOOP("errors", "the station that recorded it has not signed it"))
                     : Sentence(QT_TRANSLATE_NOOP("errors", "no audit row there says what it is")));
}

using Row = std::vector<QVariant>;

struct Parts {
    std::vector<Row> chunks, products;
    std::int64_t bytes = 0;
};

/// The last two values are checksum and data.
void take_part(Query& rows, std::vector<Row>& to, std::int64_t& bytes, const std::string& attempt_id) {
    Row row = rows.row();
    const QByteArray data = row.back().toByteArray(), checksum = row[row.size() - 2].toByteArray();
    const Bytes sum = blake2b(data.constData(), static_cast<std::size_t>(data.size()), checksum_bytes);
    if (checksum != QByteArray(reinterpret_cast<const char*>(sum.data()), static_cast<int>(sum.size())))
        refuse_trace(attempt_id, QT_TRANSLATE_NOOP("errors", "a part of it does not match its checksum"));
    bytes += data.size();
    to.push_back(std::move(row));
}

Parts read_parts(Connection& server, const std::string& attempt_id, const SyncOptions& options) {
    Parts parts;
    std::int64_t total = 0, stream = -1, number = -1;
    {
        Query count(server, "SELECT COUNT(*) FROM trace_chunk WHERE attempt_id = ?");
        count.bind(attempt_id);
        if (count.next()) total = count.integer(0);
    }
    for (bool more = total > 0; more;) {
        Query rows(server,
                   "SELECT attempt_id, stream, number, first_tick, last_tick, records, checksum, data FROM "
                   "trace_chunk WHERE attempt_id = ? AND (stream, number) > (?, ?) ORDER BY stream, number "
                   "LIMIT ?");
        rows.bind(attempt_id).bind(stream).bind(number).bind(chunks_at_once);
        const std::size_t before = parts.chunks.size();
        while (rows.next()) {
            take_part(rows, parts.chunks, parts.bytes, attempt_id);
            stream = rows.integer(1);
            number = rows.integer(2);
        }
        more = parts.chunks.size() == before + chunks_at_once;
        const auto done = static_cast<std::int64_t>(parts.chunks.size());
        if (options.progress)
            options.progress(static_cast<double>(done) / static_cast<double>(std::max(total, done)),
                             "trace: " + std::to_string(done) + " of " + std::to_string(total));
    }
    Query products(server,
                   "SELECT attempt_id, kind, checksum, data FROM attempt_product WHERE attempt_id = ?");
    products.bind(attempt_id);
    while (products.next()) take_part(products, parts.products, parts.bytes, attempt_id);
    return parts;
}

void add_rows(Connection& station, const QString& sql, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        Query statement(station, sql);
        for (const QVariant& value : row) statement.bind(value);
        statement.run();
    }
}

/// In one transaction: an attempt that has ended takes no more of a trace, so the triggers that see to it are
/// set aside and come back, or nothing was done.
void store_parts(const Store& store, const Session& session, const std::string& attempt_id,
                 const Parts& parts, const SignedDigest& expected, const std::string& server_id) {
    Connection& station = store.connection();
    Transaction transaction(station);
    {
        Query there(station, "SELECT 1 FROM trace_chunk WHERE attempt_id = ? LIMIT 1");
        there.bind(attempt_id);
        if (there.next()) return;  // another program was first
    }
    std::vector<std::string> triggers;
    for (const char* name : trace_guards) {
        Query trigger(station, "SELECT sql FROM sqlite_master WHERE type = 'trigger' AND name = ?");
        trigger.bind(name);
        if (trigger.next()) triggers.push_back(trigger.text(0));
    }
    for (const char* name : trace_guards) station.execute(QString("DROP TRIGGER IF EXISTS %1").arg(name));
    add_rows(station,
             "INSERT INTO trace_chunk (attempt_id, stream, number, first_tick, last_tick, records, checksum, "
             "data) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
             parts.chunks);
    add_rows(station, "INSERT INTO attempt_product (attempt_id, kind, checksum, data) VALUES (?, ?, ?, ?)",
             parts.products);
    for (const std::string& trigger : triggers) station.execute(QString::fromStdString(trigger));
    const RecordName name{RecordKind::trace, attempt_id};
    if (RecordDigests(station).of(name) != expected.digest)
        refuse_trace(attempt_id,
                     QT_TRANSLATE_NOOP("errors", "it is not as the station that recorded it has signed it"));
    Audit(store).append(session, attempt_id, "sync.receive",
                        json_object({{"server", server_id},
                                     {"what", "trace"},
                                     {"count", std::to_string(parts.chunks.size())},
                                     {"key", expected.key}}),
                        {name});
    transaction.commit();
}

bool lacks_trace(const Store& store, const std::string& attempt_id) {
    Query row(store.connection(),
              "SELECT 1 FROM attempt a WHERE a.id = ? AND a.state <> 'running' AND a.events <> ? AND NOT " +
                  has_trace_here("a"));
    row.bind(attempt_id).bind(trace_not_kept);
    return row.next();
}

}  // namespace

bool can_fetch_trace(const Store& store, const Session& session, const std::string& attempt_id) {
    require_attempt(store, session, Operation::read_trace, attempt_id);
    return !store.is_server() && !store.is_demo() && lacks_trace(store, attempt_id) &&
           ServerLink::of(store.station_id()).has_value();
}

FetchedTrace fetch_trace(const Store& store, const Session& session, const ServerAddress& address,
                         const std::string& attempt_id, const SyncOptions& options) {
    require_attempt(store, session, Operation::read_trace, attempt_id);
    FetchedTrace result;
    if (!lacks_trace(store, attempt_id)) {
        require_trace_here(store, attempt_id);  // it may not have been kept
        return result;
    }
    const std::unique_ptr<Connection> server = connection_to(store, address);
    server->watch([&] {
        if (options.stop && options.stop()) throw SyncStopped();
    });
    try {
        const std::string server_id = require_server(*server);
        const Parts parts = read_parts(*server, attempt_id, options);
        if (parts.chunks.empty())
            throw StoreError(
                StoreErrorKind::not_found,
                {QT_TRANSLATE_NOOP("errors", "the server has no trace of attempt %1"), attempt_id},
                QT_TRANSLATE_NOOP("errors", "sync the station that recorded it, then try again"));
        const SignedDigest expected = signed_digest(*server, attempt_id);
        store_parts(store, session, attempt_id, parts, expected, server_id);
        result.chunks = static_cast<std::int64_t>(parts.chunks.size());
        result.bytes = parts.bytes;
        result.signed_by = expected.key;
    } catch (const SyncStopped&) {
        result.complete = false;
    }
    return result;
}

}  // namespace fulcrum::database
