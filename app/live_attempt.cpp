// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live_attempt.h"

#include <pthread.h>
#include <semaphore.h>
#include <time.h>

#include <cerrno>
#include <mutex>
#include <thread>

#include "app/histogram.h"
#include "database/attempts.h"
#include "sim_core/telemetry/ring.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t world_ring_ticks = 512;        // half a second: a world that stalls longer loses ticks, counted
constexpr std::size_t record_ring_ticks = 8192;      // eight seconds of a stalled disk
constexpr std::uint32_t loss_ticks = 50;             // a device that is silent that long is lost
constexpr std::uint32_t loss_limit_ticks = 60000;    // and after a minute the attempt is interrupted
constexpr int catch_up_ticks = 20;                   // later than that the clock is moved instead

std::int64_t now_ns() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1000000000LL + time.tv_nsec;
}

void sleep_until(std::int64_t deadline_ns) {
    timespec time{};
    time.tv_sec = deadline_ns / 1000000000LL;
    time.tv_nsec = deadline_ns % 1000000000LL;
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) == EINTR) {
    }
}

bool raise_priority(int priority) {
    sched_param parameter{};
    parameter.sched_priority = priority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) == 0;
}

/// Counting signal between threads; post() never blocks.
class Signal {
  public:
    Signal() { sem_init(&semaphore_, 0, 0); }
    ~Signal() { sem_destroy(&semaphore_); }
    Signal(const Signal&) = delete;
    Signal& operator=(const Signal&) = delete;
    void post() noexcept { sem_post(&semaphore_); }
    void wait() noexcept {
        while (sem_wait(&semaphore_) != 0 && errno == EINTR) {
        }
    }
    /// False when the time ran out.
    bool wait_for_ms(int milliseconds) noexcept {
        timespec time{};
        clock_gettime(CLOCK_REALTIME, &time);
        time.tv_nsec += milliseconds * 1000000L;
        time.tv_sec += time.tv_nsec / 1000000000L;
        time.tv_nsec %= 1000000000L;
        int result = 0;
        while ((result = sem_timedwait(&semaphore_, &time)) != 0 && errno == EINTR) {
        }
        return result == 0;
    }

  private:
    sem_t semaphore_;
};

struct RecordTick {
    RigSample input;
    TickSample sample;
};
struct RecordWorld {
    bool is_event = false;
    Event event;
    StepRecord step;
};
struct View {
    WorldSnapshot snapshot;
    TaskDisplay display;
};

}  // namespace

struct LiveAttempt::State : public AttemptSink {
    LiveRequest request;
    AttemptEngine engine;
    std::unique_ptr<database::Recorder> recorder;
    std::vector<Vector3> targets;

    Ring<TickOutput> world_ring{world_ring_ticks};
    Ring<RecordTick> record_ring{record_ring_ticks};
    Ring<RecordWorld> record_world_ring{record_ring_ticks};
    TripleBuffer<LocalModels> models;
    TripleBuffer<View> view, rig_view;
    Signal ticks_ready;

    std::atomic<bool> paused{false}, abandon{false}, stop{false}, haptic_stopped{false}, world_stopped{false}, interrupted{false};
    std::atomic<bool> device_lost{false}, device_back{false}, resume_asked{false};
    std::atomic<std::uint32_t> tick_count{0}, missed_program{0}, missed_scheduler{0}, late_steps{0};
    std::atomic<bool> ended{false}, finished{false}, failed{false};
    std::atomic<bool> real_time_priority{false};

    mutable std::mutex end_mutex;  // guards what the recorder thread leaves for the owner: message and result
    std::string trouble;
    std::optional<ui::AttemptOutcome> result;
    std::optional<ScoredAttempt> scored;

    DurationHistogram wake, tick_time, step_time;
    std::thread haptic_thread, world_thread, recorder_thread;

    explicit State(LiveRequest request_in)
        : request(std::move(request_in)), engine(request.loaded.scene, request.loaded.task, request.seed) {
        recorder = std::make_unique<database::Recorder>(request.store_path, request.session, request.meta);
        for (const TargetSphere& target : engine.initial_snapshot().targets) targets.push_back(target.centre);
        models.fill(engine.world().local_models());
        const View start{engine.initial_snapshot(), engine.display()};
        view.fill(start);
        rig_view.fill(start);
        for (int hand = 0; hand < hand_count; ++hand) engine.loop().set_device_damping(static_cast<Hand>(hand), request.rig->damping(static_cast<Hand>(hand)));
    }

