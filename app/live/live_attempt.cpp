// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/live_attempt.h"

#include <mutex>
#include <thread>

#include "app/live/attempt_recording.h"
#include "app/live/device_rig.h"
#include "app/live/device_watch.h"
#include "app/live/force_release.h"
#include "app/live/frame_follower.h"
#include "app/live/real_time.h"
#include "app/live/record_items.h"
#include "app/live/scope_hold.h"
#include "app/live/sleep_account.h"
#include "app/live/world_products.h"
#include "assessment/attempt/engine_state.h"
#include "database/records/attempts.h"
#include "database/rows/packed_bytes.h"
#include "sim_core/numerics/boot_clock.h"
#include "sim_core/telemetry/ring.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t world_ring_ticks = 512;    // half a second of a stalled world; then ticks are lost
constexpr std::size_t record_ring_ticks = 8192;  // eight seconds of a stalled disk
constexpr int recorder_pace_ms = 20;  // a broken limit is stored within 50 ms: the rest is to write
constexpr int catch_up_ticks = 20;    // above this delay the deadline is moved instead
constexpr std::int64_t longest_gap_ns =
    1000LL * 1'000'000;  // stopped for longer, an assessed attempt is practice: there was time to think

}  // namespace

struct LiveAttempt::State : public AttemptSink {
    LiveRequest request;
    std::unique_ptr<AttemptEngine> engine;  // made by the recorder thread; the owner's once `built` is set
    std::unique_ptr<AttemptRecording> recording;  // created when the attempt begins; null for a demonstration
    std::vector<TargetSphere> targets;
    std::shared_ptr<const GhostPath> ghost;  // the owner reads it once `built` is set
    RigSample hands;  // at the start, where not the scene's own; the owner reads it once `built` is set

    Ring<TickOutput> world_ring{world_ring_ticks};
    Ring<RecordTick> record_ring{record_ring_ticks};
    Ring<RecordWorld> record_world_ring{record_ring_ticks};
    WorldProducts products;
    TripleBuffer<Watched> watched;
    Signal may_begin, ticks_ready;
    DeviceWatch watch;     // haptic thread, once it runs
    ScopeHold scope_hold;  // haptic thread, once it runs

    std::atomic<bool> built{false}, begun{false}, running{false};
    std::atomic<bool> paused{false}, abandon{false}, stop{false}, haptic_stopped{false}, world_stopped{false};
    std::atomic<bool> device_lost{false}, resume_asked{false}, became_practice{false};
    std::atomic<std::uint32_t> tick_count{0};
    std::atomic<std::int64_t> gap_ns{0};  // longest gap above longest_gap_ns, not yet recorded
    std::atomic<bool> ended{false}, finished{false}, failed{false};
    mutable std::mutex end_mutex;  // guards message and result, which the recorder thread passes to the owner
    Sentence trouble;
    std::exception_ptr error;
    std::optional<ui::AttemptOutcome> result;
    std::optional<ScoredAttempt> scored;
    LoopCounters counters;
    std::thread haptic_thread, world_thread, recorder_thread;

    explicit State(LiveRequest request_in) : request(std::move(request_in)) {
        request.meta.force_devices = devices_of(*request.rig);
        request.meta.rig_use = request.rig->use();
    }
    bool recorded() const { return !request.store_path.empty(); }
    void build() {
        engine = std::make_unique<AttemptEngine>(request.loaded.scene, request.loaded.task, request.seed);
        engine->world().fail_while(request.simulator_fails.get());
        if (request.make_ghost) ghost = request.make_ghost(stop);
        if (stop.load()) return;
        if (request.bring) {
            if (!request.bring(*engine, stop)) return;
            engine->begin_here();
            database::AttemptOrigin& origin = request.meta.origin.value();
            origin.tick = engine->next_tick() - 1;
            origin.state = database::pack_bytes(engine_state(*engine));
            tick_count.store(origin.tick);
            hands = engine->loop().last_input();
            scope_hold.begin_from(hands.camera);
            watch.begin_from(engine->loop().held(Hand::left), engine->loop().held(Hand::right));
        }
        targets = engine->initial_snapshot().targets;
        products.fill(*engine, dynamic_cast<ObservingRig*>(request.rig.get()) != nullptr);
        engine->use_devices(request.meta.force_devices);
        built.store(true);
    }

