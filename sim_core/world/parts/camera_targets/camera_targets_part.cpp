// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/camera_targets/camera_targets_part.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double apart = 0.001;  // m: a contact ends at this distance, so that it is counted once

double distance_to_segment(const Vector3& point, const Vector3& from, const Vector3& to) noexcept {
    const Vector3 along = to - from;
    const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - from - share * along).norm();
}

}  // namespace

CameraTargetsPart::CameraTargetsPart(const Scene& scene, std::uint64_t seed)
    : spec_(*scene.camera_targets),
      scope_(make_scope(*scene.camera)),
      path_(draw_tip_path(spec_, seed)),
      cups_(place_camera_targets(scene, seed)),
      tissue_(scene.tissue_index(spec_.tissue)) {}

double CameraTargetsPart::lens_distance(const Vector3& lens) const noexcept {
    double least = (lens - path_.at(time_)).norm() - spec_.ball_radius;
    for (const CameraTarget& cup : cups_) {
        const Vector3 bottom = cup.ball - spec_.ball_radius * cup.axis;
        least = std::min(least, distance_to_segment(lens, bottom, cup.mouth) - spec_.cup_radius - spec_.wall);
    }
    return least - spec_.lens_radius;
}

void CameraTargetsPart::apply(const StepInput& input) noexcept {
    time_ += input.dt;
    const double distance = lens_distance(scope_pose(scope_, input.last().input.camera).position);
    if (touching_ == 0 && distance < 0) {
        touching_ = 1;
        events_.add(input.tick(), EventKind::lens_contact, -1, tissue_, -distance, 0);
    } else if (distance > apart) {
        touching_ = 0;
    }
}

void CameraTargetsPart::size_snapshot(WorldSnapshot& snapshot) const {
    CameraTargetsView& view = snapshot.camera_targets;
    view.targets = cups_;
    view.ball_radius = spec_.ball_radius;
    view.cup_radius = spec_.cup_radius;
    view.wall = spec_.wall;
    view.cup_depth = spec_.cup_depth;
    view.distance = spec_.distance;
    for (const CameraTarget& cup : cups_)
        snapshot.targets.push_back({cup.ball, spec_.ball_radius, Hand::right});
    snapshot.targets.push_back({path_.at(0), spec_.ball_radius, Hand::right});
    StepEvents<2>::size(snapshot);
}

void CameraTargetsPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    snapshot.camera_targets.tip = path_.at(time_);
    snapshot.camera_targets.tip_velocity = path_.velocity(time_);
    snapshot.targets.back().centre = snapshot.camera_targets.tip;
    events_.append_to(snapshot);
}

void CameraTargetsPart::list_state(StateList& list) {
    list.hashed(time_);
    list.hashed(touching_);
}

void CameraTargetsPart::add_costs(double us, std::vector<PartCost>& costs) const {
    costs.push_back({"camera_targets", us, cups_.capacity() * sizeof(CameraTarget)});
}

std::unique_ptr<Part> build_camera_targets_part(const Scene& scene, std::uint64_t seed,
                                                const PartList& /*parts*/) {
    return scene.camera_targets ? std::make_unique<CameraTargetsPart>(scene, seed) : nullptr;
}

}  // namespace fulcrum