    // AttemptSink, called on the world thread.
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_event(const Event& event) noexcept override { record_world_ring.push({true, event, {}}); }
    void on_step(const StepRecord& step) noexcept override { record_world_ring.push({false, {}, step}); }

    void run_haptic() noexcept;
    void run_world() noexcept;
    void run_recorder();
    void drain();
    void finish();
    std::uint32_t device_flags(const RigSample& sample, std::uint32_t& silent, std::uint32_t& lost_for) noexcept;
};

std::uint32_t LiveAttempt::State::device_flags(const RigSample& sample, std::uint32_t& silent, std::uint32_t& lost_for) noexcept {
    const bool answering = sample.hand[0].present != 0 && sample.hand[1].present != 0;
    silent = answering ? 0 : silent + 1;
    if (silent > loss_ticks && !device_lost.load(std::memory_order_relaxed)) {
        device_lost.store(true, std::memory_order_relaxed);
        lost_for = 0;
    }
    if (!device_lost.load(std::memory_order_relaxed)) return 0;
    ++lost_for;
    device_back.store(answering, std::memory_order_relaxed);
    if (answering && resume_asked.exchange(false, std::memory_order_relaxed)) {
        device_lost.store(false, std::memory_order_relaxed);
        return 0;
    }
    if (lost_for > loss_limit_ticks) {
        interrupted.store(true, std::memory_order_relaxed);
        stop.store(true, std::memory_order_relaxed);
    }
    return rig_device_lost;
}

void LiveAttempt::State::run_haptic() noexcept {
    real_time_priority.store(raise_priority(80), std::memory_order_relaxed);
    Rig& rig = *request.rig;
    auto* observer = dynamic_cast<ObservingRig*>(&rig);
    const auto ticks_per_step = static_cast<std::uint32_t>(engine.scene().ticks_per_step);
    const auto period = static_cast<std::int64_t>(1e9 / engine.scene().tick_rate);
    if (observer != nullptr) observer->observe(rig_view.value().snapshot, rig_view.value().display);
    std::uint32_t silent = 0, lost_for = 0;
    std::int64_t deadline = now_ns() + period;
    std::int64_t last_duration = 0;
    for (std::uint32_t tick = 1; !stop.load(std::memory_order_relaxed); ++tick) {
        std::int64_t begin = now_ns();
        if (begin < deadline) {
            sleep_until(deadline);
            begin = now_ns();
        }
        const std::int64_t late = begin - deadline;
        wake.add(static_cast<double>(late) * 1e-3);
        if (late >= period) {
            (last_duration >= period ? missed_program : missed_scheduler).fetch_add(1, std::memory_order_relaxed);
            if (late >= catch_up_ticks * period) deadline = begin;
        }
        deadline += period;

        if (tick % ticks_per_step == 1U % ticks_per_step) {
            if (models.update()) engine.adopt(models.value());
            if (observer != nullptr && rig_view.update()) observer->observe(rig_view.value().snapshot, rig_view.value().display);
        }
        RigSample input;
        input.tick = tick;
        rig.read(tick, input);
        input.tick = tick;
        if (paused.load(std::memory_order_relaxed)) input.flags |= rig_paused;
        if (abandon.load(std::memory_order_relaxed)) input.flags |= rig_abandon;
        input.flags |= device_flags(input, silent, lost_for);
        TickOutput output = engine.tick(input);
        output.sample.missed = missed_program.load(std::memory_order_relaxed) + missed_scheduler.load(std::memory_order_relaxed);
        rig.write_force(Hand::left, output.device_force[0]);
        rig.write_force(Hand::right, output.device_force[1]);
        world_ring.push(output);
        record_ring.push({output.input, output.sample});
        tick_count.store(tick, std::memory_order_relaxed);
        if (tick % ticks_per_step == 0) ticks_ready.post();
        last_duration = now_ns() - begin;
        tick_time.add(static_cast<double>(last_duration) * 1e-3);
    }
    rig.write_force(Hand::left, Vector3::Zero());
    rig.write_force(Hand::right, Vector3::Zero());
    haptic_stopped.store(true);
    ticks_ready.post();
}

