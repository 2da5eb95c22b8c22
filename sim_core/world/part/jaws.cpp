// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/part/jaws.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double close_share = 0.35,
                 open_share = 0.45;       // of the widest opening: between taking and letting go
constexpr double least_grip = 0.2;        // N: weaker jaws take nothing; they let go at half of it
constexpr double correction_time = 0.06;  // s: the tissue is drawn into the jaws in this time
constexpr double fastest_hold = 2.0;      // m/s: a device that jumps does not tear the tissue along
constexpr double slip_delay = 0.02;       // s of overload before the tissue leaves the jaws

double opening_of(const ToolKinematics& tool, double widest) {
    return tool.jaw_angle / std::max(1e-9, widest);
}

bool closed(double opening, const ToolKinematics& tool) {
    return opening < close_share && tool.grip > least_grip && tool.inside;
}

}  // namespace

bool Jaws::closing(const ToolKinematics& tool, double widest) const noexcept {
    return tool.present && !held_ && ready_ && closed(opening_of(tool, widest), tool);
}

bool Jaws::may_hold(const ToolKinematics& tool, double widest) noexcept {
    return tool.jaw_angle < open_share * widest;
}

JawAction Jaws::step(const ToolKinematics& tool, double widest, const JawLoad& load, double dt) noexcept {
    if (!tool.present) return JawAction::none;
    const double opening = opening_of(tool, widest);
    if (opening > open_share) ready_ = true;
    if (!held_) {
        if (!ready_ || !closed(opening, tool)) return JawAction::none;
        ready_ = false;
        return JawAction::close;
    }
    slip_time_ = load.reaction > 2.0 * load.friction * tool.grip ? slip_time_ + dt : 0.0;
    slipped_ = slip_time_ > slip_delay || load.lost;
    if (!slipped_ && !(opening > open_share) && !(tool.grip <= 0.5 * least_grip) && tool.inside)
        return JawAction::hold;
    held_ = false;
    return JawAction::let_go;
}

void Jaws::add_point(const Vector3& offset, const Vector3& jaws, const Vector3& point) noexcept {
    Point& added = points_[static_cast<std::size_t>(count_++)];
    added.offset = offset;
    added.correction = point - jaws;
    added.target = added.last = point;
}

void Jaws::take() noexcept {
    held_ = true;
    slipped_ = false;
    slip_time_ = 0;
    velocity_.setZero();
}

void Jaws::carry(const ToolKinematics& tool, double dt) noexcept {
    const double longest = fastest_hold * dt;
    for (int i = 0; i < count_; ++i) {
        Point& held = points_[static_cast<std::size_t>(i)];
        held.correction *= std::max(0.0, 1.0 - dt / correction_time);
        Vector3 motion = tool.tip + tool.rotation * held.offset + held.correction - held.target;
        if (motion.norm() > longest) motion *= longest / motion.norm();
        held.last = held.target;
        held.target += motion;
        if (i == 0) velocity_ = motion / dt;
    }
}

void Jaws::drop_point(int index) noexcept {
    std::move(points_.begin() + index + 1, points_.begin() + count_, points_.begin() + index);
    --count_;
}

void Jaws::lose() noexcept {
    held_ = false;
    slipped_ = true;
}

void Jaws::fill(GraspModel& model) const noexcept {
    // The correction is the tissue's own way to the jaws.
    model.point = points_[0].target - points_[0].correction;
    model.velocity = velocity_;
    model.hold_offset = points_[0].offset;
}

}  // namespace fulcrum
