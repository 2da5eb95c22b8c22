// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/part/jaws.h"

#include <algorithm>

#include "sim_core/contact/jaws.h"

namespace fulcrum {
namespace {

constexpr double close_share = 0.35,
                 open_share = 0.45;       // of the widest opening: between taking and letting go
constexpr double least_grip = 0.2;        // N: weaker jaws take nothing; they let go at half of it
constexpr double correction_time = 0.06;  // s: the tissue is drawn into the jaws in this time
constexpr double fastest_hold = 2.0;      // m/s: a device that jumps does not tear the tissue along

double opening_of(const ToolKinematics& tool, double widest) {
    return tool.jaw_angle / std::max(1e-9, widest);
}

bool closed(double opening, const ToolKinematics& tool) {
    return opening < close_share && tool.grip > least_grip;
}

}  // namespace

bool Jaws::closing(const ToolKinematics& tool, double widest) const noexcept {
    return tool.present && tool.inside && !held_ && ready_ && closed(opening_of(tool, widest), tool);
}

bool Jaws::may_hold(const ToolKinematics& tool, double widest) noexcept {
    return tool.jaw_angle < open_share * widest;
}

JawAction Jaws::step(const ToolKinematics& tool, double widest, bool lost) noexcept {
    if (!tool.present) {  // what they hold stays where it is
        for (Point& point : points_) point.last = point.target;
        velocity_.setZero();
        return JawAction::none;
    }
    const double opening = opening_of(tool, widest);
    if (opening > open_share) ready_ = true;
    if (!held_) {
        if (!ready_ || !closed(opening, tool)) return JawAction::none;
        ready_ = false;
        return tool.inside ? JawAction::close : JawAction::none;  // outside the body: on nothing
    }
    slipped_ = out_ || lost;
    if (!slipped_ && !(opening > open_share) && !(tool.grip <= 0.5 * least_grip) && tool.inside)
        return JawAction::hold;
    held_ = false;
    return JawAction::let_go;
}

void Jaws::add_point(const Vector3& offset, const Vector3& jaws, const Vector3& point) noexcept {
    Point& added = points_[static_cast<std::size_t>(count_++)];
    added.offset = offset;
    added.slid.setZero();
    added.correction = point - jaws;
    added.target = added.last = point;
}

// With which spring and friction each point is held.
void Jaws::press(const ToolKinematics& tool, const HeldTissue& held) noexcept {
    const double points = std::max(1, count_);
    stiffness_ = pinch_share * held.stiffness / points;
    most_ = jaw_capacity(tool.grip, held.friction) / points;
}

void Jaws::take(const ToolKinematics& tool, const HeldTissue& held, double area) noexcept {
    press(tool, held);
    area_ = area;
    held_ = true;
    slipped_ = out_ = false;
    velocity_.setZero();
}

void Jaws::carry(const ToolKinematics& tool, const HeldTissue& held, const Vector3* tissue, double jaw_length,
                 double dt) noexcept {
    press(tool, held);
    const double longest = fastest_hold * dt;
    const double stretch = stiffness_ > 0 ? most_ / stiffness_ : 0.0;  // m, at which the tissue slides
    for (int i = 0; i < count_; ++i) {
        Point& point = points_[static_cast<std::size_t>(i)];
        point.correction *= std::max(0.0, 1.0 - dt / correction_time);
        Vector3 motion = tool.tip + tool.rotation * point.offset + point.correction - point.target;
        if (motion.norm() > longest) motion *= longest / motion.norm();
        point.last = point.target;
        point.target += motion;
        if (i == 0) velocity_ = motion / dt;
        const Vector3 pulled = point.target - tissue[i];
        const double size = pulled.norm();
        if (!(size > stretch)) continue;
        const Vector3 slide = pulled * (1 - stretch / size), in_jaws = tool.rotation.transpose() * slide;
        point.target -= slide;
        point.offset -= in_jaws;
        point.slid -= in_jaws;
        out_ = out_ || point.slid.norm() > 0.5 * jaw_length + margin;
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
    model.area = area_;
}

}  // namespace fulcrum
