// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/device.h"

#include <cmath>

namespace fulcrum {
namespace {

constexpr double jump_limit = 0.2;  // m between two ticks: 200 m/s, impossible for a hand

// Rounds to counts; the caller has checked that the value is finite.
std::int32_t to_counts(double value, double unit) {
    const double counts = value / unit;
    constexpr double limit = 2.0e9;
    return static_cast<std::int32_t>(
        std::lround(counts > limit ? limit : (counts < -limit ? -limit : counts)));
}

}  // namespace

bool is_usable(const RigUse& use) {
    const auto rate = [](double hz) { return hz >= 0 && hz <= 1e6; };
    for (const int part : use.part)
        if (part < -1 || part > 2) return false;
    return rate(use.stated) && rate(use.measured) && use.motion >= 0.01 && use.motion <= 100 &&
           use.pedal >= -2 && use.pedal <= 2;
}

bool is_usable(const ForceOutput& output) {
    const double values[] = {output.damping,   output.peak,   output.continuous,
                             output.stiffness, output.torque, output.scale};
    for (const double value : values) {
        if (!std::isfinite(value) || value < 0) return false;
    }
    return output.continuous <= output.peak && output.scale > 0 && output.slew > 0;
}

std::optional<ForceOutput> Rig::force_output(Hand hand) const {
    if (!has_force(hand) || !(damping(hand) >= 0)) return std::nullopt;
    ForceOutput output;
    output.damping = damping(hand);
    return output;
}

DeviceSample quantise(const DeviceReading& reading, const DeviceSample& previous) {
    DeviceSample sample = previous;
    sample.faulty = 0;
    sample.present = reading.present ? 1 : 0;
    if (!reading.present) return sample;
    bool usable = reading.handle.allFinite() && std::isfinite(reading.roll) && std::isfinite(reading.jaw) &&
                  std::isfinite(reading.grip);
    if (usable) {
        const Vector3 before(previous.handle[0], previous.handle[1], previous.handle[2]);
        const bool first = before.isZero();
        usable = first || (reading.handle - device_length_unit * before).norm() <= jump_limit;
    }
    if (!usable) {
        sample.faulty = 1;
        return sample;
    }
    for (int i = 0; i < 3; ++i) sample.handle[i] = to_counts(reading.handle[i], device_length_unit);
    sample.roll = to_counts(reading.roll, device_angle_unit);
    sample.jaw = to_counts(reading.jaw, device_angle_unit);  // of a scope it may be negative
    sample.grip = to_counts(reading.grip < 0 ? 0 : reading.grip, device_force_unit);
    sample.buttons = reading.buttons;
    return sample;
}

}  // namespace fulcrum
