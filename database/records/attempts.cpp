// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/attempts.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

#include "database/records/attempt_query.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "database/store/score_rows.h"

namespace fulcrum::database {
namespace {

[[noreturn]] void unknown_attempt(const std::string& id) {
    throw StoreError(StoreErrorKind::not_found, "no attempt " + id, "list the attempts and name one of them");
}

/// Who performed it; throws not_found. Tells nothing else, so it may be asked before access is checked.
std::string person_of(const Store& store, const std::string& attempt_id) {
    Query row(store.connection(), "SELECT person_id FROM attempt WHERE id = ?");
    row.bind(attempt_id);
    if (!row.next()) unknown_attempt(attempt_id);
    return row.text(0);
}

std::string require_attempt(const Store& store, const Session& session, Operation operation,
                            const std::string& attempt_id) {
    std::string person = person_of(store, attempt_id);
    store.require(session, operation, Subject::person(person));
    return person;
}

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
                     store.path() + ": " + stream_name(stream) + " chunk " + number + " of attempt " +
                         attempt_id + ": " + error.problem(),
                     error.hint());
}

StoreError missing_chunk() {
    return {StoreErrorKind::corrupt, "the chunk before it is missing", "restore the newest backup"};
}

/// What an attempt has of events when it has ended is written beside it: a record that lost its end is not
/// read as a shorter one.
void require_end(const Store& store, const std::string& attempt_id, std::size_t events) {
    Query row(store.connection(), "SELECT events FROM attempt WHERE id = ? AND state <> 'running'");
    row.bind(attempt_id);
    if (!row.next() || row.integer(0) == static_cast<std::int64_t>(events)) return;
    throw StoreError(StoreErrorKind::corrupt,
                     store.path() + ": the record of attempt " + attempt_id + " has " +
                         std::to_string(events) + " of its " + row.text(0) +
                         " events: a part of it is missing",
                     "restore the newest backup");
}

/// Inputs and samples are written in pairs: where one of the two is longer, the other lost its end.
void require_pairs(const Store& store, const std::string& attempt_id, const Trace& trace) {
    if (trace.samples.size() == trace.inputs.size()) return;
    throw StoreError(StoreErrorKind::corrupt,
                     store.path() + ": the record of attempt " + attempt_id + " has " +
                         std::to_string(trace.samples.size()) + " samples for " +
                         std::to_string(trace.inputs.size()) + " inputs: a part of it is missing",
                     "restore the newest backup");
}

