// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/virtual_device.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum::hapticd {

PathPoint ScriptedPath::at(double time) const noexcept {
    if (points.empty()) return {};
    const double first = points.front().time, length = points.back().time - first;
    if (repeat && length > 0 && time > first) time = first + std::fmod(time - first, length);
    const auto after = std::upper_bound(points.begin(), points.end(), time,
                                        [](double t, const PathPoint& point) { return t < point.time; });
    if (after == points.begin()) return points.front();
    if (after == points.end()) return points.back();
    const PathPoint &a = *(after - 1), &b = *after;
    const double share = (time - a.time) / (b.time - a.time);
    PathPoint now = a;
    now.time = time;
    now.position += share * (b.position - a.position);
    now.roll += share * (b.roll - a.roll);
    now.jaw += share * (b.jaw - a.jaw);
    return now;
}

DeviceScript read_script(const std::string& specification) {
    const std::size_t colon = specification.find(':');
    if (colon == std::string::npos) refuse_kind(specification);
    return read_device_script(specification.substr(colon + 1));
}

VirtualDevice::VirtualDevice(DeviceScript script) : script_(std::move(script)) {
    for (int h = 0; h < 2; ++h) {
        if (const auto& hand = script_.slots[h].hand) hands_[h].hand = *hand;
        hands_[h].hand.arm = true;
        hands_[h].place = script_.slots[h].path.at(0).position;
    }
}

void VirtualDevice::read(std::int64_t now, DevicePose (&poses)[device_slots]) noexcept {
    if (begun_ == 0) begun_ = before_ = now;
    const double time = static_cast<double>(now - begun_) * 1e-9;
    // A process that was held up does not make the simulated hand jump.
    const double period = std::clamp(static_cast<double>(now - before_) * 1e-9, 0.0, 4e-3);
    before_ = now;
    ++sequence_;
    if (pushed_ == 0 && !(rendered_[0].isZero(0) && rendered_[1].isZero(0))) pushed_ = now;
    const double since_force = pushed_ != 0 ? static_cast<double>(now - pushed_) * 1e-9 : -1;
    const ScriptedFault* fault = nullptr;
    for (const ScriptedFault& one : script_.faults) {
        const double at = one.after_force ? since_force : time;
        if (at >= one.time && at < one.time + one.length) fault = &one;
    }
    for (int i = 0; i < device_slots; ++i) {
        DevicePose& pose = poses[i];
        const PathPoint wanted = script_.slots[i].path.at(time);
        Vector3 place = wanted.position;
        if (i < 2 && script_.slots[i].hand) {
            hands_[i].wanted = wanted.position;
            hands_[i].step(rendered_[i], period);
            place = hands_[i].place;
        }
        if (fault != nullptr && fault->kind == ScriptedFaultKind::jump) place.x() += 1;
        if (fault != nullptr && fault->kind == ScriptedFaultKind::not_a_number)
            place.x() = std::numeric_limits<double>::quiet_NaN();
        pose.sequence = sequence_;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = place[axis];
        pose.roll = wanted.roll;
        pose.jaw = wanted.jaw;
        pose.buttons = wanted.buttons;
        const bool silent = fault != nullptr && fault->kind == ScriptedFaultKind::silence;
        pose.present = script_.facts.slot[i] && !silent ? 1 : 0;
    }
}

void VirtualDevice::render(int hand, const Vector3& force, double /*torque*/) noexcept {
    rendered_[hand] = force;
}

}  // namespace fulcrum::hapticd