    // AttemptSink, called on the world thread.
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_event(const Event& event) noexcept override { record_world_ring.push({true, event, {}}); }
    void on_step(const StepRecord& step) noexcept override { record_world_ring.push({false, {}, step}); }

    void run_haptic() noexcept;
    void run_world() noexcept;
    void run_recorder();
    void keep(const Event& event);
    void end_tap();
    void drain();
    void finish();
    void fail(const Sentence& what, std::exception_ptr why);
    std::uint32_t device_flags(const RigSample& sample) noexcept;
};

std::uint32_t LiveAttempt::State::device_flags(const RigSample& sample) noexcept {
    const bool resume = resume_asked.exchange(false, std::memory_order_relaxed);
    const bool was_lost = watch.lost();
    const std::uint32_t flags = watch.tick(sample, paused.load(std::memory_order_relaxed), resume);
    if (watch.lost() || was_lost) {
        Watched& slot = watched.write_slot();
        slot = {watch.back(),
                watch.in_place(),
                watch.trouble(),
                watch.culprit(),
                {watch.alignment(Hand::left), watch.alignment(Hand::right)}};
        watched.publish();
    }
    device_lost.store(watch.lost(), std::memory_order_relaxed);
    if (watch.expired()) stop.store(true, std::memory_order_relaxed);
    return flags;
}

void LiveAttempt::State::run_haptic() noexcept {
    counters.real_time_priority(raise_priority(80));
    Rig& rig = *request.rig;
    SampleTap* const tap = request.tap.get();
    auto* observer = dynamic_cast<ObservingRig*>(&rig);
    const auto ticks_per_step = static_cast<std::uint32_t>(engine->scene().ticks_per_step);
    const auto period = static_cast<std::int64_t>(1e9 / engine->scene().tick_rate);
    const auto observe = [&] {
        const View& seen = products.rig_view.value();
        observer->observe(seen.snapshot, seen.display);
    };
    if (observer != nullptr) observe();
    std::int64_t deadline = now_ns() + period;
    TickAccount account(period);
    SleepAccount sleeps;
    std::int64_t last_duration = 0;
    ThreadUse last_use;
    TickOutput output;
    for (std::uint32_t tick = engine->next_tick(); !stop.load(std::memory_order_relaxed); ++tick) {
        std::int64_t begin = now_ns();
        if (begin < deadline) {
            sleep_until(deadline);
            begin = now_ns();
        }
        const std::int64_t late = begin - deadline;
        const ThreadUse at_begin = use_of_this_thread();
        counters.tick_begins(late, account.begin(late, last_duration, last_use));
        const std::int64_t gap =
            sleeps.stood_still(late, begin, boot_ns(), paused.load(std::memory_order_relaxed));
        if (gap > longest_gap_ns && gap > gap_ns.load(std::memory_order_relaxed))
            gap_ns.store(gap, std::memory_order_relaxed);
        if (late >= catch_up_ticks * period) {
            deadline = begin;
            account.clock_moved();
        }
        deadline += period;

        if (tick % ticks_per_step == 1U % ticks_per_step) {
            if (products.models.update()) engine->adopt(products.models.value());
            if (observer != nullptr && products.rig_view.update()) observe();
        }
        RigSample input;
        input.tick = tick;
        rig.read(tick, input);
        input.tick = tick;
        if (paused.load(std::memory_order_relaxed)) input.flags |= rig_paused;
        if (abandon.load(std::memory_order_relaxed)) input.flags |= rig_abandon;
        input.flags |= device_flags(input);
        scope_hold.apply(input);
        output = engine->tick(input);
        output.sample.missed = counters.missed();
        write_forces(rig, output);
        world_ring.push(output);
        record_ring.push({output.input, output.sample});
        if (tap != nullptr) tap->newest.write({output.sample});
        tick_count.store(tick, std::memory_order_relaxed);
        if (tick % ticks_per_step == 0) ticks_ready.post();
        last_duration = now_ns() - begin;
        last_use = use_of_this_thread() - at_begin;
        counters.tick_ends(last_duration, last_use);
    }
    release_forces(rig, output, engine->scene());
    haptic_stopped.store(true);
    ticks_ready.post();
}

