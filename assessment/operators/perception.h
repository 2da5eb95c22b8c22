// SPDX-License-Identifier: Apache-2.0
// The views of the last reaction time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "assessment/task/monitor.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum {

/// One look at the scene.
struct Perception {
    std::uint32_t tick = 0;
    bool valid = false;
    Vector3 tip[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    GraspState grasps[hand_count];
    TaskDisplay display;
    std::vector<Vector3> line, flap;  ///< marked line and free edge of a sheet
    // Scene::bands or Scene::structures; empty without.
    std::vector<BandView> bands;
    std::vector<OutletView> outlets;
    std::vector<Vector3> nerve;
    HandToolView tools[hand_count];
    double smoke = 0;
    std::vector<ObjectView> objects;  ///< rings on a tray; empty without
    Vector3 lens = Vector3::Zero();   ///< m, of the scope
    Vector3 moving_tip = Vector3::Zero(),
            moving_tip_velocity = Vector3::Zero();  ///< m, m/s; Scene::camera_targets
    std::vector<Vector3>
        nodes;  ///< bowel centre line; arc lengths do not change and are stored with the line
};

/// The outlet that bleeds most; -1: none bleeds.
inline int worst_outlet(const Perception& seen) noexcept {
    int worst = -1;
    double flow = 0;
    for (std::size_t i = 0; i < seen.outlets.size(); ++i) {
        if (seen.outlets[i].flow <= flow) continue;
        flow = seen.outlets[i].flow;
        worst = static_cast<int>(i);
    }
    return worst;
}

/// Keeps the last views; allocates memory only when the scene is set.
class DelayLine {
  public:
    DelayLine(const Scene& scene, double longest_delay_s);
    void push(std::uint32_t tick, const WorldSnapshot& world, const TaskDisplay& display) noexcept;
    /// The newest view that is at least `delay` ticks old at `now`, or else the oldest.
    const Perception& seen(std::uint32_t now, std::uint32_t delay) const noexcept;
    bool empty() const noexcept { return count_ == 0; }
    const std::vector<double>& arc_lengths() const noexcept { return arc_lengths_; }
    const std::vector<double>& line_positions() const noexcept { return line_positions_; }
    const std::vector<TargetSphere>& targets() const noexcept { return targets_; }
    /// Pegs, tray and shape of the rings; its rings' places are those of the first look.
    const ObjectsView& tray() const noexcept { return tray_; }
    /// Cups and balls; its tip's place is that of the first look.
    const CameraTargetsView& camera_targets() const noexcept { return camera_targets_; }

  private:
    std::vector<Perception> looks_;
    std::vector<double> arc_lengths_, line_positions_;
    std::vector<TargetSphere> targets_;
    ObjectsView tray_;
    CameraTargetsView camera_targets_;
    std::size_t next_ = 0, count_ = 0;
};

}  // namespace fulcrum