void LiveAttempt::State::run_world() noexcept {
    raise_priority(60);
    const auto ticks_per_step = static_cast<std::uint32_t>(engine.scene().ticks_per_step);
    std::vector<TickOutput> outputs;
    outputs.reserve(world_ring_ticks);
    while (true) {
        ticks_ready.wait();
        TickOutput output;
        while (outputs.size() < world_ring_ticks && world_ring.pop(output)) outputs.push_back(output);
        // Up to the last multiple of m: what came after belongs to the next step.
        std::size_t count = 0;
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            if (outputs[i].sample.tick % ticks_per_step == 0) count = i + 1;
        }
        if (count > 0 && !ended.load(std::memory_order_relaxed)) {
            const std::int64_t begin = now_ns();
            if (count > ticks_per_step) {
                late_steps.fetch_add(1, std::memory_order_relaxed);
                Event late;
                late.tick = outputs[count - 1].sample.tick;
                late.kind = EventKind::world_late;
                late.detail = static_cast<std::int32_t>(count - ticks_per_step);
                on_event(late);
            }
            const StepProducts products = engine.step(outputs.data(), count, *this);
            models.write_slot() = *products.models;
            models.publish();
            for (TripleBuffer<View>* buffer : {&view, &rig_view}) {
                View& slot = buffer->write_slot();
                slot.snapshot = *products.snapshot;
                slot.display = *products.display;
                buffer->publish();
            }
            step_time.add(static_cast<double>(now_ns() - begin) * 1e-3);
            outputs.erase(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(count));
            if (engine.ended()) {
                ended.store(true);
                stop.store(true);
            }
        }
        if (haptic_stopped.load()) break;
    }
    world_stopped.store(true);
}

void LiveAttempt::State::drain() {
    RecordTick tick;
    while (record_ring.pop(tick)) {
        recorder->append(tick.input);
        recorder->append(tick.sample);
    }
    RecordWorld world;
    while (record_world_ring.pop(world)) {
        if (world.is_event) {
            recorder->append(world.event);
        } else {
            recorder->append(world.step);
        }
    }
}

void LiveAttempt::State::run_recorder() {
    Signal pace;
    try {
        while (!world_stopped.load()) {
            pace.wait_for_ms(100);
            drain();
        }
        haptic_thread.join();
        world_thread.join();
        drain();
        finish();
    } catch (const std::exception& error) {
        stop.store(true);
        if (haptic_thread.joinable()) haptic_thread.join();
        if (world_thread.joinable()) world_thread.join();
        const std::lock_guard<std::mutex> lock(end_mutex);
        trouble = std::string("the attempt could not be stored to its end: ") + error.what() + "; what was written before is kept and listed as interrupted";
        failed.store(true);
    }
}

void LiveAttempt::State::finish() {
    const std::uint64_t lost = world_ring.lost() + record_ring.lost() + record_world_ring.lost();
    Event mark;
    mark.tick = tick_count.load();
    if (lost > 0) {
        mark.kind = EventKind::samples_lost;
        mark.detail = static_cast<std::int32_t>(lost);
        recorder->append(mark);
    }
    if (!ended.load()) {
        mark.kind = EventKind::interrupted;
        mark.detail = 0;
        recorder->append(mark);
    }
    recorder->flush();
    // Scored from the record, not from memory: what is stored is what counts.
    database::Store store = database::Store::open(request.store_path, [] {
        database::StoreOptions options;
        options.read_only = true;
        return options;
    }());
    const database::Trace trace = database::Attempts(store).read_trace(request.session, recorder->attempt_id());
    ScoredAttempt score = score_record(request.loaded.scene, request.loaded.task, targets, trace.samples, trace.events, request.benchmark ? &*request.benchmark : nullptr);
    RunOutcome outcome;
    outcome.state_hash = engine.state_hash();
    const std::uint32_t missed = missed_program.load() + missed_scheduler.load();
    const database::AttemptResult stored = attempt_result(score, outcome, tick_count.load() * engine.scene().tick_period(), missed, lost, request.meta.limits);
    recorder->finish(stored);
    const std::lock_guard<std::mutex> lock(end_mutex);
    ui::AttemptOutcome shown;
    shown.attempt_id = recorder->attempt_id();
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
    state.world_thread = std::thread([&state] { state.run_world(); });
    state.haptic_thread = std::thread([&state] { state.run_haptic(); });
    state.recorder_thread = std::thread([&state] { state.run_recorder(); });
}

