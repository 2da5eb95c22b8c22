// SPDX-License-Identifier: Apache-2.0
#include "sim_core/contact/jaws.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/scene/perforation.h"

namespace fulcrum {
namespace {

constexpr double bite_margin = 0.003;  // m around the jaws from which tissue is drawn in when they close
constexpr double least_opening = 0.25, widest_opening = 2.5;  // rad: closing jaws were open

}  // namespace

JawBox::JawBox(const ToolKinematics& tool, double opening, double jaw_length, double width)
    : tool_(tool),
      spread_(math::tan(0.5 * std::clamp(opening, least_opening, widest_opening))),
      jaw_length_(jaw_length),
      width_(width) {}

bool JawBox::contains(const Vector3& point) const {
    const Vector3 local = tool_.rotation.transpose() * (point - tool_.tip);
    const double from_hinge = local.z() + jaw_length_;
    return from_hinge >= 0 && local.z() <= bite_margin && std::abs(local.x()) <= 0.5 * width_ + bite_margin &&
           std::abs(local.y()) <= spread_ * from_hinge + bite_margin;
}

double JawBox::contact_area(double surface) const {
    return std::clamp(surface, pinched_area, std::max(pinched_area, 2.0 * jaw_length_ * width_));
}

double jaw_capacity(double jaw_force, double friction) {
    return 2.0 * std::max(0.0, friction) * std::max(0.0, jaw_force);
}

double slip_ratio(const Vector3& force, double jaw_force, double friction) {
    const double size = force.norm();
    if (!(size > 0)) return 0;
    return std::min(size / std::max(jaw_capacity(jaw_force, friction), 1e-9), 1e9);
}

}  // namespace fulcrum
