// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/device_watch.h"

#include <algorithm>
#include <cmath>

#include "sim_core/haptics/clutch.h"

namespace fulcrum::app {
namespace {

constexpr double pi = 3.14159265358979323846;

Vector3 handle_of(const DeviceSample& sample) {
    return device_length_unit * Vector3(sample.handle[0], sample.handle[1], sample.handle[2]);
}

/// Angle between two directions, rad; 0 where one has no length.
double angle_between(const Vector3& a, const Vector3& b) {
    const double lengths = a.norm() * b.norm();
    return lengths > 0 ? std::acos(std::clamp(a.dot(b) / lengths, -1.0, 1.0)) : 0.0;
}

}  // namespace

void DeviceWatch::begin_from(const DeviceSample& left, const DeviceSample& right) noexcept {
    held_[0] = left;
    held_[1] = right;
    seen_ = was_held_ = true;  // as HapticLoop::clutch_in()
}

void DeviceWatch::lose(DeviceTrouble trouble, int culprit) noexcept {
    lost_ = true;
    trouble_ = trouble;
    culprit_ = culprit;
    lost_for_ = steady_ = 0;
}

std::uint32_t DeviceWatch::tick(const RigSample& sample, bool paused, bool resume) noexcept {
    const DeviceSample* devices[3] = {&sample.hand[0], &sample.hand[1], &sample.camera};
    bool usable = true;
    for (int i = 0; i < 3; ++i) {
        const bool present = devices[i]->present != 0, faulty = devices[i]->faulty != 0;
        silent_[i] = present ? 0 : silent_[i] + 1;
        usable = usable && present && !faulty;
        if (lost_) continue;
        if (faulty) {
            lose(DeviceTrouble::impossible_reading, i);
        } else if (silent_[i] > limits_.silent_ticks) {
            lose(DeviceTrouble::silent, i);
        }
    }
    if (lost_) {
        ++lost_for_;
        steady_ = usable ? steady_ + 1 : 0;
    }
    follow(sample, paused || lost_);
    if (lost_ && resume && in_place()) {
        lost_ = false;
        went_on_ = true;
        follow(sample, paused);
    }
    return lost_ ? static_cast<std::uint32_t>(rig_device_lost) : 0U;
}

void DeviceWatch::follow(const RigSample& sample, bool on_hold) noexcept {
    for (int h = 0; h < hand_count; ++h) {
        const DeviceSample& device = sample.hand[h];
        std::int32_t(&offset)[4] = offset_[h];
        DeviceSample& held = held_[h];
        if (!on_hold && was_held_) {  // the clutch: the same computation as in HapticLoop
            for (int i = 0; i < 3; ++i) offset[i] = clutch_offset(held.handle[i], device.handle[i]);
            offset[3] = clutch_offset(held.roll, device.roll);
        }
        HandAlignment& alignment = hand_[h];
        alignment.device = device;
        for (int i = 0; i < 3; ++i)
            alignment.device.handle[i] = clutched(alignment.device.handle[i], offset[i]);
        alignment.device.roll = clutched(alignment.device.roll, offset[3]);
        if (!on_hold || !seen_) held = alignment.device;
        const Vector3 stands = handle_of(held), is = handle_of(alignment.device);
        alignment.distance = (is - stands).norm();
        const double turned = std::remainder(
            device_angle_unit * (static_cast<double>(alignment.device.roll) - held.roll), 2 * pi);
        alignment.angle = std::max(angle_between(stands, is), std::abs(turned));
        alignment.in_place = alignment.distance <= limits_.distance && alignment.angle <= limits_.angle;
    }
    seen_ = true;
    was_held_ = on_hold;
}

Sentence loss_of(DeviceTrouble trouble, int culprit) {
    const Sentence device = culprit == 0   ? QT_TRANSLATE_NOOP("errors", "The left hand's device")
                            : culprit == 1 ? QT_TRANSLATE_NOOP("errors", "The right hand's device")
                                           : QT_TRANSLATE_NOOP("errors", "The scope's device");
    const Sentence what =
        trouble == DeviceTrouble::impossible_reading
            ? Sentence(
                  QT_TRANSLATE_NOOP("errors", "%1 gave an impossible reading (not a number, or a jump)."),
                  device)
            : Sentence(QT_TRANSLATE_NOOP("errors", "%1 does not answer."), device);
    return {
        QT_TRANSLATE_NOOP("errors",
                          "%1 The force was reduced to zero and the timer is stopped; the recording is kept. "
                          "Reconnect the device: within one minute the attempt can resume as practice, "
                          "after that it is closed as interrupted. An attempt that had already failed "
                          "stays failed."),
        what};
}

}  // namespace fulcrum::app
