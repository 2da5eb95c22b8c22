// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/monitor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "assessment/task/band_monitor.h"
#include "assessment/task/goal_monitor.h"
#include "assessment/task/hand_monitor.h"
#include "sim_core/instrument/device.h"
#include "sim_core/scene/perforation.h"

namespace fulcrum {
namespace {

constexpr double moving_speed = 0.005;      // m/s, docs/METRICS.md, `time`
constexpr double moving_duration = 0.2;     // s, idem
constexpr double device_grace = 60;         // s until a lost device interrupts the attempt
constexpr double regrasp_window = 2;        // s
constexpr double drop_height = 0.01;        // m above rest: tissue that falls less was not dropped
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

}  // namespace

struct TaskMonitor::State {
    TaskDefinition task;
    std::vector<TissueWatch> tissues;
    std::array<HandMonitor, hand_count> hands;
    GoalMonitor goals;
    BandMonitor bands;
    TaskDisplay display;
    double tick_period = 1e-3, tool_reach = 0.005;
    std::uint64_t critical_kinds = 0;  // bit by EventKind
    int held_tissue = -1;

    bool begun = false, paused = false, lost = false, late = false, colliding = false;
    std::uint32_t unpaused_ticks = 0, elapsed_ticks = 0;  // since the beginning; since the first movement
    std::uint32_t lost_ticks = 0, late_ticks = 0, last_tick = 0;
    std::array<std::uint32_t, hand_count> run_ticks{}, run_start{};

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
        if (scene.bowel) held_tissue = scene.tissue_index(scene.bowel->tissue);
        if (scene.sheet) held_tissue = scene.tissue_index(scene.sheet->tissue);
        if (scene.bands) held_tissue = scene.tissue_index(scene.bands->tissue);
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
};

namespace {

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

TaskMonitor::TaskMonitor(const TaskDefinition& task, const Scene& scene, std::uint64_t seed)
    : state_(std::make_unique<State>(task, scene, seed)) {}
TaskMonitor::~TaskMonitor() = default;

const TaskDisplay& TaskMonitor::display() const noexcept {
    return state_->display;
}

void TaskMonitor::on_step(const TickSample* ticks, std::size_t count, const WorldSnapshot& world,
                          EventSink& sink) noexcept {
    State& state = *state_;
    TaskDisplay& display = state.display;
    if (display.ended || count == 0) return;
    CriticalFilter events(sink, state.critical_kinds, display.critical);
    const auto end = [&](std::uint32_t tick, EventKind kind) {
        state.bands.finish(tick, events);
        display.ended = true;
        display.end = kind;
        events.emit(tick, kind);
    };
    if (!state.begun) {
        state.begun = true;
        events.emit(ticks[0].tick, EventKind::attempt_begin);
    }
    for (HandMonitor& hand : state.hands) hand.begin_step();

    std::uint32_t running = 0;  // ticks of this step that were not paused
    for (std::size_t i = 0; i < count && !display.ended; ++i) {
        const TickSample& sample = ticks[i];
        const std::uint32_t tick = sample.tick;
        state.last_tick = tick;

        const bool lost = (sample.rig_flags & rig_device_lost) != 0;
        if (lost != state.lost) events.emit(tick, lost ? EventKind::device_lost : EventKind::device_back);
        state.lost = lost;
        state.lost_ticks = lost ? state.lost_ticks + 1 : 0;
        const bool paused = (sample.rig_flags & rig_paused) != 0;
        if (paused != state.paused) events.emit(tick, paused ? EventKind::pause : EventKind::resume);
        state.paused = paused;
        const bool late = (sample.rig_flags & rig_world_late) != 0;
        if (state.late && !late)
            events.emit(tick, EventKind::world_late, static_cast<std::int32_t>(state.late_ticks));
        state.late_ticks = late ? state.late_ticks + 1 : 0;
        state.late = late;

        if ((sample.rig_flags & rig_abandon) != 0) {
            end(tick, EventKind::abandoned);
            break;
        }
        if (state.lost_ticks * state.tick_period > device_grace) {
            end(tick, EventKind::interrupted);
            break;
        }
        if (paused || lost) {
            state.run_ticks = {};
            continue;
        }
        ++running;
        ++state.unpaused_ticks;
        for (std::size_t h = 0; h < hand_count; ++h) {
            HandMonitor& hand = state.hands[h];
            hand.tick(sample, events);
            if (hand.speed() > moving_speed) {
                if (state.run_ticks[h]++ == 0) state.run_start[h] = state.unpaused_ticks;
            } else {
                state.run_ticks[h] = 0;
            }
            // Who holds, cuts or burns tissue, or is where the task wants the hand, is at work, however
            // haltingly the hand came there.
            const std::uint16_t flags = sample.hand[h].flags;
            const bool at_work =
                state.goals.at_target(static_cast<Hand>(h)) ||
                ((flags & hand_inside) != 0 && (flags & (hand_grasping | hand_cutting | hand_energy)) != 0);
            if (!display.moving_seen &&
                (at_work || state.run_ticks[h] * state.tick_period >= moving_duration)) {
                display.moving_seen = true;
                // The run began when it began; that it was a run is known only now.
                const std::uint32_t age = state.run_ticks[h] > 0 ? state.run_ticks[h] - 1 : 0;
                state.elapsed_ticks = age;
                events.emit(tick - age, EventKind::first_movement, 0, 0, static_cast<int>(h));
            }
        }
        if (display.moving_seen) ++state.elapsed_ticks;
        state.bands.tick(sample);
        state.goals.tick(sample, world, events);
        if (state.goals.done()) break;
        // Who never moves is timed out as well, or an attempt without hands would never end.
        const std::uint32_t clock = display.moving_seen ? state.elapsed_ticks : state.unpaused_ticks;
        if (clock * state.tick_period >= state.task.time_limit_s) end(tick, EventKind::timed_out);
    }

    const std::uint32_t now = state.last_tick;
    if (!display.ended) {
        const auto happened = std::clamp<std::size_t>(
            static_cast<std::size_t>(std::max(0, world.event_count)), 0, world.events.size());
        for (std::size_t i = 0; i < happened; ++i) {
            events.on_event(world.events[i]);
            state.goals.tissue_event(world.events[i]);
        }
        state.bands.step(world, now, events);
        state.goals.bands(state.bands);
        std::array<HoldChange, hand_count> changes{};
        for (std::size_t h = 0; h < hand_count; ++h) {
            const GraspState& grasp = world.grasps[h];
            changes[h] = state.hands[h].hold(grasp, now, static_cast<std::int8_t>(state.held_tissue), events);
            if (changes[h] == HoldChange::grasped) {
                for (HandMonitor& other : state.hands) {
                    const HandMonitor::Released& released = other.released();
                    if (!released.valid || released.patch != grasp.patch ||
                        (now - released.tick) * state.tick_period > regrasp_window)
                        continue;
                    events.emit(now, EventKind::regrasp, grasp.patch, grasp.arc_length, static_cast<int>(h),
                                state.held_tissue);
                    other.forget_released();
                    break;
                }
            }
            if (changes[h] == HoldChange::slipped && !world.grasps[1 - h].held &&
                state.goals.height(world, grasp) > drop_height) {
                events.emit(now, EventKind::drop, grasp.patch, grasp.arc_length, static_cast<int>(h),
                            state.held_tissue);
            }
        }
        const double overlap = shaft_overlap(world.tools[0], world.tools[1], state.tool_reach);
        if (overlap > 0 && !state.colliding) events.emit(now, EventKind::tool_collision, 0, overlap);
        state.colliding = overlap > 0;
        if (running > 0 && !state.goals.done()) state.goals.step(world, changes, now, running, events);
        if (world.outcome == fault_outcome) {
            events.emit(now, EventKind::simulator_fault, static_cast<std::int32_t>(world.outcome));
            end(now, EventKind::interrupted);
        } else if (state.goals.done()) {
            end(now, EventKind::completed);
        }
    }

    display.elapsed_s = state.elapsed_ticks * state.tick_period;
    display.remaining_s = std::max(0.0, state.task.time_limit_s - display.elapsed_s);
    for (std::size_t h = 0; h < hand_count; ++h) {
        display.force[h] = static_cast<float>(state.hands[h].step_force());
        display.force_limit[h] = static_cast<float>(state.hands[h].force_limit());
        display.warning[h] = state.hands[h].warning();
    }
    display.bands_divided = state.bands.divided();
    display.vessels_dry = state.bands.dry();
    display.blood_ml = static_cast<float>(state.bands.lost_ml());
    display.clips_left = state.bands.clips_left();
    state.goals.show(display);
}

}  // namespace fulcrum