LiveAttempt::~LiveAttempt() {
    interrupt();
    wait();
}

const Scene& LiveAttempt::scene() const { return state_->engine.scene(); }
const TaskDefinition& LiveAttempt::task() const { return state_->engine.task(); }
bool LiveAttempt::assessed() const { return state_->request.assessed; }
const World& LiveAttempt::world() const { return state_->engine.world(); }

ui::AttemptPhase LiveAttempt::phase() const {
    const State& state = *state_;
    if (state.failed.load()) return ui::AttemptPhase::failed;
    if (state.finished.load()) return ui::AttemptPhase::finished;
    if (state.stop.load()) return ui::AttemptPhase::finishing;
    if (state.device_lost.load()) return ui::AttemptPhase::device_lost;
    if (state.paused.load()) return ui::AttemptPhase::paused;
    return ui::AttemptPhase::running;
}

bool LiveAttempt::update() { return state_->view.update(); }
const WorldSnapshot& LiveAttempt::snapshot() const { return state_->view.value().snapshot; }
const TaskDisplay& LiveAttempt::display() const { return state_->view.value().display; }

ui::LoopHealth LiveAttempt::health() const {
    const State& state = *state_;
    ui::LoopHealth health;
    health.ticks = state.tick_count.load();
    health.missed_ticks = state.missed_program.load() + state.missed_scheduler.load();
    health.late_steps = state.late_steps.load();
    health.lost_samples = state.world_ring.lost() + state.record_ring.lost() + state.record_world_ring.lost();
    for (int hand = 0; hand < hand_count; ++hand) health.force_felt[hand] = state.request.rig->has_force(static_cast<Hand>(hand));
    return health;
}

void LiveAttempt::pause() { state_->paused.store(true); }
void LiveAttempt::resume() {
    state_->paused.store(false);
    if (state_->device_lost.load()) state_->resume_asked.store(true);
}
void LiveAttempt::abandon() {
    state_->abandon.store(true);
    state_->paused.store(false);
}
void LiveAttempt::interrupt() {
    if (!state_->stop.exchange(true)) state_->interrupted.store(true);
}

std::string LiveAttempt::message() const {
    const State& state = *state_;
    if (state.failed.load()) {
        const std::lock_guard<std::mutex> lock(state.end_mutex);
        return state.trouble;
    }
    if (state.device_lost.load()) {
        return state.device_back.load() ? "The device is back. Bring it to where the instruments stand, then resume."
                                        : "A device does not answer. Force was taken to zero and the clock stands. Reconnect it; after a minute the attempt is closed as interrupted.";
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

const ScoredAttempt* LiveAttempt::scored() const { return state_->finished.load() ? &*state_->scored : nullptr; }
std::uint64_t LiveAttempt::state_hash() const { return state_->engine.state_hash(); }

LoopStatistics LiveAttempt::statistics() const {
    const State& state = *state_;
    LoopStatistics statistics;
    statistics.ticks = state.tick_count.load();
    statistics.missed_by_program = state.missed_program.load();
    statistics.missed_by_scheduler = state.missed_scheduler.load();
    statistics.late_steps = state.late_steps.load();
    statistics.lost_samples = state.world_ring.lost() + state.record_ring.lost() + state.record_world_ring.lost();
    statistics.wake_p50_us = state.wake.quantile(0.5);
    statistics.wake_p99_us = state.wake.quantile(0.99);
    statistics.wake_p999_us = state.wake.quantile(0.999);
    statistics.wake_worst_us = state.wake.worst();
    statistics.tick_p50_us = state.tick_time.quantile(0.5);
    statistics.tick_p99_us = state.tick_time.quantile(0.99);
    statistics.tick_worst_us = state.tick_time.worst();
    statistics.step_p50_us = state.step_time.quantile(0.5);
    statistics.step_p99_us = state.step_time.quantile(0.99);
    statistics.step_worst_us = state.step_time.worst();
    statistics.real_time_priority = state.real_time_priority.load();
    return statistics;
}

}  // namespace fulcrum::app
