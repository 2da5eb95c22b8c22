// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt's trace, decoded and checked.
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "database/records/attempt_query.h"
#include "database/records/attempts.h"
#include "database/rows/crypto.h"
#include "database/rows/packed_bytes.h"
#include "database/rows/packed_ticks.h"

namespace fulcrum::database {
namespace {

TraceChunk chunk_of_row(Query& rows) {
    TraceChunk chunk;
    chunk.stream = static_cast<TraceStream>(rows.integer(0));
    chunk.first_tick = static_cast<std::uint32_t>(rows.integer(2));
    chunk.last_tick = static_cast<std::uint32_t>(rows.integer(3));
    chunk.count = static_cast<std::uint32_t>(rows.integer(4));
    chunk.checksum = rows.bytes(5);
    chunk.data = rows.bytes(6);
    return chunk;
}

[[noreturn]] void throw_damaged(const Store& store, const std::string& attempt_id, TraceStream stream,
                                const std::string& number, const StoreError& error) {
    throw StoreError(StoreErrorKind::corrupt,
                     {QT_TRANSLATE_NOOP("errors", "%1: %2 chunk %3 of attempt %4: %5"), store.path(),
                      stream_name(stream), number, attempt_id, error.problem_sentence()},
                     error.hint_sentence());
}

StoreError missing_chunk() {
    return {StoreErrorKind::corrupt, QT_TRANSLATE_NOOP("errors", "the part before it is missing"),
            QT_TRANSLATE_NOOP("errors", "restore the newest backup")};
}

/// The number of events is stored when an attempt ends: a record that lost its end is not read as a shorter
/// one.
void require_end(const Store& store, const std::string& attempt_id, std::size_t events) {
    Query row(store.connection(), "SELECT events FROM attempt WHERE id = ? AND state <> 'running'");
    row.bind(attempt_id);
    if (!row.next() || row.integer(0) == static_cast<std::int64_t>(events)) return;
    throw StoreError(
        StoreErrorKind::corrupt,
        {QT_TRANSLATE_NOOP("errors",
                           "%1: the record of attempt %2 has %3 of its %4 events: a part of it is missing"),
         store.path(), attempt_id, events, row.text(0)},
        QT_TRANSLATE_NOOP("errors", "restore the newest backup"));
}

/// Inputs and samples are written in pairs: if one is longer, the other lost its end.
void require_pairs(const Store& store, const std::string& attempt_id, const Trace& trace) {
    if (trace.samples.size() == trace.inputs.size()) return;
    throw StoreError(
        StoreErrorKind::corrupt,
        {QT_TRANSLATE_NOOP(
             "errors", "%1: the record of attempt %2 has %3 samples for %4 inputs: a part of it is missing"),
         store.path(), attempt_id, trace.samples.size(), trace.inputs.size()},
        QT_TRANSLATE_NOOP("errors", "restore the newest backup"));
}

enum class TracePart { all, steps_and_events, events };

Trace read_chunks(const Store& store, const std::string& attempt_id, TracePart part) {
    Connection& connection = store.connection();
    Query rows(connection, QString("SELECT stream, number, first_tick, last_tick, records, checksum, data "
                                   "FROM trace_chunk WHERE attempt_id = ? ") +
                               (part == TracePart::events             ? "AND stream = 3 "
                                : part == TracePart::steps_and_events ? "AND stream IN (2, 3) "
                                                                      : "") +
                               "ORDER BY stream = 0, stream, number");
    rows.bind(attempt_id);
    Trace trace;
    if (part == TracePart::all) {
        Query sizes(connection,
                    "SELECT stream, SUM(records) FROM trace_chunk WHERE attempt_id = ? GROUP BY stream");
        sizes.bind(attempt_id);
        while (sizes.next()) {
            // A hint only: a damaged row must not decide how much memory is allocated.
            const auto records =
                static_cast<std::size_t>(std::clamp<std::int64_t>(sizes.integer(1), 0, 4000000));
            if (sizes.integer(0) == 0) trace.samples.reserve(records);
            if (sizes.integer(0) == 1) trace.inputs.reserve(records);
        }
    }
    TraceCodec codec;
    std::int64_t stream = -1, expected = 0;
    while (rows.next()) {
        if (rows.integer(0) != stream) {
            stream = rows.integer(0);
            expected = 0;
        }
        try {
            if (rows.integer(1) != expected++) throw missing_chunk();
            const TraceChunk chunk = chunk_of_row(rows);
            switch (chunk.stream) {
                case TraceStream::samples:
                    codec.decode(chunk, trace.samples, &trace.inputs);  // inputs come first
                    break;
                case TraceStream::inputs:
                    codec.decode(chunk, trace.inputs);
                    break;
                case TraceStream::steps:
                    codec.decode(chunk, trace.steps);
                    break;
                case TraceStream::events:
                    codec.decode(chunk, trace.events);
                    break;
            }
        } catch (const StoreError& error) {
            throw_damaged(store, attempt_id, static_cast<TraceStream>(stream), rows.text(1), error);
        }
    }
    require_end(store, attempt_id, trace.events.size());
    if (part == TracePart::all) require_pairs(store, attempt_id, trace);
    return trace;
}

}  // namespace

QString has_trace_here(const QString& attempt) {
    // Copies for another person that an older program made name the station of the original, but their trace
    // is where the copy was made. An attempt whose beginning this log lacks came back from the server to an
    // older copy of the store, without its trace.
    return QString(
               "(%1.events <> %2 AND ((%1.station_id = COALESCE((SELECT value FROM setting WHERE key = "
               "'this_station'), '') AND NOT EXISTS (SELECT 1 FROM attempt_reassignment moved WHERE "
               "moved.to_id = %1.id) AND EXISTS (SELECT 1 FROM audit_entry begun WHERE begun.object_id = "
               "%1.id AND begun.operation = 'attempt.begin')) OR EXISTS (SELECT 1 FROM trace_chunk here "
               "WHERE here.attempt_id = %1.id)))")
        .arg(attempt)
        .arg(trace_not_kept);
}

void require_trace_here(const Store& store, const std::string& attempt_id) {
    Query row(
        store.connection(),
        "SELECT s.name, a.events FROM attempt a JOIN station s ON s.id = a.station_id WHERE a.id = ? AND "
        "NOT " +
            has_trace_here("a"));
    row.bind(attempt_id);
    if (!row.next()) return;
    if (row.integer(1) == trace_not_kept)
        throw StoreError(
            StoreErrorKind::not_found,
            {QT_TRANSLATE_NOOP(
                 "errors", "the trace of attempt %1 was not kept: its result and scores alone are stored"),
             attempt_id},
            QT_TRANSLATE_NOOP("errors", "choose an attempt whose trace was kept"));
    throw StoreError(
        StoreErrorKind::not_found,
        {QT_TRANSLATE_NOOP("errors",
                           "the trace of attempt %1 is not in this store: it was recorded at the station %2"),
         attempt_id, row.text(0)},
        {QT_TRANSLATE_NOOP("errors", "open it there, or fetch it with `fulcrum sync --trace %1`"),
         attempt_id});
}

Trace stored_trace(const Store& store, const std::string& attempt_id) {
    require_trace_here(store, attempt_id);
    return read_chunks(store, attempt_id, TracePart::all);
}

Trace Attempts::read_trace(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    return stored_trace(store_, attempt_id);
}

Trace Attempts::read_packed_trace(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    require_trace_here(store_, attempt_id);
    const auto ticks = std::make_shared<PackedTicks>();
    {
        Query rows(store_.connection(),
                   "SELECT stream, number, first_tick, last_tick, records, checksum, data FROM trace_chunk "
                   "WHERE attempt_id = ? AND stream IN (0, 1) ORDER BY number, stream DESC");
        rows.bind(attempt_id);
        // What is wrong with a record that is not in pairs, the other function finds and says.
        for (std::int64_t number = 0; rows.next(); ++number) {
            bool is_pair = rows.integer(0) == 1 && rows.integer(1) == number;
            try {
                TraceChunk inputs = chunk_of_row(rows);
                is_pair = is_pair && rows.next() && rows.integer(0) == 0 && rows.integer(1) == number &&
                          ticks->add(std::move(inputs), chunk_of_row(rows));
            } catch (const StoreError&) {
                is_pair = false;
            }
            if (!is_pair) return read_chunks(store_, attempt_id, TracePart::all);
        }
    }
    Trace trace = read_chunks(store_, attempt_id, TracePart::steps_and_events);
    trace.ticks = ticks;
    return trace;
}

void Attempts::read_overview(const Session& session, const std::string& attempt_id,
                             const std::function<void(std::size_t)>& prepare,
                             const std::function<void(std::size_t, const TraceOverview&)>& visit) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    require_trace_here(store_, attempt_id);
    std::vector<TraceChunk> samples, inputs;
    {
        Query rows(store_.connection(),
                   "SELECT stream, number, first_tick, last_tick, records, checksum, data FROM trace_chunk "
                   "WHERE attempt_id = ? AND stream IN (0, 1) ORDER BY stream, number");
        rows.bind(attempt_id);
        while (rows.next()) {
            std::vector<TraceChunk>& chunks = rows.integer(0) == 0 ? samples : inputs;
            if (rows.integer(1) != static_cast<std::int64_t>(chunks.size()))
                throw_damaged(store_, attempt_id,
                              rows.integer(0) == 0 ? TraceStream::samples : TraceStream::inputs, rows.text(1),
                              missing_chunk());
            chunks.push_back(chunk_of_row(rows));
        }
    }
    if (samples.size() != inputs.size()) {
        const bool of_samples = samples.size() < inputs.size();
        throw_damaged(store_, attempt_id, of_samples ? TraceStream::samples : TraceStream::inputs,
                      std::to_string(std::min(samples.size(), inputs.size())),
                      {StoreErrorKind::corrupt, "it is missing", "restore the newest backup"});
    }
    prepare(samples.size());
    std::atomic<std::size_t> next{0};
    std::exception_ptr trouble;
    std::mutex trouble_lock;
    std::size_t trouble_at = 0;
    const auto work = [&] {
        TraceCodec codec;
        TraceOverview overview;
        for (std::size_t i = next++; i < samples.size(); i = next++) {
            try {
                // Written together, the two streams have the same chunks.
                codec.decode_overview(samples[i], &inputs[i], overview);
                visit(i, overview);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(trouble_lock);
                if (!trouble) trouble_at = i;
                if (!trouble) trouble = std::current_exception();
                next = samples.size();
            }
        }
    };
    std::vector<std::thread> threads;
    const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
    for (std::size_t i = 1; i < std::min(cores, samples.size()); ++i) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    try {
        if (trouble) std::rethrow_exception(trouble);
    } catch (const StoreError& error) {
        throw_damaged(store_, attempt_id, TraceStream::samples, std::to_string(trouble_at), error);
    }
}

