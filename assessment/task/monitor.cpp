// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/monitor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "assessment/task/band_monitor.h"
#include "assessment/task/goal_monitor.h"
#include "assessment/task/hand_monitor.h"
#include "sim_core/instrument/device.h"
#include "sim_core/numerics/state_archive.h"
#include "sim_core/scene/perforation.h"

namespace fulcrum {
namespace {

constexpr double moving_speed = 0.005;      // m/s, docs/METRICS.md, `time`
constexpr double moving_duration = 0.2;     // s, idem
constexpr double device_grace = 60;         // s until a lost device interrupts the attempt
constexpr double regrasp_window = 2;        // s, pauses excluded
constexpr double drop_height = 0.01;        // m above rest: tissue that slips and falls less was not dropped
constexpr std::uint32_t fault_outcome = 4;  // StepRecord::outcome

constexpr int no_hand = 255;

// Depth by which two shafts overlap, m; 0 where they do not (closest points of two segments).
double shaft_overlap(const ToolPose& a, const ToolPose& b, double reach) noexcept {
    if (!a.inside || !b.inside) return 0;
    const Vector3 u = a.tip - a.trocar, v = b.tip - b.trocar, w = a.trocar - b.trocar;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
    if (uu <= 0 || vv <= 0) return 0;
    const double determinant = uu * vv - uv * uv;
    double s = determinant > 1e-12 * uu * vv ? std::clamp((uv * vw - vv * uw) / determinant, 0.0, 1.0) : 0.0;
    const double t = std::clamp((uv * s + vw) / vv, 0.0, 1.0);
    s = std::clamp((uv * t - uw) / uu, 0.0, 1.0);
    return std::max(0.0, reach - (w + s * u - t * v).norm());
}

// How a tick ends the attempt, once what its step did is reported.
struct Ending {
    bool due = false;
    EventKind kind = EventKind::interrupted;
};

// Passes events on and notes the critical ones.
class CriticalFilter : public EventSink {
  public:
    CriticalFilter(EventSink& sink, std::uint64_t kinds, bool& critical)
        : sink_(sink), kinds_(kinds), critical_(critical) {}
    void on_event(const Event& event) noexcept override {
        const auto kind = static_cast<unsigned>(event.kind);
        if (kind < 64 && (kinds_ >> kind & 1U) != 0) critical_ = true;
        sink_.on_event(event);
    }
    void emit(std::uint32_t tick, EventKind kind, std::int32_t detail = 0, double value = 0,
              int hand = no_hand, int tissue = -1) noexcept {
        Event event;
        event.tick = tick;
        event.kind = kind;
        event.hand = static_cast<std::uint8_t>(hand);
        event.tissue = static_cast<std::int8_t>(tissue);
        event.detail = detail;
        event.value = static_cast<float>(value);
        on_event(event);
    }

  private:
    EventSink& sink_;
    std::uint64_t kinds_;
    bool& critical_;
};

}  // namespace

struct TaskMonitor::State {
    TaskDefinition task;
    std::vector<TissueWatch> tissues;
    std::array<HandMonitor, hand_count> hands;
    HandMonitor scope;  // its movement alone, where the scene has no instruments
    bool scope_alone = false;
    GoalMonitor goals;
    BandMonitor bands;
    TaskDisplay display;
    double tick_period = 1e-3, tool_reach = 0.005;
    double let_fall_height = std::numeric_limits<double>::infinity();  // m above rest, of jaws that open
    std::uint64_t critical_kinds = 0;                                  // bit by EventKind

    bool fallen = false, let_fall = false;  // in this step; the second: out of jaws that opened
    bool begun = false, paused = false, lost = false, late = false, colliding = false;
    std::uint32_t unpaused_ticks = 0, elapsed_ticks = 0;  // since the beginning; since the first movement
    std::uint32_t lost_ticks = 0, late_ticks = 0, last_tick = 0;
    std::array<std::uint32_t, hand_count + 1> run_ticks{};  // the last: of the scope

