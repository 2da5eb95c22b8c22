// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/scope_limb.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double shortest_turn_s = 0.25, turn_s_per_rad = 0.45;

/// The scope as a limb holds an instrument.
InstrumentSpec held(const CameraSpec& camera) {
    InstrumentSpec spec;
    spec.trocar = camera.trocar;
    spec.start_insertion = camera.start_insertion;
    return spec;
}

double minimum_jerk(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * t * (10 + t * (-15 + 6 * t));
}

}  // namespace

ScopeLimb::ScopeLimb(const Skill& skill, const CameraSpec& camera, double tick_period, const Random& random)
    : lens_(skill, held(camera), tick_period, random),
      model_(make_scope(camera)),
      period_(tick_period),
      pace_(skill.duration_scale) {}

double ScopeLimb::Turn::at(double time) const noexcept {
    return duration > 0 ? from + minimum_jerk((time - begin) / duration) * (to - from) : to;
}

void ScopeLimb::Turn::start(double angle, double now, double pace) noexcept {
    from = at(now);
    to = angle;
    begin = now;
    duration = pace * (shortest_turn_s + turn_s_per_rad * std::abs(to - from));
}

DeviceSample ScopeLimb::tick() noexcept {
    time_ += period_;
    lens_.tick();
    DeviceReading reading;
    reading.handle = handle_for_tip(lens_.trocar(), lens_.tip());
    reading.roll = post_.at(time_);
    reading.jaw = head_.at(time_);
    last_ = quantise(reading, last_);
    return last_;
}

CameraPose ScopeLimb::pose(const Vector3& lens, double post, double head) const noexcept {
    DeviceReading reading;
    reading.handle = handle_for_tip(model_.trocar, lens);
    reading.roll = post;
    reading.jaw = head;
    return scope_pose(model_, quantise(reading, {}));
}

}  // namespace fulcrum
