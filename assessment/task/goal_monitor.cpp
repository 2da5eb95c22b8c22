// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/goal_monitor.h"

#include <algorithm>
#include <cmath>

#include "assessment/task/bowel_line.h"
#include "assessment/task/specimen_plan.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr double touch_tolerance =
    0.001;  // m, beyond contact, so that a light touch's own tremor does not end a hold
constexpr double run_tolerance = 0.02;  // m, how far past the frontier a hold may begin without a partner
constexpr double hand_over_slack =
    0.005;  // m, on the shortest and longest step: half a jaw's width is nobody's fault

double sign_of(const Goal& goal) {
    return goal.to_m >= goal.from_m ? 1.0 : -1.0;
}

void emit(EventSink& sink, std::uint32_t tick, EventKind kind, int hand, std::int32_t detail,
          double value) noexcept {
    Event event;
    event.tick = tick;
    event.kind = kind;
    event.hand = static_cast<std::uint8_t>(hand);
    event.detail = detail;
    event.value = static_cast<float>(value);
    sink.on_event(event);
}

constexpr int no_hand = 255;
constexpr double line_end_slack =
    0.002;  // m of the line that may stay: a bridge that the flap's own weight parts

bool is_bands_goal(GoalKind kind) {
    return kind == GoalKind::divide_bands || kind == GoalKind::stop_bleeding;
}

bool is_cut_goal(GoalKind kind) {
    return kind == GoalKind::take_tension || kind == GoalKind::divide_line || kind == GoalKind::let_go;
}

}  // namespace

GoalMonitor::GoalMonitor(const TaskDefinition& task, const Scene& scene)
    : goals_(task.goals),
      tick_period_(scene.tick_period()),
      cut_(task, scene),
      warning_margin_(task.warning_margin) {
    for (const InstrumentSpec& spec : scene.instruments)
        tip_radius_[static_cast<std::size_t>(spec.hand)] = spec.tip_radius;
    const auto refuse = [&](std::size_t i, const std::string& wrong, const std::string& hint) {
        throw InputError(task.id, "/goals/" + std::to_string(i), wrong, hint);
    };
    for (std::size_t i = 0; i < goals_.size(); ++i) {
        const Goal& goal = goals_[i];
        if (goal.kind == GoalKind::touch_targets) {
            if (!scene.targets)
                refuse(i, "the scene \"" + scene.id + "\" has no targets to touch",
                       "add \"targets\" to the scene or name another scene");
            if (scene.instrument(goal.hand) == nullptr) {
                refuse(i, std::string("the scene gives the ") + hand_name(goal.hand) + " hand no instrument",
                       "add one to the scene");
            }
            if (goal.count > scene.targets->per_hand) {
                refuse(i, "the goal asks for more targets than the scene has for a hand",
                       "lower \"count\" or raise \"per_hand\" of the scene");
            }
        } else if (is_cut_goal(goal.kind)) {
            if (!scene.sheet && !scene.septa)
                refuse(i, "the scene \"" + scene.id + "\" has no sheet to divide",
                       "add \"sheet\" or \"septa\" to the scene or name another scene");
            if (goal.length_m > marked_line(scene) + 1e-9)
                refuse(i, "the goal asks for more than the marked line's length",
                       "lower \"length_m\" or raise \"line_length\" of the scene");
        } else if (is_bands_goal(goal.kind)) {
            if (!scene.bands)
                refuse(i, "the scene \"" + scene.id + "\" has no bands",
                       "add \"bands\" to the scene or name another scene");
            if (goal.count >
                (goal.kind == GoalKind::divide_bands ? scene.bands->count : scene.bands->vessels)) {
                refuse(i, "the goal asks for more bands or vessels than the scene has",
                       "lower \"count\" or raise the scene's");
            }
        } else {
            if (!scene.bowel)
                refuse(i, "the scene \"" + scene.id + "\" has no bowel",
                       "add \"bowel\" to the scene or name another scene");
            if (std::max(goal.from_m, goal.to_m) > scene.bowel->length) {
                refuse(i, "the goal reaches beyond the bowel's end",
                       "keep from_m and to_m below the bowel's length");
            }
        }
    }
    make_specimen_plan(scene, task);  // refuses what the report could not be made of
    if (scene.bowel) rest_heights_.assign(static_cast<std::size_t>(scene.bowel->segments) + 1, 0.0);
}

