// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/recorder.h"

#include <QDateTime>
#include <cassert>
#include <optional>
#include <thread>
#include <vector>

#include "database/rows/crypto.h"
#include "database/rows/force_devices.h"
#include "database/rows/json.h"
#include "database/rows/person_kind.h"
#include "database/store/accepted_assets.h"
#include "database/store/audit.h"
#include "database/store/recording_lock.h"
#include "database/store/score_rows.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t product_maximum_bytes = 64U << 20U;
constexpr unsigned longest_wait_s = 60;  // of trace kept in memory while another program holds the store

StoreOptions for_writing(StoreOptions options) {
    options.read_only = false;
    // What was interrupted is for the window to list when it opens the store, not for the next recording to
    // tidy away.
    options.close_interrupted = false;
    return options;
}

[[noreturn]] void bad(const Sentence& wrong, const Sentence& hint) {
    throw StoreError(StoreErrorKind::bad_value, wrong, hint);
}

void insert_origin(Connection& connection, const std::string& attempt_id, const AttemptOrigin& origin) {
    Query row(connection,
              "INSERT INTO attempt_origin (attempt_id, source_id, tick, goal, build, checksum, state) "
              "VALUES (?, NULLIF(?, ''), ?, ?, ?, ?, ?)");
    row.bind(attempt_id)
        .bind(origin.source_id)
        .bind(std::int64_t{origin.tick})
        .bind(origin.goal)
        .bind(origin.build)
        .bind(blake2b(origin.state, 16))
        .bind(origin.state)
        .run();
}

void insert_attempt(const Store& store, const Session& session, const AttemptMeta& attempt,
                    const RecordingLock& lock) {
    Connection& connection = store.connection();
    Transaction transaction(connection);
    if (!attempt.scene_text.empty()) {
        Query(connection,
              "INSERT INTO scene_text (digest, text) VALUES (?, ?) ON CONFLICT (digest) DO NOTHING")
            .bind(attempt.scene_digest)
            .bind(attempt.scene_text)
            .run();
    }
    Query(connection,
          "INSERT INTO attempt (id, person_id, station_id, task_id, task_version, mode, device_class, "
          "device, operator_name, variant, "
          "seed, fidelity, scene, scene_digest, curriculum, limits, program_version, cpu_features, started, "
          "utc_offset_min, force_devices, state) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 'running')")
        .bind(attempt.id)
        .bind(attempt.person_id)
        .bind(store.station_id())
        .bind(attempt.task_id)
        .bind(attempt.task_version)
        .bind(std::string(row_of(attempt_modes, attempt.mode).name))
        .bind(std::string(row_of(device_classes, attempt.device_class).name))
        .bind(attempt.device)
        .bind(attempt.operator_name)
        .bind(attempt.variant)
        .bind(static_cast<std::int64_t>(attempt.seed))
        .bind(attempt.fidelity)
        .bind(attempt.scene)
        .bind(attempt.scene_digest)
        .bind(attempt.curriculum)
        .bind(attempt.limits)
        .bind(attempt.program_version)
        .bind(attempt.cpu_features)
        .bind(attempt.started)
        .bind(attempt.utc_offset_min)
        .bind(force_devices_text(attempt.force_devices, attempt.rig_use))
        .run();
    if (attempt.origin) insert_origin(connection, attempt.id, *attempt.origin);
    lock.enter(store, attempt.id);
    for (const AssetFile& file : attempt.assets) {
        Query(connection, "INSERT INTO attempt_asset (attempt_id, file, digest) VALUES (?, ?, ?)")
            .bind(attempt.id)
            .bind(file.name)
            .bind(file.digest)
            .run();
    }
    Audit(store).append(session, attempt.id, "attempt.begin",
                        json_object({{"task", attempt.task_id},
                                     {"mode", row_of(attempt_modes, attempt.mode).name},
                                     {"person", attempt.person_id}}),
                        {{RecordKind::attempt, attempt.id}});
    transaction.commit();
}

}  // namespace