    State(const TaskDefinition& definition, const Scene& scene, std::uint64_t seed)
        : task(definition), goals(definition, scene), bands(scene), tick_period(scene.tick_period()) {
        const std::vector<double> perforation = draw_perforation_forces(scene, seed);
        for (const TissueSpec& spec : scene.tissues) {
            TissueWatch watch;
            watch.force_limit = std::max(0.0, spec.force_limit) / sample_force_unit;
            watch.perforation_limit = perforation[tissues.size()] / sample_force_unit;
            watch.pressure_limit = spec.jaw_pressure_limit;
            watch.wall = scene.cavity && spec.label == scene.cavity->tissue;
            tissues.push_back(watch);
        }
        double radius[hand_count] = {0, 0};
        for (const InstrumentSpec& spec : scene.instruments)
            radius[static_cast<int>(spec.hand)] = spec.shaft_radius;
        tool_reach = radius[0] > 0 && radius[1] > 0 ? radius[0] + radius[1] : 0;
        for (int h = 0; h < hand_count; ++h) {
            hands[static_cast<std::size_t>(h)].configure(static_cast<Hand>(h), scene, &tissues,
                                                         task.warning_margin);
        }
        scope.configure(Hand::left, scene, &tissues, task.warning_margin);
        scope_alone = scene.instruments.empty();
        for (const Goal& goal : task.goals)
            if (goal.kind == GoalKind::lift_and_hold)
                let_fall_height = std::min(let_fall_height, goal.height_m);
        for (const EventKind kind :
             {EventKind::perforation, EventKind::tear, EventKind::drop, EventKind::tool_collision,
              EventKind::vessel_injury, EventKind::nerve_injury}) {
            const auto& names = task.critical_errors;
            if (std::find(names.begin(), names.end(), event_name(kind)) != names.end())
                critical_kinds |= std::uint64_t{1} << static_cast<unsigned>(kind);
        }
        display.remaining_s = task.time_limit_s;
        goals.show(display);
    }