void LiveAttempt::State::run_world() noexcept {
    raise_priority(60);
    const auto ticks_per_step = static_cast<std::uint32_t>(engine->scene().ticks_per_step);
    std::vector<TickOutput> outputs;
    outputs.reserve(world_ring_ticks);
    while (true) {
        ticks_ready.wait();
        TickOutput output;
        while (outputs.size() < world_ring_ticks && world_ring.pop(output)) outputs.push_back(output);
        // Up to the last multiple of m: later ticks belong to the next step.
        std::size_t count = 0;
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            if (outputs[i].sample.tick % ticks_per_step == 0) count = i + 1;
        }
        if (count > 0 && !ended.load(std::memory_order_relaxed)) {
            const std::int64_t begin = now_ns();
            if (count > ticks_per_step) {
                counters.step_is_late();
                Event late;
                late.tick = outputs[count - 1].sample.tick;
                late.kind = EventKind::world_late;
                late.detail = static_cast<std::int32_t>(count - ticks_per_step);
                on_event(late);
            }
            products.publish(engine->step(outputs.data(), count, *this));
            counters.step_ends(now_ns() - begin);
            outputs.erase(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(count));
            if (engine->ended()) {
                ended.store(true);
                stop.store(true);
            }
        }
        if (haptic_stopped.load()) break;
    }
    world_stopped.store(true);
}

void LiveAttempt::State::keep(const Event& event) {
    if (request.tap != nullptr) request.tap->events.add(event);
    if (recording) recording->append(event);
}

void LiveAttempt::State::end_tap() {
    if (request.tap != nullptr) request.tap->ended.store(true, std::memory_order_release);
}

void LiveAttempt::State::drain() {
    RecordTick tick;
    while (record_ring.pop(tick)) {
        if (recording) recording->append(tick.input, tick.sample);
    }
    RecordWorld world;
    while (record_world_ring.pop(world)) {
        if (world.is_event)
            keep(world.event);
        else if (recording)
            recording->append(world.step);
    }
    if (!recording) return;
    if (const std::int64_t gap = gap_ns.exchange(0)) recording->stood_still(static_cast<double>(gap) * 1e-9);
    recording->keep(tick_count.load());
    if (recording->became_practice()) became_practice.store(true);
}

void LiveAttempt::State::fail(const Sentence& what, std::exception_ptr why) {
    const std::lock_guard<std::mutex> lock(end_mutex);
    trouble = what;
    error = std::move(why);
    failed.store(true);
    if (request.tap != nullptr) request.tap->part.store(true);
}

void LiveAttempt::State::run_recorder() {
    try {
        build();
        may_begin.wait();
        if (stop.load())
            return fail(QT_TRANSLATE_NOOP("errors", "the attempt had not begun; nothing was stored"),
                        nullptr);
        if (recorded()) recording = std::make_unique<AttemptRecording>(request, targets);
    } catch (const std::exception& why) {
        return fail({QT_TRANSLATE_NOOP("errors", "the attempt could not be started: %1"), sentence_of(why)},
                    std::current_exception());
    }
    running.store(true);
    world_thread = std::thread([this] { run_world(); });
    haptic_thread = std::thread([this] { run_haptic(); });
    Signal pace;
    try {
        while (!world_stopped.load()) {
            pace.wait_for_ms(recorder_pace_ms);
            drain();
        }
        haptic_thread.join();
        world_thread.join();
        drain();
        finish();
    } catch (const std::exception& why) {
        stop.store(true);
        if (haptic_thread.joinable()) haptic_thread.join();
        if (world_thread.joinable()) world_thread.join();
        fail({QT_TRANSLATE_NOOP(
                  "errors",
                  "the attempt could not be stored completely: %1; the part that was stored is kept "
                  "and listed as interrupted"),
              sentence_of(why)},
             std::current_exception());
    }
}

