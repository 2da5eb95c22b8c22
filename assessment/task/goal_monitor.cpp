// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/goal_monitor.h"

#include <algorithm>

#include "assessment/task/bowel_line.h"
#include "assessment/task/specimen_plan.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

std::optional<GoalFault> goal_fault(const Goal& goal, const Scene& scene) {
    const GoalType& type = type_of(goal.kind);
    const auto lacks = [&](const Sentence& problem, const Sentence& hint) {
        return GoalFault{"", problem, hint};
    };
    switch (type.site) {
        case GoalSite::targets:
            if (!scene.targets)
                return lacks(
                    {QT_TRANSLATE_NOOP("errors", "the scene \"%1\" has no targets to touch"), scene.id},
                    QT_TRANSLATE_NOOP("errors", "add \"targets\" to the scene or name another scene"));
            break;
        case GoalSite::bowel:
            if (!scene.bowel)
                return lacks({QT_TRANSLATE_NOOP("errors", "the scene \"%1\" has no bowel"), scene.id},
                             QT_TRANSLATE_NOOP("errors", "add \"bowel\" to the scene or name another scene"));
            break;
        case GoalSite::sheet:
            if (!scene.sheet && !scene.septa)
                return lacks(
                    {QT_TRANSLATE_NOOP("errors", "the scene \"%1\" has no sheet to divide"), scene.id},
                    QT_TRANSLATE_NOOP("errors",
                                      "add \"sheet\" or \"septa\" to the scene or name another scene"));
            break;
        case GoalSite::bands:
            if (!scene.bands)
                return lacks({QT_TRANSLATE_NOOP("errors", "the scene \"%1\" has no bands"), scene.id},
                             QT_TRANSLATE_NOOP("errors", "add \"bands\" to the scene or name another scene"));
            break;
        case GoalSite::objects:
            if (!scene.objects)
                return lacks(
                    {QT_TRANSLATE_NOOP("errors", "the scene \"%1\" has no objects to hand over"), scene.id},
                    QT_TRANSLATE_NOOP("errors", "add \"objects\" to the scene or name another scene"));
            break;
        case GoalSite::camera_targets:
            if (!scene.camera_targets)
                return lacks(
                    {QT_TRANSLATE_NOOP("errors", "the scene \"%1\" has no targets for the camera"), scene.id},
                    QT_TRANSLATE_NOOP("errors", "add \"camera_targets\" to the scene or name another scene"));
            break;
    }
    return type.suits == nullptr ? std::nullopt : type.suits(goal, scene);
}

GoalWatch::GoalWatch(const TaskDefinition& task, const Scene& scene)
    : cut(task, scene), tick_period(scene.tick_period()), warning_margin(task.warning_margin) {
    for (const InstrumentSpec& spec : scene.instruments)
        tip_radius[static_cast<std::size_t>(spec.hand)] = spec.tip_radius;
    if (!scene.bowel) return;
    rest_heights.assign(static_cast<std::size_t>(scene.bowel->segments) + 1, 0.0);
    bowel_tissue = scene.tissue_index(scene.bowel->tissue);
}

double GoalWatch::height(const WorldSnapshot& world, const GraspState& grasp) const noexcept {
    const std::size_t count =
        std::min({world.bowel.nodes.size(), world.bowel.node_arc_lengths.size(), rest_heights.size()});
    if (count < 2) return 0;
    std::size_t upper = 1;
    while (upper + 1 < count && world.bowel.node_arc_lengths[upper] < grasp.arc_length) ++upper;
    const double before = world.bowel.node_arc_lengths[upper - 1],
                 after = world.bowel.node_arc_lengths[upper];
    const double share =
        after > before ? std::clamp((grasp.arc_length - before) / (after - before), 0.0, 1.0) : 0.0;
    const double rest = rest_heights[upper - 1] + share * (rest_heights[upper] - rest_heights[upper - 1]);
    return line_point(world, grasp.arc_length).position.z() - rest;
}

GoalMonitor::GoalMonitor(const TaskDefinition& task, const Scene& scene) : goals_(task.goals) {
    for (std::size_t i = 0; i < goals_.size(); ++i) {
        if (const std::optional<GoalFault> fault = goal_fault(goals_[i], scene))
            throw InputError(task.id,
                             "/goals/" + std::to_string(i) + (fault->key.empty() ? "" : "/") + fault->key,
                             fault->problem, fault->hint);
    }
    make_specimen_plan(scene, task);  // refuses what the report could not be made of
    watch_ = std::make_unique<GoalWatch>(task, scene);
    for (const Goal& goal : goals_) trackers_.push_back(type_of(goal.kind).tracker(goal, *watch_));
}

void GoalMonitor::begin_goal(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept {
    begun_ = true;
    if (done()) return;
    GoalEvents events(sink, tick, goal_);
    events.phase(EventKind::phase_begin);
    tracker().begin(world, events);
}

void GoalMonitor::end_goal(const WorldSnapshot& world, std::uint32_t tick, EventSink& sink) noexcept {
    GoalEvents(sink, tick, goal_).phase(EventKind::phase_end);
    ++goal_;
    begin_goal(world, tick, sink);
}

void GoalMonitor::tick(const TickSample& sample, const WorldSnapshot& world, EventSink& sink) noexcept {
    if (!begun_) begin_goal(world, sample.tick, sink);
    if (done()) return;
    GoalEvents events(sink, sample.tick, goal_);
    if (tracker().tick(sample, world, events)) end_goal(world, sample.tick, sink);
}

void GoalMonitor::step(const WorldSnapshot& world, const std::array<HoldChange, hand_count>& changes,
                       std::uint32_t tick, std::uint32_t ticks, EventSink& sink) noexcept {
    for (const HoldChange change : changes) grasped_ever_ = grasped_ever_ || change == HoldChange::grasped;
    if (!grasped_ever_) {  // the bowel may still be settling; its last state before the first contact is its
                           // rest
        const std::size_t count = std::min(watch_->rest_heights.size(), world.bowel.nodes.size());
        for (std::size_t i = 0; i < count; ++i) watch_->rest_heights[i] = world.bowel.nodes[i].z();
    }
    watch_->cut.look(world);
    if (done()) return;
    GoalEvents events(sink, tick, goal_);
    if (tracker().step({world, changes, ticks}, events)) end_goal(world, tick, sink);
}

void GoalMonitor::show(TaskDisplay& display) const noexcept {
    const CutMonitor& cut = watch_->cut;
    display.goal = std::min(goal_, static_cast<int>(goals_.size()) - 1);
    display.active_target = -1;
    display.goal_progress = done() ? 1.0 : 0.0;
    display.hold_progress = 0;
    display.lift_height_m = 0;
    display.rings_placed = 0;
    display.framing = {};
    display.framing_faults = 0;
    display.run_covered_m = display.run_next_m = 0;
    display.cut_divided_m = cut.divided();
    display.cut_torn_m = cut.torn();
    display.cut_next_m = cut.next();
    display.cut_distance_m = cut.distance();
    display.traction_n_m = cut.traction();
    display.cutting = cut.cutting();
    display.traction_warning = 0;
    display.distance_warning = false;
    if (!done()) tracker().show(display);
}

}  // namespace fulcrum