struct Recorder::State {
    std::string path;
    StoreOptions options;
    Session session;
    AttemptMeta meta;
    std::optional<RecordingLock> lock;
    TraceCodec codec;
    std::vector<RigSample> inputs;
    std::vector<TickSample> samples;
    std::vector<StepRecord> steps;
    std::vector<Event> events;
    int next_number[4] = {0, 0, 0, 0};
    std::uint64_t event_count = 0, bytes = 0;
    bool finished = false;
    // A connection belongs to the thread that opened it: the recorder is made by one thread, fed by another.
    std::unique_ptr<Store> store;
    std::thread::id store_thread;

    State(std::string store_path, StoreOptions store_options, const Session& who, AttemptMeta attempt)
        : path(std::move(store_path)),
          options(std::move(store_options)),
          session(who),
          meta(std::move(attempt)) {}

    Store& opened() {
        if (!store || store_thread != std::this_thread::get_id()) {
            store.reset();
            store = std::make_unique<Store>(Store::open(path, options));
            store_thread = std::this_thread::get_id();
        }
        return *store;
    }

    TraceChunk encode(const TickSample* records, std::size_t count) {
        // Usually both streams were fed tick by tick; where they were not, the codec does without.
        const auto begin = static_cast<std::size_t>(records - samples.data());
        return codec.encode(records, count, begin + count <= inputs.size() ? inputs.data() + begin : nullptr);
    }
    template <typename Record>
    TraceChunk encode(const Record* records, std::size_t count) {
        return codec.encode(records, count);
    }