void LiveAttempt::State::finish() {
    if (!recording) {  // a demonstration is not stored
        finished.store(true);
        return;
    }
    const std::uint64_t lost = world_ring.lost() + record_ring.lost() + record_world_ring.lost();
    const auto mark = [&](EventKind kind, std::uint64_t detail) {
        keep({tick_count.load(), kind, 255, -1, static_cast<std::int32_t>(detail), 0.0F});
    };
    if (lost > 0) mark(EventKind::samples_lost, lost);
    // A trainee who closes the window abandons the attempt.
    if (!ended.load()) mark(abandon.load() ? EventKind::abandoned : EventKind::interrupted, 0);
    end_tap();  // before what takes time
    recording->settle();
    if (recording->became_practice()) became_practice.store(true);
    ScoredAttempt score = recording->score();
    RunOutcome outcome;
    const std::uint32_t before = request.meta.origin ? request.meta.origin->tick : 0;
    outcome.state_hash = engine->state_hash();
    const std::uint32_t missed = counters.missed();
    database::AttemptResult stored =
        attempt_result(score, outcome, (tick_count.load() - before) * engine->scene().tick_period(), missed,
                       lost, request.meta.limits);
    if (request.meta.origin) {  // practice that continues another attempt is never scored
        stored.duration_s -= before * engine->scene().tick_period();
        stored.score.reset();
    }
    stored.rig_use = request.rig->use();  // its thread has ended
    recording->finish(stored);
    const std::lock_guard<std::mutex> lock(end_mutex);
    ui::AttemptOutcome shown;
    shown.attempt_id = recording->attempt_id();
    shown.state = stored.state;
    shown.duration_s = stored.duration_s;
    shown.missed_ticks = missed;
    shown.lost_samples = lost;
    result = shown;
    scored = std::move(score);
    finished.store(true);
}

LiveAttempt::LiveAttempt(LiveRequest request) : state_(std::make_unique<State>(std::move(request))) {
    State& state = *state_;
    state.recorder_thread = std::thread([&state] {
        state.run_recorder();
        state.end_tap();  // wherever it ended
    });
}

LiveAttempt::~LiveAttempt() {
    interrupt();
    wait();
}

const Scene& LiveAttempt::scene() const {
    return state_->request.loaded.scene;
}
const TaskDefinition& LiveAttempt::task() const {
    return state_->request.loaded.task;
}
bool LiveAttempt::assessed() const {
    return state_->request.assessed && !state_->became_practice.load();
}
bool LiveAttempt::became_practice() const {
    return state_->request.assessed && state_->became_practice.load();
}

ui::AttemptPhase LiveAttempt::phase() const {
    const State& state = *state_;
    if (state.failed.load()) return ui::AttemptPhase::failed;
    if (state.finished.load()) return ui::AttemptPhase::finished;
    if (!state.built.load()) return ui::AttemptPhase::starting;
    if (!state.begun.load()) return ui::AttemptPhase::ready;
    if (!state.running.load())
        return ui::AttemptPhase::starting;  // the recorder is writing the start to the store
    if (state.stop.load()) return ui::AttemptPhase::finishing;
    if (state.device_lost.load()) return ui::AttemptPhase::device_lost;
    if (state.paused.load()) return ui::AttemptPhase::paused;
    return ui::AttemptPhase::running;
}

const RigSample* LiveAttempt::hands_at_start() const {
    const State& state = *state_;
    return state.built.load() && state.request.bring ? &state.hands : nullptr;
}

