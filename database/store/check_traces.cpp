// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <future>
#include <thread>

#include "database/rows/attempt_records.h"
#include "database/rows/crypto.h"
#include "database/rows/trace_codec.h"
#include "database/store/store_check.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t stream_count = 4;

struct StoredChunk {
    std::int64_t number = 0;
    TraceChunk chunk;
};

/// What the store holds of one attempt.
struct StoredTrace {
    std::string attempt_id;
    std::vector<StoredChunk> streams[stream_count];
    std::vector<Sentence> problems;
};

/// The number fits; so does the time, but for events: these are stored as they were found, and the first
/// movement is found when it has gone some way and carries the tick of its beginning.
void check_order(const StoredTrace& trace, std::size_t stream, const Sentence& place,
                 std::vector<Sentence>& problems) {
    const auto& chunks = trace.streams[stream];
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        const auto number = std::to_string(chunks[i].number);
        const std::int64_t expected = i == 0 ? 0 : chunks[i - 1].number + 1;
        if (chunks[i].number != expected)
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: chunk %2 is missing"), place, expected});
        if (static_cast<TraceStream>(stream) == TraceStream::events) continue;
        const bool rises = static_cast<TraceStream>(stream) == TraceStream::samples ||
                           static_cast<TraceStream>(stream) == TraceStream::inputs;
        const TraceChunk& chunk = chunks[i].chunk;
        const bool early = i > 0 && (rises ? chunk.first_tick <= chunks[i - 1].chunk.last_tick
                                           : chunk.first_tick < chunks[i - 1].chunk.first_tick);
        if (chunk.first_tick > chunk.last_tick || early)
            problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: chunk %2 is out of order"), place, number});
    }
}

/// Decodes chunk by chunk; of the inputs only those that a chunk of samples needs are kept.
class TraceReader {
  public:
    void read(StoredTrace& trace) {
        inputs_.clear();
        next_input_ = 0;
        for (std::size_t stream = 0; stream < stream_count; ++stream) {
            const Sentence place(QT_TRANSLATE_NOOP("errors", "attempt %1, stream %2"), trace.attempt_id,
                                 stream);
            check_order(trace, stream, place, trace.problems);
            for (const StoredChunk& stored : trace.streams[stream]) {
                try {
                    decode(trace, stored.chunk);
                } catch (const StoreError& error) {
                    trace.problems.push_back({QT_TRANSLATE_NOOP("errors", "%1: chunk %2 is damaged (%3)"),
                                              place, stored.number, error.problem_sentence()});
                }
            }
        }
    }

  private:
    void decode(const StoredTrace& trace, const TraceChunk& chunk) {
        switch (chunk.stream) {
            case TraceStream::samples:
                samples_.clear();
                gather_inputs(trace, chunk);
                codec_.decode(chunk, samples_, &inputs_);
                return;
            case TraceStream::inputs:
                spare_.clear();
                codec_.decode(chunk, spare_);
                return;
            case TraceStream::steps:
                steps_.clear();
                codec_.decode(chunk, steps_);
                return;
            case TraceStream::events:
                events_.clear();
                codec_.decode(chunk, events_);
                return;
        }
    }
    void gather_inputs(const StoredTrace& trace, const TraceChunk& samples) {
        const auto& chunks = trace.streams[static_cast<std::size_t>(TraceStream::inputs)];
        const auto needed = std::find_if(inputs_.begin(), inputs_.end(), [&](const RigSample& input) {
            return input.tick >= samples.first_tick;
        });
        inputs_.erase(inputs_.begin(), needed);
        while (next_input_ < chunks.size() && chunks[next_input_].chunk.first_tick <= samples.last_tick) {
            try {
                codec_.decode(chunks[next_input_].chunk, inputs_);
            } catch (const StoreError&) {
                // Named when its own stream is read.
            }
            ++next_input_;
        }
    }
    TraceCodec codec_;
    std::vector<RigSample> inputs_, spare_;
    std::vector<TickSample> samples_;
    std::vector<StepRecord> steps_;
    std::vector<Event> events_;
    std::size_t next_input_ = 0;
};

/// Reads the chunks in order of attempts and has each attempt decoded while the next ones are read.
class TraceChecks {
  public:
    explicit TraceChecks(CheckItem& item)
        : item_(item), cores_(std::max(1U, std::thread::hardware_concurrency())) {}
    void begin(StoredTrace trace) {
        if (waiting_.size() >= cores_) finish_oldest();
        waiting_.push_back(std::async(std::launch::async, [given = std::move(trace)]() mutable {
            TraceReader().read(given);
            return std::move(given.problems);
        }));
    }
    void finish() {
        while (!waiting_.empty()) finish_oldest();
    }

  private:
    void finish_oldest() {
        for (Sentence& problem : waiting_.front().get()) item_.problems.push_back(std::move(problem));
        waiting_.erase(waiting_.begin());
    }
    CheckItem& item_;
    std::size_t cores_;
    std::vector<std::future<std::vector<Sentence>>> waiting_;
};