    void end(std::uint32_t tick, EventKind kind, CriticalFilter& events) noexcept;
    /// What changed about devices, pause and the world's lateness.
    void watch_rig(const TickSample& sample, CriticalFilter& events) noexcept;
    /// Speed and work of a hand: the attempt's clock starts with the first.
    void watch_hand(std::size_t h, const TickSample& sample, CriticalFilter& events) noexcept;
    void watch_scope(const TickSample& sample, CriticalFilter& events) noexcept;
    /// Starts the clock with the first movement or work; `h`: a hand, or hand_count for the scope.
    void watch_movement(std::size_t h, double speed, bool at_work, std::uint32_t tick,
                        CriticalFilter& events) noexcept;
    /// The attempt's clock starts with this tick, or with the movement under way in it.
    void start_clock(std::size_t h, std::uint32_t tick, CriticalFilter& events) noexcept;
    /// One tick; returns true if it was not paused. `ending` is set where the attempt ends with it.
    bool tick(const TickSample& sample, const WorldSnapshot& world, Ending& ending,
              CriticalFilter& events) noexcept;
    /// A hold that a hand's step changed: whether it is a repeated grasp or a drop.
    void watch_hold(std::size_t h, HoldChange change, const WorldSnapshot& world,
                    CriticalFilter& events) noexcept;
    /// What a step did to tissue and what the hands hold after it. Returns how each hold changed.
    std::array<HoldChange, hand_count> report(const WorldSnapshot& world, CriticalFilter& events) noexcept;
    /// After the last tick of a step of which `running` ticks were not paused. `ending`: of its last tick.
    void step(const WorldSnapshot& world, std::uint32_t running, const Ending& ending,
              CriticalFilter& events) noexcept;
    void show() noexcept;
};

TaskMonitor::TaskMonitor(const TaskDefinition& task, const Scene& scene, std::uint64_t seed)
    : state_(std::make_unique<State>(task, scene, seed)) {}
TaskMonitor::~TaskMonitor() = default;

const TaskDisplay& TaskMonitor::display() const noexcept {
    return state_->display;
}

void TaskMonitor::State::end(std::uint32_t tick, EventKind kind, CriticalFilter& events) noexcept {
    bands.finish(tick, events);
    display.ended = true;
    display.end = kind;
    events.emit(tick, kind);
}

void TaskMonitor::State::watch_rig(const TickSample& sample, CriticalFilter& events) noexcept {
    const std::uint32_t tick = sample.tick;
    const bool lost_now = (sample.rig_flags & rig_device_lost) != 0;
    if (lost_now != lost) events.emit(tick, lost_now ? EventKind::device_lost : EventKind::device_back);
    lost = lost_now;
    lost_ticks = lost ? lost_ticks + 1 : 0;
    const bool paused_now = (sample.rig_flags & rig_paused) != 0;
    if (paused_now != paused) events.emit(tick, paused_now ? EventKind::pause : EventKind::resume);
    paused = paused_now;
    const bool late_now = (sample.rig_flags & rig_world_late) != 0;
    if (late && !late_now) events.emit(tick, EventKind::world_late, static_cast<std::int32_t>(late_ticks));
    late_ticks = late_now ? late_ticks + 1 : 0;
    late = late_now;
}

void TaskMonitor::State::watch_hand(std::size_t h, const TickSample& sample,
                                    CriticalFilter& events) noexcept {
    HandMonitor& hand = hands[h];
    hand.tick(sample, events);
    // A hand that holds, cuts or heats tissue, or is where the task requires it, is working, even if it moved
    // there slowly.
    const std::uint16_t flags = sample.hand[h].flags;
    const bool at_work =
        goals.at_target(static_cast<Hand>(h)) ||
        ((flags & hand_inside) != 0 && (flags & (hand_grasping | hand_cutting | hand_energy)) != 0);
    watch_movement(h, hand.speed(), at_work, sample.tick, events);
}

void TaskMonitor::State::watch_scope(const TickSample& sample, CriticalFilter& events) noexcept {
    scope.move(sample.camera.tip, true);
    watch_movement(hand_count, scope.speed(), goals.at_target(Hand::left), sample.tick, events);
}

void TaskMonitor::State::watch_movement(std::size_t h, double speed, bool at_work, std::uint32_t tick,
                                        CriticalFilter& events) noexcept {
    run_ticks[h] = speed > moving_speed ? run_ticks[h] + 1 : 0;
    if (display.moving_seen || !(at_work || run_ticks[h] * tick_period >= moving_duration)) return;
    start_clock(h, tick, events);
}

void TaskMonitor::State::start_clock(std::size_t h, std::uint32_t tick, CriticalFilter& events) noexcept {
    display.moving_seen = true;
    // The movement began earlier; only now is it long enough to count.
    const std::uint32_t age = run_ticks[h] > 0 ? run_ticks[h] - 1 : 0;
    elapsed_ticks = age;
    events.emit(tick - age, EventKind::first_movement, 0, 0, h < hand_count ? static_cast<int>(h) : no_hand);
}

bool TaskMonitor::State::tick(const TickSample& sample, const WorldSnapshot& world, Ending& ending,
                              CriticalFilter& events) noexcept {
    last_tick = sample.tick;
    watch_rig(sample, events);
    if ((sample.rig_flags & rig_abandon) != 0) {
        ending = {true, EventKind::abandoned};
        return false;
    }
    if (lost_ticks * tick_period > device_grace) {
        ending = {true, EventKind::interrupted};
        return false;
    }
    if (paused || lost) {
        run_ticks = {};
        return false;
    }
    ++unpaused_ticks;
    for (std::size_t h = 0; h < hand_count; ++h) watch_hand(h, sample, events);
    if (scope_alone) watch_scope(sample, events);
    if (display.moving_seen) ++elapsed_ticks;
    bands.tick(sample);
    goals.tick(sample, world, events);
    if (goals.done()) return true;
    // An attempt without any movement also times out; otherwise it would never end.
    const std::uint32_t clock = display.moving_seen ? elapsed_ticks : unpaused_ticks;
    if (clock * tick_period >= task.time_limit_s) ending = {true, EventKind::timed_out};
    return true;
}

void TaskMonitor::State::watch_hold(std::size_t h, HoldChange change, const WorldSnapshot& world,
                                    CriticalFilter& events) noexcept {
    const GraspState& grasp = world.grasps[h];
    if (change == HoldChange::grasped) {
        for (HandMonitor& other : hands) {
            const HandMonitor::Released& released = other.released();
            if (!hands[h].takes_again(released, grasp) ||
                (unpaused_ticks - released.clock) * tick_period > regrasp_window)
                continue;
            events.emit(last_tick, EventKind::regrasp, grasp.patch, grasp.arc_length, static_cast<int>(h),
                        grasp.tissue);
            other.forget_released();
            break;
        }
    }
    const bool slipped = change == HoldChange::slipped;
    if (!slipped && change != HoldChange::released) return;
    if (grasp.body == HeldBody::sheet || world.grasps[1 - h].held) return;
    // Jaws that open put it down; from the height of a lift they let it fall. Where both hands do so at once,
    // or one of them while it slips out of the other, it falls once.
    const double height = goals.height(world, grasp);
    if (slipped ? let_fall || height <= drop_height : fallen || height < let_fall_height) return;
    fallen = true;
    let_fall = let_fall || !slipped;
    events.emit(last_tick, EventKind::drop, grasp.patch, grasp.arc_length, static_cast<int>(h), grasp.tissue);
}

std::array<HoldChange, hand_count> TaskMonitor::State::report(const WorldSnapshot& world,
                                                              CriticalFilter& events) noexcept {
    const std::uint32_t now = last_tick;
    const auto happened = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(0, world.event_count)), 0,
                                                  world.events.size());
    for (std::size_t i = 0; i < happened; ++i) {
        events.on_event(world.events[i]);
        goals.tissue_event(world.events[i]);
    }
    bands.step(world, now, events);
    // A clip is work too, of which only the step tells: its last tick is the first that counts.
    for (std::size_t h = 0; h < hand_count; ++h) {
        if (display.moving_seen || !bands.clipped(static_cast<int>(h))) continue;
        start_clock(h, now, events);
        ++elapsed_ticks;
    }
    goals.bands(bands);
    fallen = let_fall = false;
    std::array<HoldChange, hand_count> changes{};
    for (std::size_t h = 0; h < hand_count; ++h) {
        changes[h] = hands[h].hold(world.grasps[h], now, unpaused_ticks, events);
        watch_hold(h, changes[h], world, events);
    }
    const double overlap = shaft_overlap(world.tools[0], world.tools[1], tool_reach);
    if (overlap > 0 && !colliding) events.emit(now, EventKind::tool_collision, 0, overlap);
    colliding = overlap > 0;
    return changes;
}