Trace read_chunks(const Store& store, const std::string& attempt_id, bool events_only) {
    Connection& connection = store.connection();
    Query rows(connection, QString("SELECT stream, number, first_tick, last_tick, records, checksum, data "
                                   "FROM trace_chunk WHERE attempt_id = ? ") +
                               (events_only ? "AND stream = 3 " : "") +
                               "ORDER BY stream = 0, stream, number");
    rows.bind(attempt_id);
    Trace trace;
    if (!events_only) {
        Query sizes(connection,
                    "SELECT stream, SUM(records) FROM trace_chunk WHERE attempt_id = ? GROUP BY stream");
        sizes.bind(attempt_id);
        while (sizes.next()) {
            // A hint only: what a damaged row says must not decide how much memory is asked for.
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
    if (!events_only) require_pairs(store, attempt_id, trace);
    return trace;
}

void require_reason(const std::string& reason) {
    if (reason.find_first_not_of(" \t\n") == std::string::npos || reason.size() > 4000) {
        throw StoreError(StoreErrorKind::bad_value, "a reason is needed (1 to 4,000 characters)", "say why");
    }
}

void write_void(const Store& store, const Session& educator, const std::string& attempt_id,
                const std::string& reason) {
    Connection& connection = store.connection();
    Query row(connection,
              "SELECT state, EXISTS (SELECT 1 FROM attempt_void WHERE attempt_id = a.id) FROM attempt a "
              "WHERE id = ?");
    row.bind(attempt_id);
    if (!row.next()) unknown_attempt(attempt_id);
    if (row.text(0) == "running")
        throw StoreError(StoreErrorKind::conflict, "the attempt is still running", "wait for its end");
    if (row.flag(1))
        throw StoreError(StoreErrorKind::conflict, "the attempt is voided already", "nothing is left to do");
    Query(connection, "INSERT INTO attempt_void (attempt_id, person_id, time, reason) VALUES (?, ?, ?, ?)")
        .bind(attempt_id)
        .bind(educator.person_id())
        .bind(store.now())
        .bind(reason)
        .run();
}

}  // namespace

std::vector<AttemptSummary> Attempts::list(const Session& session, const AttemptFilter& filter) const {
    if (!filter.person_id.empty()) {
        store_.require(session, Operation::read_attempt, Subject::person(filter.person_id));
    } else {
        store_.require(session, Operation::read_attempt);
    }
    if (!filter.cohort_id.empty())
        store_.require(session, Operation::list_cohorts, Subject::cohort(filter.cohort_id));
    return query_attempts(store_, session, filter);
}

AttemptSummary Attempts::read(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    return query_attempt(store_, attempt_id);
}

std::vector<AttemptSummary> Attempts::interrupted_without_score(const Session& session) const {
    store_.require(session, Operation::score_interrupted);
    AttemptFilter filter;
    filter.state = "interrupted";
    filter.limit = -1;
    std::vector<AttemptSummary> attempts = query_attempts(store_, session, filter);
    Query scored(store_.connection(),
                 "SELECT attempt_id FROM score WHERE in_force = 1 AND attempt_id IN "
                 "(SELECT id FROM attempt WHERE state = 'interrupted')");
    std::set<std::string> done;
    while (scored.next()) done.insert(scored.text(0));
    attempts.erase(
        std::remove_if(attempts.begin(), attempts.end(),
                       [&](const AttemptSummary& attempt) { return done.count(attempt.meta.id) > 0; }),
        attempts.end());
    std::reverse(attempts.begin(), attempts.end());
    return attempts;
}

std::vector<ScoreRow> Attempts::scores(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    std::vector<std::string> ids;
    {
        Query rows(store_.connection(),
                   "SELECT id FROM score WHERE attempt_id = ? ORDER BY in_force DESC, computed, id");
        rows.bind(attempt_id);
        while (rows.next()) ids.push_back(rows.text(0));
    }
    std::vector<ScoreRow> scores;
    for (const std::string& id : ids) scores.push_back(read_score(store_.connection(), id));
    return scores;
}

std::optional<ScoreRow> Attempts::score(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    std::string id;
    {
        Query row(store_.connection(), "SELECT id FROM score WHERE attempt_id = ? AND in_force = 1");
        row.bind(attempt_id);
        if (!row.next()) return std::nullopt;
        id = row.text(0);
    }
    return read_score(store_.connection(), id);
}

Trace Attempts::read_trace(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    return read_chunks(store_, attempt_id, false);
}

void Attempts::read_overview(const Session& session, const std::string& attempt_id,
                             const std::function<void(std::size_t)>& prepare,
                             const std::function<void(std::size_t, const TraceOverview&)>& visit) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
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

std::vector<Event> Attempts::read_events(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    return read_chunks(store_, attempt_id, true).events;
}

std::string Attempts::scene_text(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_attempt, attempt_id);
    Query row(
        store_.connection(),
        "SELECT a.scene_digest, s.text FROM attempt a LEFT JOIN scene_text s ON s.digest = a.scene_digest "
        "WHERE a.id = ?");
    row.bind(attempt_id);
    if (!row.next() || row.text(0).empty()) return {};
    if (row.is_null(1) || text_digest(row.text(1)) != row.text(0))
        throw StoreError(StoreErrorKind::corrupt,
                         store_.path() + ": the scene of attempt " + attempt_id + " is damaged",
                         "restore the newest backup");
    return row.text(1);
}

std::vector<ProductBlob> Attempts::products(const Session& session, const std::string& attempt_id) const {
    require_attempt(store_, session, Operation::read_trace, attempt_id);
    Query rows(store_.connection(),
               "SELECT kind, checksum, data FROM attempt_product WHERE attempt_id = ? ORDER BY kind");
    rows.bind(attempt_id);
    std::vector<ProductBlob> products;
    while (rows.next()) {
        ProductBlob product{rows.text(0), rows.bytes(2)};
        if (blake2b(product.data, 16) != rows.bytes(1)) {
            throw StoreError(
                StoreErrorKind::corrupt,
                store_.path() + ": product " + product.kind + " of attempt " + attempt_id + " is damaged",
                "restore the newest backup");
        }
        products.push_back(std::move(product));
    }
    return products;
}

std::string Attempts::add_score(const Session& session, const std::string& attempt_id,
                                const ScoreRow& score) const {
    Transaction transaction(store_.connection());
    const std::string person = person_of(store_, attempt_id);
    Query row(store_.connection(),
              "SELECT a.state, EXISTS (SELECT 1 FROM score s WHERE s.attempt_id = a.id) FROM attempt a WHERE "
              "a.id = ?");
    row.bind(attempt_id);
    if (!row.next()) unknown_attempt(attempt_id);
    const bool first_of_interrupted = row.text(0) == "interrupted" && !row.flag(1);
    store_.require(session, first_of_interrupted ? Operation::score_interrupted : Operation::recompute_score,
                   Subject::person(person));
    if (row.text(0) == "running")
        throw StoreError(StoreErrorKind::conflict, "the attempt is still running", "wait for its end");
    std::string id = write_score(store_, session, attempt_id, score);
    transaction.commit();
    return id;
}