std::shared_ptr<const GhostPath> LiveAttempt::ghost() const {
    return state_->built.load() ? state_->ghost : nullptr;
}

void LiveAttempt::start() {
    if (!state_->begun.exchange(true)) state_->may_begin.post();
}

bool LiveAttempt::update() {
    return state_->products.view.update();
}
const WorldSnapshot& LiveAttempt::snapshot() const {
    return state_->products.view.value().snapshot;
}
const TaskDisplay& LiveAttempt::display() const {
    return state_->products.view.value().display;
}

ui::LoopHealth LiveAttempt::health() const {
    const State& state = *state_;
    ui::LoopHealth health;
    health.ticks = state.tick_count.load();
    health.missed_ticks = state.counters.missed();
    health.late_steps = state.counters.late_steps();
    health.lost_samples = state.world_ring.lost() + state.record_ring.lost() + state.record_world_ring.lost();
    for (int hand = 0; hand < hand_count; ++hand)
        health.force_felt[hand] =
            state.request.meta.force_devices[static_cast<std::size_t>(hand)].has_value();
    return health;
}

void LiveAttempt::pause() {
    state_->paused.store(true);
}
void LiveAttempt::resume() {
    state_->paused.store(false);
    if (state_->device_lost.load()) state_->resume_asked.store(true);
}
void LiveAttempt::abandon() {
    state_->abandon.store(true);
    state_->paused.store(false);
}
void LiveAttempt::interrupt() {
    state_->stop.store(true);
    start();  // wakes a recorder thread that still waits for the start; it then sees `stop`
}

ui::Realignment LiveAttempt::realignment() {
    State& state = *state_;
    ui::Realignment shown;
    if (!state.device_lost.load()) return shown;
    state.watched.update();
    const Watched& watched = state.watched.value();
    shown.back = watched.back;
    shown.in_place = watched.in_place;
    for (int hand = 0; hand < hand_count; ++hand) {
        const InstrumentSpec* spec = scene().instrument(static_cast<Hand>(hand));
        const HandAlignment& from = watched.hand[hand];
        shown.hand[hand] = {spec != nullptr, from.in_place, from.distance, from.angle, {}};
        if (spec != nullptr)
            shown.hand[hand].device =
                tool_pose(make_instrument(*spec, scene().tick_period()), from.device).pose();
    }
    return shown;
}

Sentence LiveAttempt::message() const {
    const State& state = *state_;
    if (state.failed.load()) {
        const std::lock_guard<std::mutex> lock(state.end_mutex);
        return state.trouble;
    }
    if (state.device_lost.load()) {
        const Watched& watched = state.watched.value();
        return loss_of(watched.trouble, watched.culprit);
    }
    return {};
}

const std::optional<ui::AttemptOutcome>& LiveAttempt::outcome() const {
    static const std::optional<ui::AttemptOutcome> none;
    return state_->finished.load() ? state_->result : none;
}

void LiveAttempt::wait() {
    if (state_->recorder_thread.joinable()) state_->recorder_thread.join();
}

void LiveAttempt::rethrow() const {
    const std::lock_guard<std::mutex> lock(state_->end_mutex);
    if (state_->error) std::rethrow_exception(state_->error);
}

const ScoredAttempt* LiveAttempt::scored() const {
    return state_->finished.load() ? &*state_->scored : nullptr;
}
std::uint64_t LiveAttempt::state_hash() const {
    return state_->engine->state_hash();
}

LoopStatistics LiveAttempt::statistics() const {
    LoopStatistics statistics = state_->counters.read();
    statistics.ticks = state_->tick_count.load();
    statistics.lost_samples =
        state_->world_ring.lost() + state_->record_ring.lost() + state_->record_world_ring.lost();
    if (state_->request.device != nullptr) statistics.device = state_->request.device->timing();
    if (state_->request.follower != nullptr) statistics.replay_bytes = state_->request.follower->bytes();
    return statistics;
}

}  // namespace fulcrum::app