void TaskMonitor::State::step(const WorldSnapshot& world, std::uint32_t running, const Ending& ending,
                              CriticalFilter& events) noexcept {
    const std::uint32_t now = last_tick;
    const std::array<HoldChange, hand_count> changes = report(world, events);
    // A goal that this step reaches counts, though the time is up with it; not one after the attempt was
    // left.
    const bool left = ending.due && ending.kind != EventKind::timed_out;
    if (running > 0 && !left && !goals.done()) goals.step(world, changes, now, running, events);
    const bool fault = world.outcome == fault_outcome;
    if (fault) events.emit(now, EventKind::simulator_fault, static_cast<std::int32_t>(world.outcome));
    if (left) {
        end(now, ending.kind, events);
    } else if (fault) {
        end(now, EventKind::interrupted, events);
    } else if (goals.done()) {
        end(now, EventKind::completed, events);
    } else if (ending.due) {
        end(now, ending.kind, events);
    }
}

void TaskMonitor::State::show() noexcept {
    display.elapsed_s = elapsed_ticks * tick_period;
    display.remaining_s = std::max(0.0, task.time_limit_s - display.elapsed_s);
    for (std::size_t h = 0; h < hand_count; ++h) {
        display.force[h] = static_cast<float>(hands[h].step_force());
        display.force_limit[h] = static_cast<float>(hands[h].force_limit());
        display.warning[h] = hands[h].warning();
    }
    display.bands_divided = bands.divided();
    display.bands_torn = bands.torn();
    display.vessels_dry = bands.dry();
    display.blood_ml = static_cast<float>(bands.lost_ml());
    display.clips_left = bands.clips_left();
    goals.show(display);
}

void TaskMonitor::transfer(StateArchive& archive) {
    State& s = *state_;
    archive(s.hands, s.scope, s.bands, s.display, s.begun, s.paused, s.lost, s.late, s.colliding,
            s.unpaused_ticks, s.elapsed_ticks, s.lost_ticks, s.late_ticks, s.last_tick, s.run_ticks);
    s.goals.transfer(archive);
}

void TaskMonitor::begin_again() noexcept {
    State& state = *state_;
    state.begun = state.display.moving_seen = state.paused = state.lost = state.late = false;
    state.unpaused_ticks = state.elapsed_ticks = state.lost_ticks = state.late_ticks = 0;
    state.run_ticks = {};
    for (HandMonitor& hand : state.hands) hand.forget_released();
    state.display.critical = false;  // that of the attempt before
    state.show();
}

void TaskMonitor::on_step(const TickSample* ticks, std::size_t count, const WorldSnapshot& world,
                          EventSink& sink) noexcept {
    State& state = *state_;
    if (state.display.ended || count == 0) return;
    CriticalFilter events(sink, state.critical_kinds, state.display.critical);
    if (!state.begun) {
        state.begun = true;
        events.emit(ticks[0].tick, EventKind::attempt_begin);
        state.goals.report_begun(ticks[0].tick, events);
    }
    for (HandMonitor& hand : state.hands) hand.begin_step();
    std::uint32_t running = 0;
    Ending ending;
    for (std::size_t i = 0; i < count; ++i) {
        running += state.tick(ticks[i], world, ending, events) ? 1U : 0U;
        if (ending.due || state.goals.done()) break;
    }
    state.step(world, running, ending, events);
    state.show();
}

}  // namespace fulcrum