void check_chunks(const Store& store, CheckItem& item, CheckWatch& watch) {
    Query sum(store.connection(), "SELECT COUNT(*) FROM trace_chunk");
    const double all = sum.next() ? static_cast<double>(std::max<std::int64_t>(1, sum.integer(0))) : 1;
    Query rows(store.connection(),
               "SELECT attempt_id, stream, number, first_tick, last_tick, records, checksum, data FROM "
               "trace_chunk ORDER BY attempt_id, stream, number");
    TraceChecks checks(item);
    StoredTrace trace;
    while (rows.next()) {
        constexpr std::int64_t between = 64;
        if (++item.count % between == 0 && !watch.at(static_cast<double>(item.count) / all)) return;
        if (rows.text(0) != trace.attempt_id) {
            if (!trace.attempt_id.empty()) checks.begin(std::move(trace));
            trace = {};
            trace.attempt_id = rows.text(0);
        }
        const std::int64_t stream = rows.integer(1);
        if (stream < 0 || stream >= static_cast<std::int64_t>(stream_count)) {
            item.problems.push_back({QT_TRANSLATE_NOOP("errors", "attempt %1: no stream has the number %2"),
                                     rows.text(0), rows.text(1)});
            continue;
        }
        StoredChunk stored;
        stored.number = rows.integer(2);
        stored.chunk.stream = static_cast<TraceStream>(stream);
        stored.chunk.first_tick = static_cast<std::uint32_t>(rows.integer(3));
        stored.chunk.last_tick = static_cast<std::uint32_t>(rows.integer(4));
        stored.chunk.count = static_cast<std::uint32_t>(rows.integer(5));
        stored.chunk.checksum = rows.bytes(6);
        stored.chunk.data = rows.bytes(7);
        trace.streams[stream].push_back(std::move(stored));
    }
    if (!trace.attempt_id.empty()) checks.begin(std::move(trace));
    checks.finish();
}

void check_lengths(const Store& store, CheckItem& item) {
    // The traces of other stations' attempts stay there and on the programme server. So do those of copies
    // that another station made of an attempt of this one; of a copy that was made here check_records() finds
    // when its trace is gone. An attempt whose beginning this log lacks came back from the server to an older
    // copy of the store.
    constexpr int with_reassignments = 3;
    const QString is_copy = store.found_schema() < with_reassignments
                                ? QString("1 = 0")
                                : QString("id IN (SELECT to_id FROM attempt_reassignment)");
    Query ends(
        store.connection(),
        "SELECT id, events, COALESCE((SELECT SUM(records) FROM trace_chunk c WHERE c.attempt_id = "
        "attempt.id AND c.stream = 3), 0) FROM attempt WHERE state <> 'running' AND ((station_id = ? "
        "AND NOT " +
            is_copy +
            " AND EXISTS (SELECT 1 FROM audit_entry e WHERE e.object_id = attempt.id AND e.operation "
            "= 'attempt.begin')) OR EXISTS (SELECT 1 FROM trace_chunk c WHERE c.attempt_id = attempt.id))");
    ends.bind(store.station_id());
    while (ends.next()) {
        if (ends.integer(1) == trace_not_kept && ends.integer(2) == 0) continue;
        if (ends.integer(1) != ends.integer(2))
            item.problems.push_back(
                {QT_TRANSLATE_NOOP(
                     "errors", "attempt %1: %2 of its %3 events are there, a part of the record is missing"),
                 ends.text(0), ends.text(2), ends.text(1)});
    }
    Query pairs(
        store.connection(),
        "SELECT attempt_id, SUM(records * (stream = 0)), SUM(records * (stream = 1)) FROM trace_chunk "
        "WHERE stream IN (0, 1) GROUP BY attempt_id");
    while (pairs.next()) {
        if (pairs.integer(1) != pairs.integer(2))
            item.problems.push_back(
                {QT_TRANSLATE_NOOP(
                     "errors",
                     "attempt %1: %2 samples for %3 inputs are there, a part of the record is missing"),
                 pairs.text(0), pairs.text(1), pairs.text(2)});
    }
}

}  // namespace

void check_traces(const Store& store, CheckItem& item, CheckWatch& watch) {
    check_chunks(store, item, watch);
    if (watch.stopped()) return;
    check_lengths(store, item);
    Query products(store.connection(), "SELECT attempt_id, kind, checksum, data FROM attempt_product");
    while (products.next()) {
        ++item.count;
        if (blake2b(products.bytes(3), 16) != products.bytes(2)) {
            item.problems.push_back({QT_TRANSLATE_NOOP("errors", "attempt %1: product %2 is damaged"),
                                     products.text(0), products.text(1)});
        }
    }
    constexpr int with_origins = 13;
    if (store.found_schema() < with_origins) return;
    Query origins(store.connection(), "SELECT attempt_id, checksum, state FROM attempt_origin");
    while (origins.next()) {
        ++item.count;
        if (blake2b(origins.bytes(2), 16) != origins.bytes(1))
            item.problems.push_back(
                {QT_TRANSLATE_NOOP("errors", "attempt %1: the state that it began with is damaged"),
                 origins.text(0)});
    }
}

}  // namespace fulcrum::database
