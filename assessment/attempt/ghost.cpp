// SPDX-License-Identifier: Apache-2.0
#include "assessment/attempt/ghost.h"

#include <algorithm>
#include <cmath>

#include "assessment/operators/operator.h"

namespace fulcrum {
namespace {

/// Keeps nothing.
class GhostSink : public AttemptSink {
  public:
    void on_event(const Event& /*event*/) noexcept override {}
    void on_tick(const RigSample& /*input*/, const TickSample& /*sample*/) noexcept override {}
    void on_step(const StepRecord& /*step*/) noexcept override {}
};

}  // namespace

std::shared_ptr<const GhostPath> make_ghost(const Scene& scene, const TaskDefinition& task,
                                            std::uint64_t seed, const std::function<bool()>& keep_going) {
    AttemptEngine engine(scene, task, seed);
    const auto expert = make_operator(OperatorLevel::expert, task, scene, seed);
    auto path = std::make_shared<GhostPath>();
    const auto spacing = static_cast<std::uint32_t>(std::lround(GhostPath::spacing_s * scene.tick_rate));
    const auto add = [&](const WorldSnapshot& world) {
        GhostPoint point;
        std::copy_n(world.tools, hand_count, point.tools);
        point.goal = engine.display().goal;
        path->points.push_back(point);
    };
    add(engine.initial_snapshot());
    bool stopped = false;
    GhostSink sink;
    run_headless(
        engine, *expert, sink, {},
        [&] {
            if (engine.world().snapshot().tick % spacing == 0) add(engine.world().snapshot());
        },
        [&] { return stopped = !keep_going(); });
    if (stopped) return nullptr;
    return path;
}

// The farther of the two tips: an instrument that is outside has no say.
double GhostPace::distance(std::size_t point, const ToolPose (&tools)[hand_count]) const {
    double farthest = 0;
    for (int hand = 0; hand < hand_count; ++hand) {
        const ToolPose& ghost = path_->points[point].tools[hand];
        if (ghost.inside && tools[hand].inside)
            farthest = std::max(farthest, (ghost.tip - tools[hand].tip).norm());
    }
    return farthest;
}

const GhostPoint& GhostPace::follow(const ToolPose (&tools)[hand_count], std::int32_t goal) {
    const std::vector<GhostPoint>& points = path_->points;
    const auto of_goal =
        std::equal_range(points.begin(), points.end(), GhostPoint{{}, goal},
                         [](const GhostPoint& a, const GhostPoint& b) { return a.goal < b.goal; });
    if (of_goal.first == of_goal.second) return points[place_];  // the expert did without this goal
    const auto first = static_cast<std::size_t>(of_goal.first - points.begin());
    const auto last = static_cast<std::size_t>(of_goal.second - points.begin()) - 1;
    place_ = std::clamp(place_, first, last);
    std::size_t nearest = place_;
    double least = near;
    for (std::size_t i = place_; i <= std::min(last, place_ + window); ++i) {
        const double found = distance(i, tools);
        if (found > least) continue;  // of equals the last: the ghost does not wait where it rested
        least = found;
        nearest = i;
    }
    if (least >= near) {  // off the path: perhaps on a later part of it
        least = rejoin;
        for (std::size_t i = place_; i <= last; ++i) {
            const double found = distance(i, tools);
            if (found >= least) continue;
            least = found;
            nearest = i;
        }
    }
    place_ = nearest;
    return points[std::min(last, place_ + ahead)];
}

}  // namespace fulcrum