std::vector<std::uint8_t> Attempts::start_state(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    require_trace_here(store_, attempt_id);
    Query row(store_.connection(), "SELECT checksum, state FROM attempt_origin WHERE attempt_id = ?");
    row.bind(attempt_id);
    if (!row.next()) return {};
    const std::vector<std::uint8_t> packed = row.bytes(1);
    if (blake2b(packed, 16) != row.bytes(0)) {
        throw StoreError(
            StoreErrorKind::corrupt,
            {QT_TRANSLATE_NOOP("errors",
                               "%1: the state that attempt %2 began with does not match its checksum"),
             store_.path(), attempt_id},
            QT_TRANSLATE_NOOP("errors", "restore the newest backup"));
    }
    return unpack_bytes(packed);
}

std::string Attempts::record_digest(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    require_trace_here(store_, attempt_id);
    std::string all;
    const auto add = [&](const char* statement, int columns) {
        Query rows(store_.connection(), statement);
        rows.bind(attempt_id);
        while (rows.next()) {
            for (int i = 0; i < columns - 1; ++i) all += rows.text(i) + ' ';
            all += to_hex(rows.bytes(columns - 1)) + '\n';
        }
        all += '\n';
    };
    add("SELECT stream, number, records, checksum FROM trace_chunk WHERE attempt_id = ? ORDER BY stream, "
        "number",
        4);
    add("SELECT tick, build, checksum FROM attempt_origin WHERE attempt_id = ?", 3);
    Query row(
        store_.connection(),
        "SELECT task_id, task_version, variant, seed, fidelity, scene, scene_digest, events, state_hash "
        "FROM attempt WHERE id = ?");
    row.bind(attempt_id);
    if (row.next())
        for (int i = 0; i < 9; ++i) all += row.text(i) + '\n';
    return text_digest(all);
}

std::vector<Event> Attempts::read_events(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    require_trace_here(store_, attempt_id);
    return read_chunks(store_, attempt_id, TracePart::events).events;
}

}  // namespace fulcrum::database
