// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/mouse_mapping.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double widest_tilt = 1.2;     // rad from the nominal shaft
constexpr double least_inside = 0.005;  // m of insertion

// Follow rates at one tick of 1 ms: 1 - exp(-2 pi 12 Hz 1 ms), and the same at 6 Hz for the jaws.
constexpr double follow_rate = 0.07262, jaw_rate = 0.03700;

}  // namespace

DeviceReading start_reading(double shaft_length, double insertion, double jaw) {
    DeviceReading reading;
    reading.handle = Vector3(0, 0, -(shaft_length - insertion));
    reading.jaw = jaw;
    return reading;
}

void shift_handle(DeviceReading& reading, const Trocar& trocar, const Vector3& shift) {
    const double outside = reading.handle.norm();
    const Vector3 along = reading.handle / outside;
    Vector3 step = trocar.rotation.transpose() * shift;
    step -= along * along.dot(step);
    Vector3 moved = reading.handle + step;
    moved *= outside / moved.norm();
    const double across = std::sqrt(moved.x() * moved.x() + moved.y() * moved.y());
    if (-moved.z() < math::cos(widest_tilt) * outside) {
        const double scale = math::sin(widest_tilt) * outside / across;
        moved = Vector3(moved.x() * scale, moved.y() * scale, -math::cos(widest_tilt) * outside);
    }
    reading.handle = moved;
}

void insert_handle(DeviceReading& reading, const Trocar& trocar, double depth) {
    const double outside = reading.handle.norm();
    const double wanted =
        std::clamp(outside - depth, handle_clearance + 0.01, trocar.shaft_length - least_inside);
    reading.handle *= wanted / outside;
}

HandleFollower::HandleFollower(const DeviceReading& start)
    : target_(start),
      line_(start.handle),
      first_(start.handle),
      second_(start.handle),
      roll_(start.roll),
      jaw_(start.jaw),
      grip_(start.grip) {
    // The first reading is the start itself, not a jump from the origin.
    last_ = quantise(start, last_);
}

void HandleFollower::aim(const DeviceReading& target, int ticks) {
    target_ = target;
    ramp_ = std::max(0, ticks);
    line_step_ = (target.handle - line_) / (ramp_ + 1);
}

DeviceSample HandleFollower::tick() {
    line_ = ramp_ > 0 ? Vector3(line_ + line_step_) : target_.handle;
    if (ramp_ > 0) --ramp_;
    first_ += follow_rate * (line_ - first_);
    second_ += follow_rate * (first_ - second_);
    roll_ += follow_rate * (target_.roll - roll_);
    jaw_ += jaw_rate * (target_.jaw - jaw_);
    grip_ += jaw_rate * (target_.grip - grip_);
    DeviceReading reading = target_;
    reading.handle = second_;
    reading.roll = roll_;
    reading.jaw = jaw_;
    reading.grip = grip_;
    last_ = quantise(reading, last_);
    return last_;
}

}  // namespace fulcrum
