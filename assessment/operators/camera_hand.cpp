// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/camera_hand.h"

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double middle_share = 0.7;  // of the image's half angle: beyond it the scope is re-aimed
constexpr double aim_s = 0.9;         // for a steady hand

}  // namespace

CameraHand::CameraHand(const Skill& skill, const Scene& scene)
    : period_(scene.tick_period()), duration_(aim_s * skill.duration_scale) {
    if (!scene.camera) return;
    present_ = true;
    scope_ = make_scope(*scene.camera);
    insertion_ = scene.camera->start_insertion;
    limit_ = 0.5 * middle_share * scene.camera->field_of_view;
    from_ = to_ = scope_.trocar.rotation.col(2);
    renew(from_);
}

void CameraHand::renew(const Vector3& axis) noexcept {
    DeviceReading reading;
    reading.handle = handle_for_tip(scope_.trocar, scope_.trocar.position + insertion_ * axis);
    sample_ = quantise(reading, sample_);
    pose_ = scope_pose(scope_, sample_);
    view_ = view_direction(pose_);
}

void CameraHand::look_at(const Vector3& point) noexcept {
    if (!present_ || progress_ < 1) return;
    const Vector3 wanted = (point - pose_.position).normalized();
    if (math::acos(wanted.dot(view_)) < limit_) return;
    // Turning the scope about its trocar turns the line of sight with it.
    from_ = to_;
    to_ = (Quaternion::FromTwoVectors(view_, wanted) * from_).normalized();
    progress_ = 0;
}

DeviceSample CameraHand::tick() noexcept {
    if (!present_ || progress_ >= 1) return sample_;
    progress_ = progress_ + period_ / duration_;
    const double t = progress_ < 1 ? progress_ : 1;
    const double share = t * t * t * (10 + t * (-15 + 6 * t));
    renew(((1 - share) * from_ + share * to_).normalized());
    return sample_;
}

}  // namespace fulcrum