void GoalMonitor::begin_goal(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept {
    begun_ = true;
    reached_ = 0;
    target_ = -1;
    hold_ticks_ = 0;
    covered_ = run_next_ = 0;
    lift_height_ = 0;
    counted_ = 0;
    if (done()) return;
    emit(sink, tick, EventKind::phase_begin, no_hand, goal_, 0);
    if (goal().kind == GoalKind::touch_targets) show_target(world, tick, sink);
}

void GoalMonitor::end_goal(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept {
    emit(sink, tick, EventKind::phase_end, no_hand, goal_, 0);
    ++goal_;
    begin_goal(world, tick, sink);
}

void GoalMonitor::progress(double value, std::uint32_t tick, EventSink& sink) noexcept {
    emit(sink, tick, EventKind::goal_progress, no_hand, goal_, value);
}

void GoalMonitor::show_target(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept {
    hold_ticks_ = 0;
    target_ = -1;
    int of_hand = 0;
    for (std::size_t i = 0; i < world.targets.size(); ++i) {
        if (world.targets[i].hand != goal().hand) continue;
        if (of_hand++ == reached_) {
            target_ = static_cast<std::int32_t>(i);
            emit(sink, tick, EventKind::target_shown, static_cast<int>(goal().hand), target_, 0);
            return;
        }
    }
}

void GoalMonitor::tick(const TickSample& sample, const WorldSnapshot& world, EventSink& sink) noexcept {
    if (!begun_) begin_goal(world, sample.tick, sink);
    if (done() || goal().kind != GoalKind::touch_targets || target_ < 0) return;
    const auto hand_index = static_cast<std::size_t>(goal().hand);
    const HandSample& hand = sample.hand[hand_index];
    const TargetSphere& target = world.targets[static_cast<std::size_t>(target_)];
    const Vector3 tip = sample_length_unit * Vector3(hand.tip[0], hand.tip[1], hand.tip[2]);
    const double reach = target.radius + tip_radius_[hand_index] + touch_tolerance;
    const bool touching = (hand.flags & hand_inside) != 0 && (tip - target.centre).norm() <= reach;
    hold_ticks_ = touching ? hold_ticks_ + 1 : 0;
    if (hold_ticks_ * tick_period_ < goal().hold_s) return;
    emit(sink, sample.tick, EventKind::target_reached, static_cast<int>(goal().hand), target_, 0);
    ++reached_;
    progress(reached_, sample.tick, sink);
    if (reached_ >= goal().count) {
        end_goal(world, sample.tick, sink);
    } else {
        show_target(world, sample.tick, sink);
    }
}

double GoalMonitor::height(const WorldSnapshot& world, const GraspState& grasp) const noexcept {
    const std::size_t count =
        std::min({world.nodes.size(), world.node_arc_lengths.size(), rest_heights_.size()});
    if (count < 2) return 0;
    std::size_t upper = 1;
    while (upper + 1 < count && world.node_arc_lengths[upper] < grasp.arc_length) ++upper;
    const double before = world.node_arc_lengths[upper - 1], after = world.node_arc_lengths[upper];
    const double share =
        after > before ? std::clamp((grasp.arc_length - before) / (after - before), 0.0, 1.0) : 0.0;
    const double rest = rest_heights_[upper - 1] + share * (rest_heights_[upper] - rest_heights_[upper - 1]);
    return line_point(world, grasp.arc_length).position.z() - rest;
}

void GoalMonitor::step_run(const WorldSnapshot& world, const std::array<HoldChange, hand_count>& changes,
                           std::uint32_t tick, EventSink& sink) noexcept {
    const double direction = sign_of(goal());
    for (std::size_t hand = 0; hand < hand_count; ++hand) {
        if (changes[hand] != HoldChange::grasped) continue;
        const GraspState& grasp = world.grasps[hand];
        const GraspState& partner = world.grasps[1 - hand];
        const double place = direction * (grasp.arc_length - goal().from_m);
        if (!partner.held || changes[1 - hand] == HoldChange::grasped)
            continue;  // a hold without a partner is only a start
        const double partner_place = direction * (partner.arc_length - goal().from_m);
        const double step = place - partner_place;
        const bool counts = partner_place <= covered_ + run_tolerance &&
                            step >= goal().minimum_step_m - hand_over_slack &&
                            step <= goal().maximum_step_m + hand_over_slack;
        if (!counts || place <= covered_) continue;
        covered_ = std::min(place, goal().length_m);
        progress(covered_, tick, sink);
    }
    // Where the next grasp belongs: a step beyond the hand that holds, or back at the frontier if none holds
    // where it counts.
    run_next_ = covered_;
    for (const GraspState& grasp : world.grasps) {
        const double place = direction * (grasp.arc_length - goal().from_m);
        if (!grasp.held || place > covered_ + run_tolerance || place + goal().maximum_step_m < covered_)
            continue;
        const double step = 0.5 * (goal().minimum_step_m + goal().maximum_step_m);
        run_next_ = std::max(run_next_, std::min(place + goal().maximum_step_m,
                                                 std::max(place + step, covered_ + run_tolerance)));
    }
    if (covered_ >= goal().length_m - 1e-9) end_goal(world, tick, sink);
}

void GoalMonitor::step_lift(const WorldSnapshot& world, std::uint32_t tick, std::uint32_t ticks,
                            EventSink& sink) noexcept {
    lift_height_ = 0;
    bool holding = false;
    for (const GraspState& grasp : world.grasps) {
        if (!grasp.held || grasp.arc_length < goal().from_m || grasp.arc_length > goal().to_m) continue;
        holding = true;
        lift_height_ = std::max(lift_height_, height(world, grasp));
    }
    const auto whole_seconds = [&] { return static_cast<int>(hold_ticks_ * tick_period_ + 1e-9); };
    const int before = whole_seconds();
    hold_ticks_ = holding && lift_height_ >= goal().height_m ? hold_ticks_ + ticks : 0;
    if (whole_seconds() / 5 > before / 5) progress(whole_seconds(), tick, sink);
    if (hold_ticks_ * tick_period_ >= goal().hold_s) end_goal(world, tick, sink);
}

void GoalMonitor::step_tension(const WorldSnapshot& world, std::uint32_t tick, std::uint32_t ticks,
                               EventSink& sink) noexcept {
    const bool holding = world.grasps[0].held || world.grasps[1].held;
    const bool taut = holding && cut_.fault(goal(), 0) == TractionFault::none;
    hold_ticks_ = taut ? hold_ticks_ + ticks : 0;
    // Who has divided everything has nothing left to put under tension.
    const bool divided = cut_.line() && cut_.next() + line_end_slack >= cut_.length();
    if (hold_ticks_ * tick_period_ >= goal().hold_s || divided) end_goal(world, tick, sink);
}

void GoalMonitor::step_divide(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept {
    const auto millimetres = static_cast<int>(cut_.divided() * 1e3 + 1e-9);
    if (millimetres > millimetres_) progress(cut_.divided(), tick, sink);
    millimetres_ = std::max(millimetres, millimetres_);
    if (cut_.next() + line_end_slack >= goal().length_m) end_goal(world, tick, sink);
}

void GoalMonitor::step_let_go(const WorldSnapshot& world, std::uint32_t tick, std::uint32_t ticks,
                              EventSink& sink) noexcept {
    const bool free = !world.grasps[0].held && !world.grasps[1].held && !cut_.cutting();
    hold_ticks_ = free ? hold_ticks_ + ticks : 0;
    if (hold_ticks_ * tick_period_ >= goal().hold_s) end_goal(world, tick, sink);
}

void GoalMonitor::step_bands(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept {
    if (bands_divided_ > counted_) progress(bands_divided_, tick, sink);
    counted_ = std::max(counted_, bands_divided_);
    if (bands_divided_ >= goal().count) end_goal(world, tick, sink);
}

void GoalMonitor::step_bleeding(const WorldSnapshot& world, std::uint32_t tick, std::uint32_t ticks,
                                EventSink& sink) noexcept {
    if (vessels_dry_ != counted_) progress(vessels_dry_, tick, sink);
    counted_ = vessels_dry_;
    hold_ticks_ = vessels_dry_ >= goal().count ? hold_ticks_ + ticks : 0;
    if (hold_ticks_ * tick_period_ >= goal().hold_s) end_goal(world, tick, sink);
}

void GoalMonitor::step(const WorldSnapshot& world, const std::array<HoldChange, hand_count>& changes,
                       std::uint32_t tick, std::uint32_t ticks, EventSink& sink) noexcept {
    for (const HoldChange change : changes) grasped_ever_ = grasped_ever_ || change == HoldChange::grasped;
    if (!grasped_ever_) {  // the bowel may still be settling; what it was like before it was touched is its
                           // rest
        const std::size_t count = std::min(rest_heights_.size(), world.nodes.size());
        for (std::size_t i = 0; i < count; ++i) rest_heights_[i] = world.nodes[i].z();
    }
    cut_.look(world);
    if (done()) return;
    if (goal().kind == GoalKind::run_bowel) {
        step_run(world, changes, tick, sink);
    } else if (goal().kind == GoalKind::lift_and_hold) {
        step_lift(world, tick, ticks, sink);
    } else if (goal().kind == GoalKind::take_tension) {
        step_tension(world, tick, ticks, sink);
    } else if (goal().kind == GoalKind::divide_line) {
        step_divide(world, tick, sink);
    } else if (goal().kind == GoalKind::let_go) {
        step_let_go(world, tick, ticks, sink);
    } else if (goal().kind == GoalKind::divide_bands) {
        step_bands(world, tick, sink);
    } else if (goal().kind == GoalKind::stop_bleeding) {
        step_bleeding(world, tick, ticks, sink);
    }
}

void GoalMonitor::show(TaskDisplay& display) const noexcept {
    display.goal = std::min(goal_, static_cast<int>(goals_.size()) - 1);
    display.active_target = -1;
    display.goal_progress = done() ? 1.0 : 0.0;
    display.hold_progress = 0;
    display.lift_height_m = lift_height_;
    display.run_covered_m = display.run_next_m = 0;
    display.cut_divided_m = cut_.divided();
    display.cut_next_m = cut_.next();
    display.cut_distance_m = cut_.distance();
    display.traction_n_m = cut_.traction();
    display.cutting = cut_.cutting();
    display.traction_warning = 0;
    display.distance_warning = false;
    if (done()) return;
    if (goal().kind == GoalKind::divide_line && warning_margin_ >= 0) {
        // Slack tissue is wrong only while it is cut; too much traction tears whatever the blade does.
        const TractionFault fault = cut_.fault(goal(), warning_margin_);
        if (fault == TractionFault::tight || cut_.cutting())
            display.traction_warning = static_cast<std::int8_t>(fault);
        display.distance_warning =
            cut_.cutting() && std::abs(cut_.distance()) > goal().tolerance_m * (1 + warning_margin_);
    }
    const double held = goal().hold_s > 0 ? std::min(1.0, hold_ticks_ * tick_period_ / goal().hold_s) : 0.0;
    switch (goal().kind) {
        case GoalKind::touch_targets:
            display.active_target = target_;
            display.goal_progress = static_cast<double>(reached_) / goal().count;
            display.hold_progress = held;
            break;
        case GoalKind::run_bowel:
            display.goal_progress = covered_ / goal().length_m;
            display.run_covered_m = covered_;
            display.run_next_m = goal().from_m + sign_of(goal()) * run_next_;
            break;
        case GoalKind::lift_and_hold:
        case GoalKind::take_tension:
        case GoalKind::let_go:
            display.goal_progress = held;
            display.hold_progress = held;
            break;
        case GoalKind::divide_bands:
            display.goal_progress = std::min(1.0, static_cast<double>(bands_divided_) / goal().count);
            break;
        case GoalKind::stop_bleeding:
            display.goal_progress = std::min(1.0, static_cast<double>(vessels_dry_) / goal().count);
            display.hold_progress = held;
            break;
        case GoalKind::divide_line:
            display.goal_progress = std::min(1.0, cut_.divided() / goal().length_m);
            break;
    }
}

}  // namespace fulcrum