void Attempts::void_attempt(const Session& educator, const std::string& attempt_id,
                            const std::string& reason) const {
    require_attempt(store_, educator, Operation::void_attempt, attempt_id);
    require_reason(reason);
    Transaction transaction(store_.connection());
    write_void(store_, educator, attempt_id, reason);
    Audit(store_).append(educator, attempt_id, "attempt.void", json_object({{"reason", reason}}));
    transaction.commit();
}

std::string Attempts::reassign(const Session& educator, const std::string& attempt_id,
                               const std::string& person_id, const std::string& reason) const {
    const std::string from = require_attempt(store_, educator, Operation::reassign_attempt, attempt_id);
    store_.require(educator, Operation::reassign_attempt, Subject::person(person_id));
    require_reason(reason);
    if (from == person_id) {
        throw StoreError(StoreErrorKind::conflict, "the attempt is that person's already",
                         "name the person who performed it");
    }
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    write_void(store_, educator, attempt_id, reason);
    std::string copy = random_uuid();
    Query(connection,
          "INSERT INTO attempt SELECT ?, ?, station_id, task_id, task_version, mode, device_class, device, "
          "operator_name, variant, "
          "seed, fidelity, scene, scene_digest, curriculum, limits, program_version, cpu_features, started, "
          "utc_offset_min, state, "
          "duration_s, wall_s, missed_ticks, lost_samples, events, state_hash FROM attempt WHERE id = ?")
        .bind(copy)
        .bind(person_id)
        .bind(attempt_id)
        .run();
    // The trace is copied, not shared: erasing one person must leave the other's attempt whole.
    Query(connection,
          "INSERT INTO trace_chunk SELECT ?, stream, number, first_tick, last_tick, records, checksum, data "
          "FROM trace_chunk "
          "WHERE attempt_id = ?")
        .bind(copy)
        .bind(attempt_id)
        .run();
    Query(connection,
          "INSERT INTO attempt_product SELECT ?, kind, checksum, data FROM attempt_product WHERE attempt_id "
          "= ?")
        .bind(copy)
        .bind(attempt_id)
        .run();
    std::vector<std::string> ids;
    {
        Query rows(connection,
                   "SELECT id FROM score WHERE attempt_id = ? ORDER BY in_force DESC, computed, id");
        rows.bind(attempt_id);
        while (rows.next()) ids.push_back(rows.text(0));
    }
    for (const std::string& id : ids) write_score(store_, educator, copy, read_score(connection, id));
    Query(connection, "INSERT INTO attempt_reassignment (from_id, to_id) VALUES (?, ?)")
        .bind(attempt_id)
        .bind(copy)
        .run();
    Audit(store_).append(
        educator, attempt_id, "attempt.reassign",
        json_object({{"from", from}, {"to", person_id}, {"copy", copy}, {"reason", reason}}));
    transaction.commit();
    return copy;
}

void Attempts::request_correction(const Session& trainee, const std::string& attempt_id,
                                  const std::string& text) const {
    require_attempt(store_, trainee, Operation::request_correction, attempt_id);
    require_reason(text);
    Transaction transaction(store_.connection());
    Query(store_.connection(),
          "INSERT INTO correction_request (id, attempt_id, person_id, text, asked) VALUES (?, ?, ?, ?, ?)")
        .bind(random_uuid())
        .bind(attempt_id)
        .bind(trainee.person_id())
        .bind(text)
        .bind(store_.now())
        .run();
    Audit(store_).append(trainee, attempt_id, "attempt.request_correction", json_object({{"text", text}}));
    transaction.commit();
}

std::vector<CorrectionRequest> Attempts::correction_requests(const Session& session) const {
    store_.require(session, Operation::read_requests);
    Query rows(
        store_.connection(),
        "SELECT r.id, r.attempt_id, r.person_id, p.display_name, r.text, r.asked, "
        "EXISTS (SELECT 1 FROM attempt_void v WHERE v.attempt_id = r.attempt_id) FROM correction_request r "
        "JOIN person p ON p.id = r.person_id WHERE " +
            visible_people(session, Operation::read_requests, "r.person_id") +
            " ORDER BY r.asked DESC, r.id");
    bind_visible_people(rows, session, Operation::read_requests);
    std::vector<CorrectionRequest> requests;
    while (rows.next()) {
        requests.push_back({rows.text(0), rows.text(1), rows.text(2), rows.text(3), rows.text(4),
                            rows.integer(5), rows.flag(6)});
    }
    return requests;
}

}  // namespace fulcrum::database
