// SPDX-License-Identifier: Apache-2.0
// frame_targets: each ball is seen into its cup, in the middle of the image, level and at its size, for a
// while. follow_tip: the moving tip is kept there, for a time in all.
#include <algorithm>
#include <cmath>

#include "assessment/task/goal_tracker.h"
#include "sim_core/instrument/framing.h"

namespace fulcrum {
namespace {

constexpr double radians = 3.14159265358979323846 / 180;  // in a degree

Vector3 lens_of(const CameraSample& camera) {
    return sample_length_unit * Vector3(camera.tip[0], camera.tip[1], camera.tip[2]);
}

CameraPose pose_of(const CameraSample& camera) {
    CameraPose pose;
    pose.position = lens_of(camera);
    const auto& q = camera.orientation;
    pose.orientation = Quaternion(sample_axis_unit * q[0], sample_axis_unit * q[1], sample_axis_unit * q[2],
                                  sample_axis_unit * q[3])
                           .normalized();
    return pose;
}

class FramingTracker : public GoalTracker {
  public:
    using GoalTracker::GoalTracker;

    bool at_target(Hand /*hand*/) const noexcept override { return hold_ticks_ > 0; }

    void transfer(StateArchive& archive) override {
        GoalTracker::transfer(archive);
        archive(framing_, faults_);
    }

  protected:
    /// Looks at a point and notes what keeps it from being framed; true where nothing does.
    bool look(const CameraPose& camera, const Vector3& point, double distance, bool hidden) noexcept {
        framing_ = frame_of(camera, point, distance, Vector3::UnitZ());
        unsigned faults = hidden ? framing_hidden : 0;
        if (framing_.off_centre > radians * goal_.centre_deg) faults |= framing_off_centre;
        if (framing_.size < 1 - goal_.size_share) faults |= framing_too_far;
        if (framing_.size > 1 + goal_.size_share) faults |= framing_too_near;
        if (std::abs(framing_.horizon) > radians * goal_.horizon_deg) faults |= framing_tilted;
        faults_ = static_cast<std::uint8_t>(faults);
        return faults == 0;
    }
    void show_framing(TaskDisplay& display) const noexcept {
        display.framing = framing_;
        display.framing_faults = faults_;
    }

  private:
    Framing framing_;
    std::uint8_t faults_ = 0;
};

class TargetFraming : public FramingTracker {
  public:
    using FramingTracker::FramingTracker;

    void begin(const WorldSnapshot& /*world*/, GoalEvents& events) noexcept override {
        events.target(EventKind::target_shown, 0);
    }

    bool tick(const TickSample& sample, const WorldSnapshot& world, GoalEvents& events) noexcept override {
        const CameraTargetsView& view = world.camera_targets;
        if (framed_ >= static_cast<int>(view.targets.size())) return false;
        const CameraTarget& target = view.targets[static_cast<std::size_t>(framed_)];
        const CameraPose camera = pose_of(sample.camera);
        const bool hidden = !view.looks_into(target, camera.position);
        if (!hold(look(camera, target.ball, view.distance, hidden), 1)) return false;
        hold_ticks_ = 0;
        events.target(EventKind::target_reached, framed_);
        events.progress(++framed_);
        if (framed_ >= goal_.count) return true;
        events.target(EventKind::target_shown, framed_);
        return false;
    }

    void show(TaskDisplay& display) const noexcept override {
        display.active_target = framed_;
        display.goal_progress = static_cast<double>(framed_) / goal_.count;
        display.hold_progress = held_share();
        show_framing(display);
    }

    void transfer(StateArchive& archive) override {
        FramingTracker::transfer(archive);
        archive(framed_);
    }

  private:
    int framed_ = 0;
};

class TipFollowing : public FramingTracker {
  public:
    using FramingTracker::FramingTracker;

    void begin(const WorldSnapshot& world, GoalEvents& events) noexcept override {
        tip_ = static_cast<std::int32_t>(world.camera_targets.targets.size());
        events.target(EventKind::target_shown, tip_);
    }

    bool tick(const TickSample& sample, const WorldSnapshot& world, GoalEvents& events) noexcept override {
        const CameraTargetsView& view = world.camera_targets;
        framed_ = look(pose_of(sample.camera), view.tip, view.distance, false);
        if (!framed_) {
            ++lost_ticks_;
            return false;
        }
        // The way to the tip at the beginning is a loss as any other: it is said even where it took no time.
        if (lost_ticks_ > 0 || hold_ticks_ == 0) events.target(EventKind::target_lost, tip_, lost_s());
        lost_ticks_ = 0;
        ++hold_ticks_;
        const auto seconds = static_cast<int>(held_s() + 0.5 * watch_.tick_period);
        if (seconds > shown_s_) events.progress(shown_s_ = seconds);
        if (held_s() < goal_.hold_s) return false;
        events.target(EventKind::target_reached, tip_);
        return true;
    }

    bool at_target(Hand /*hand*/) const noexcept override { return framed_; }

    void show(TaskDisplay& display) const noexcept override {
        display.active_target = tip_;
        display.goal_progress = held_share();
        show_framing(display);
    }

    void transfer(StateArchive& archive) override {
        FramingTracker::transfer(archive);
        archive(tip_, lost_ticks_, shown_s_, framed_);
    }

  private:
    double lost_s() const noexcept { return lost_ticks_ * watch_.tick_period; }

    std::int32_t tip_ = -1;
    std::uint32_t lost_ticks_ = 0;
    int shown_s_ = 0;
    bool framed_ = false;
};

}  // namespace

namespace goals {

std::unique_ptr<GoalTracker> track_framing(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<TargetFraming>(goal, watch);
}

std::unique_ptr<GoalTracker> track_tip(const Goal& goal, const GoalWatch& watch) {
    return std::make_unique<TipFollowing>(goal, watch);
}

std::optional<GoalFault> check_framing(const Goal& goal) {
    if (goal.size_share >= 1)
        return GoalFault{
            "size_share",
            QT_TRANSLATE_NOOP("errors", "the target has a size within this share at every distance"),
            QT_TRANSLATE_NOOP("errors", "give less than 1, such as 0.2")};
    return std::nullopt;
}

std::optional<GoalFault> camera_targets_suit(const Goal& goal, const Scene& scene) {
    if (goal.count > scene.camera_targets->count)
        return GoalFault{
            "count", QT_TRANSLATE_NOOP("errors", "the goal asks for more targets than the scene has"),
            QT_TRANSLATE_NOOP("errors", "lower \"count\" or raise \"count\" of the scene's camera_targets")};
    return std::nullopt;
}

}  // namespace goals
}  // namespace fulcrum