    template <typename Record>
    std::size_t write_chunks(const std::vector<Record>& records, int& number) {
        std::size_t written = 0;
        for (std::size_t begin = 0; begin < records.size(); begin += chunk_maximum_records) {
            const TraceChunk chunk =
                encode(records.data() + begin, std::min(chunk_maximum_records, records.size() - begin));
            Query(opened().connection(),
                  "INSERT INTO trace_chunk (attempt_id, stream, number, first_tick, last_tick, records, "
                  "checksum, data) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
                .bind(meta.id)
                .bind(static_cast<int>(chunk.stream))
                .bind(number++)
                .bind(std::int64_t{chunk.first_tick})
                .bind(std::int64_t{chunk.last_tick})
                .bind(std::int64_t{chunk.count})
                .bind(chunk.checksum)
                .bind(chunk.data)
                .run();
            written += chunk.data.size();
        }
        return written;
    }

    /// Inside the caller's transaction; what has gathered is let go only by committed().
    struct Pending {
        int number[4];
        std::size_t bytes;
    };
    Pending write_all() {
        Pending pending{{next_number[0], next_number[1], next_number[2], next_number[3]}, 0};
        pending.bytes += write_chunks(samples, pending.number[0]);
        pending.bytes += write_chunks(inputs, pending.number[1]);
        pending.bytes += write_chunks(steps, pending.number[2]);
        pending.bytes += write_chunks(events, pending.number[3]);
        return pending;
    }
    void committed(const Pending& pending) {
        for (int stream = 0; stream < 4; ++stream) next_number[stream] = pending.number[stream];
        bytes += pending.bytes;
        event_count += events.size();
        samples.clear();
        inputs.clear();
        steps.clear();
        events.clear();
    }
};

Recorder::Recorder(const std::string& store_path, const Session& session, AttemptMeta meta,
                   StoreOptions options)
    : state_(std::make_unique<State>(store_path, for_writing(std::move(options)), session, std::move(meta))) {
    State& state = *state_;
    Store& store = state.opened();
    AttemptMeta& attempt = state.meta;
    store.require(session, Operation::perform_attempt, Subject::person(attempt.person_id));
    if (attempt.task_id.empty())
        bad(QT_TRANSLATE_NOOP("errors", "the attempt names no task"),
            QT_TRANSLATE_NOOP("errors", "give the task's id"));
    Connection& connection = store.connection();
    Query person(connection, "SELECT kind FROM person WHERE id = ?");
    person.bind(attempt.person_id);
    const bool real = person.next() && person_kind_of(person.text(0), attempt.person_id) == PersonKind::real;
    if (real &&
        (attempt.device_class == DeviceClass::synthetic || attempt.device_class == DeviceClass::external)) {
        bad({QT_TRANSLATE_NOOP("errors", "an attempt by %1 never belongs to a real person"),
             row_of(device_classes, attempt.device_class).title},
            QT_TRANSLATE_NOOP("errors", "record it for a synthetic or external person"));
    }
    if (store.is_demo() && attempt.mode != AttemptMode::practice &&
        read_setting(connection, "demo_sealed") == "1") {
        throw StoreError(StoreErrorKind::sealed_demo,
                         QT_TRANSLATE_NOOP("errors", "the demo takes practice attempts only"),
                         QT_TRANSLATE_NOOP("errors", "choose practice, or make a programme"));
    }
    if (attempt.origin && attempt.mode != AttemptMode::practice)
        bad(QT_TRANSLATE_NOOP("errors", "an attempt that continues another one is practice"),
            QT_TRANSLATE_NOOP("errors", "choose practice"));
    if (real && attempt.mode == AttemptMode::assessed) {
        const std::vector<AssetFile> unknown = AcceptedAssets(store).unknown(attempt.assets);
        if (!unknown.empty())
            bad(practice_only_words(unknown), QT_TRANSLATE_NOOP("errors", "perform it as practice"));
    }
    attempt.scene_digest = attempt.scene_text.empty() ? std::string() : text_digest(attempt.scene_text);
    if (attempt.id.empty()) attempt.id = random_uuid();
    if (attempt.started == 0) {
        attempt.started = store.now();
        attempt.utc_offset_min = QDateTime::fromMSecsSinceEpoch(attempt.started).offsetFromUtc() / 60;
    }
    state.lock.emplace(store_path, attempt.id);
    try {
        insert_attempt(store, session, attempt, *state.lock);
    } catch (...) {
        state.lock->release();
        throw;
    }
    state.inputs.reserve(2 * flush_ticks);
    state.samples.reserve(2 * flush_ticks);
    state.steps.reserve(2 * flush_ticks);
    // The thread that feeds the recorder opens its own.
    state.store.reset();
}

Recorder::~Recorder() = default;

const std::string& Recorder::attempt_id() const noexcept {
    return state_->meta.id;
}
const AttemptMeta& Recorder::meta() const noexcept {
    return state_->meta;
}
bool Recorder::finished() const noexcept {
    return state_->finished;
}
std::uint64_t Recorder::bytes_written() const noexcept {
    return state_->bytes;
}
std::uint64_t Recorder::records_waiting() const noexcept {
    return state_->inputs.size() + state_->samples.size() + state_->steps.size() + state_->events.size();
}

void Recorder::append(const RigSample& input) {
    if (state_->meta.keep_trace) state_->inputs.push_back(input);
}
void Recorder::append(const StepRecord& step) {
    if (state_->meta.keep_trace) state_->steps.push_back(step);
}
void Recorder::append(const Event& event) {
    if (state_->meta.keep_trace) state_->events.push_back(event);
}
void Recorder::append(const TickSample& sample) {
    State& state = *state_;
    if (!state.meta.keep_trace) return;
    state.samples.push_back(sample);
    if (state.samples.size() % flush_ticks != 0) return;
    try {
        flush();
    } catch (const StoreError& error) {
        // Another program is writing: the records wait for the next second. Only a lock that lasts is
        // reported.
        if (error.kind() != StoreErrorKind::locked ||
            state.samples.size() >= std::size_t{longest_wait_s} * flush_ticks)
            throw;
    }
}

void Recorder::flush() {
    State& state = *state_;
    assert(!state.finished);
    if (records_waiting() == 0) return;
    Transaction transaction(state.opened().connection());
    const State::Pending pending = state.write_all();
    transaction.commit();
    state.committed(pending);
}

bool Recorder::relabel_as_practice(const Statement& reason) {
    State& state = *state_;
    assert(!state.finished);
    if (state.meta.mode == AttemptMode::practice) return true;
    try {
        Store& store = state.opened();
        Transaction transaction(store.connection());
        Query(store.connection(), "UPDATE attempt SET mode = 'practice' WHERE id = ?")
            .bind(state.meta.id)
            .run();
        Audit(store).append(state.session, state.meta.id, "attempt.practice",
                            json_object({{"from", row_of(attempt_modes, state.meta.mode).name},
                                         {"reason", stored_text(reason)}}),
                            {{RecordKind::attempt, state.meta.id}});
        transaction.commit();
    } catch (const StoreError& error) {
        if (error.kind() == StoreErrorKind::locked) return false;
        throw;
    }
    state.meta.mode = AttemptMode::practice;
    return true;
}

void Recorder::finish(const AttemptResult& result) {
    State& state = *state_;
    assert(!state.finished);
    Store& store = state.opened();
    Connection& connection = store.connection();
    Transaction transaction(connection);
    const State::Pending pending = state.write_all();
    for (const ProductBlob& product : result.products) {
        if (product.data.size() > product_maximum_bytes)
            bad({QT_TRANSLATE_NOOP("errors", "product %1 is larger than 64 MiB"), product.kind},
                QT_TRANSLATE_NOOP("errors", "store it coarser"));
        Query(connection,
              "INSERT INTO attempt_product (attempt_id, kind, checksum, data) VALUES (?, ?, ?, ?)")
            .bind(state.meta.id)
            .bind(product.kind)
            .bind(blake2b(product.data, 16))
            .bind(product.data)
            .run();
    }
    if (result.state == AttemptState::running || result.state == AttemptState::voided)
        bad(QT_TRANSLATE_NOOP("errors", "an attempt ends neither running nor voided"),
            QT_TRANSLATE_NOOP("errors", "give the state in which it ended"));
    const std::string state_name = row_of(attempt_states, result.state).name;
    RecordingLock::leave(store, state.meta.id);
    if (result.rig_use) {
        Query(connection, "UPDATE attempt SET force_devices = ? WHERE id = ?")
            .bind(force_devices_text(state.meta.force_devices, result.rig_use))
            .bind(state.meta.id)
            .run();
    }
    Query ended(connection,
                "UPDATE attempt SET state = ?, duration_s = ?, wall_s = ?, missed_ticks = ?, lost_samples = "
                "?, events = ?, "
                "state_hash = ? WHERE id = ?");
    ended.bind(state_name)
        .bind(result.duration_s)
        .bind(result.wall_s)
        .bind(std::int64_t{result.missed_ticks})
        .bind(static_cast<std::int64_t>(result.lost_samples))
        .bind(state.meta.keep_trace ? static_cast<std::int64_t>(state.event_count + state.events.size())
                                    : trace_not_kept)
        .bind(result.state_hash)
        .bind(state.meta.id)
        .run();
    std::vector<RecordName> records = {{RecordKind::attempt, state.meta.id}};
    if (state.meta.keep_trace || !result.products.empty())
        records.push_back({RecordKind::trace, state.meta.id});
    Audit(store).append(
        state.session, state.meta.id, "attempt.finish",
        json_object({{"state", state_name}, {"task", state.meta.task_id}, {"state_hash", result.state_hash}}),
        records);
    if (result.score && state.meta.origin)
        bad(QT_TRANSLATE_NOOP("errors", "an attempt that continues another one is never scored"),
            QT_TRANSLATE_NOOP("errors", "finish it without a score"));
    if (result.score) write_score(store, state.session, state.meta.id, *result.score);
    transaction.commit();
    state.committed(pending);
    state.finished = true;
    state.lock->release();
}

}  // namespace fulcrum::database
