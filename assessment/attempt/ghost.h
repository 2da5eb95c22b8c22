// SPDX-License-Identifier: Apache-2.0
// The instruments of an expert's attempt, shown during practice at the trainee's pace. It reads the world and
// changes nothing of it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "assessment/attempt/engine.h"

namespace fulcrum {

struct GhostPoint {
    ToolPose tools[hand_count];
    std::int32_t goal = 0;  ///< under way
};

/// Constant once made; any thread. Points 20 ms apart, goals ascending, not empty.
struct GhostPath {
    static constexpr double spacing_s = 0.02;
    std::vector<GhostPoint> points;
};

/// The expert operator performs the task with this seed, as fast as possible. `keep_going` is asked before
/// every step; null where it said no. Throws InputError where scene and task do not fit together.
std::shared_ptr<const GhostPath> make_ghost(const Scene& scene, const TaskDefinition& task,
                                            std::uint64_t seed, const std::function<bool()>& keep_going);

/// Where on its path the ghost is: a little ahead of the way-point nearest to the trainee's instruments,
/// within the trainee's goal. It goes forward only, and waits where the trainee is not near its path.
class GhostPace {
  public:
    static constexpr int ahead = 30;      ///< points that it is ahead of the trainee: 0.6 s
    static constexpr int window = 50;     ///< points within which the nearest one is looked for: 1 s
    static constexpr double near = 0.02;  ///< m, largest distance of a tip from a point that counts as there
    static constexpr double rejoin = 0.008;  ///< m, from a later point, to leave out what is before it

    explicit GhostPace(std::shared_ptr<const GhostPath> path) : path_(std::move(path)) {}
    /// The ghost for the trainee's instruments and goal now.
    const GhostPoint& follow(const ToolPose (&tools)[hand_count], std::int32_t goal);
    /// Index of the nearest way-point so far.
    std::size_t place() const { return place_; }

  private:
    double distance(std::size_t point, const ToolPose (&tools)[hand_count]) const;
    std::shared_ptr<const GhostPath> path_;
    std::size_t place_ = 0;
};

}  // namespace fulcrum
