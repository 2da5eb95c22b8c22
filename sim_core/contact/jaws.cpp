// SPDX-License-Identifier: Apache-2.0
#include "sim_core/contact/jaws.h"

#include <algorithm>
#include <cmath>

#include "sim_core/contact/patch_surface.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double bite_margin = 0.003;  // m around the jaws from which tissue is drawn in when they close
constexpr double least_area = 1e-6;    // m2

}  // namespace

JawContact find_jaw_contact(const InstrumentModel& instrument, const ToolKinematics& tool, double opening,
                            const LocalModel& local, std::uint32_t tick, ToolContactScratch& scratch) {
    JawContact contact;
    const SurfacePatch& patch = local.patch;
    if (patch.triangle_count == 0 || !instrument.has_jaws) return contact;
    const double seconds =
        std::min((tick > local.tick ? tick - local.tick : 0) * instrument.tick_period, 0.020);
    PatchSurface surface(patch, seconds, scratch);
    const double spread = math::tan(0.5 * std::clamp(opening, 0.0, instrument.jaw_opening));
    const double half_width = 0.5 * instrument.tip_box.y() + bite_margin;
    const Vector3 middle(0, 0, -0.5 * instrument.jaw_length);
    double nearest2 = 1e30, weight = 0;
    Vector3 point = Vector3::Zero(), normal = Vector3::Zero();
    std::int32_t nearest = -1;
    for (std::int32_t v = 0; v < patch.vertex_count; ++v) {
        const auto n = static_cast<std::size_t>(v);
        const Vector3 local_point = tool.rotation.transpose() * (surface.position(v) - tool.tip);
        const double from_hinge = local_point.z() + instrument.jaw_length;
        if (from_hinge < 0 || local_point.z() > bite_margin || std::abs(local_point.x()) > half_width)
            continue;
        if (std::abs(local_point.y()) > spread * from_hinge + bite_margin) continue;
        weight += patch.vertex_area[n];
        point += patch.vertex_area[n] * surface.position(v);
        normal += patch.vertex_area[n] * surface.normal(v);
        const double distance2 = (local_point - middle).squaredNorm();
        if (distance2 < nearest2) {
            nearest2 = distance2;
            nearest = v;
        }
    }
    if (nearest < 0) return contact;
    contact.area = std::min(weight, 2.0 * instrument.jaw_length * instrument.tip_box.y());
    contact.vertex = patch.vertex_id[static_cast<std::size_t>(nearest)];
    contact.tissue_patch = patch.tissue_patch[static_cast<std::size_t>(nearest)];
    contact.point = weight > 0 ? Vector3(point / weight) : surface.position(nearest);
    const double length = normal.norm();
    contact.normal = length > 0 ? Vector3(normal / length) : surface.normal(nearest);
    return contact;
}

double jaw_pressure(double jaw_force, double area) {
    return std::max(0.0, jaw_force) / std::max(area, least_area);
}

double slip_ratio(const Vector3& force, const Vector3& normal, double jaw_force, double friction) {
    const double tangential = (force - force.dot(normal) * normal).norm();
    const double capacity = 2.0 * std::max(0.0, friction) * std::max(0.0, jaw_force);
    if (!(tangential > 0)) return 0;
    return std::min(tangential / std::max(capacity, 1e-9), 1e9);
}

double held_opening(const InstrumentModel& instrument, double thickness) {
    return std::min(2.0 * math::atan2(0.5 * std::max(0.0, thickness), 0.5 * instrument.jaw_length),
                    instrument.jaw_opening);
}

void add_damage(PatchDamage& damage, double load, double threshold, double period) {
    if (!std::isfinite(load)) return;
    damage.peak = std::max(damage.peak, load);
    if (load > threshold) damage.impulse += (load - threshold) * period;
}

}  // namespace fulcrum
