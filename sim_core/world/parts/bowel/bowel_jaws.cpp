// SPDX-License-Identifier: Apache-2.0
// Jaws as boxes against the bowel's spheres (fidelity level "jaws" of tool_contact): what a jaw is deeper in
// a sphere than the shaft, whose contact is the dynamic point's, presses on the centre line with the wall's
// stiffness.
#include <algorithm>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/world/parts/bowel/bowel_part.h"

namespace fulcrum {

SolidContact jaws_in_sphere(const ToolShape& tool, const Vector3& centre, double radius) {
    SolidContact deepest;
    for (int k = 0; k < tool.jaws; ++k) {
        const Separation found = separate_point(tool.jaw[k], centre);
        const double depth = found.overlap > 0 ? radius + found.overlap : radius - found.distance;
        if (deepest.by_jaw && !(depth > deepest.depth)) continue;
        deepest.depth = depth;
        deepest.normal = -found.normal;  // out of the sphere
        deepest.point = found.on_box;
        deepest.by_jaw = true;
    }
    if (!deepest.by_jaw) return deepest;
    const Vector3 on_shaft = closest_points_of_segments(tool.trocar, tool.tip, centre, centre).on_first;
    const double by_shaft = std::max(0.0, tool.radius + radius - (on_shaft - centre).norm());
    deepest.depth -= by_shaft;
    return deepest;
}

void BowelPart::press_jaws(const ToolAction* actions) noexcept {
    const TissueSpec& tissue =
        scene_.tissues[static_cast<std::size_t>(scene_.tissue_index(scene_.bowel->tissue))];
    for (int hand = 0; hand < hand_count; ++hand) {
        JawPushModel& felt = jaw_felt_[hand];
        felt = JawPushModel();
        std::vector<Vector3>& pushes = jaw_pushes_[hand];
        const ToolAction& action = actions[hand];
        // Jaws that hold tissue are where it is: the grasp's constraint says what they do. Those of a device
        // that does not answer press as their shaft does.
        const bool presses = action.instrument != nullptr && action.tool.inside &&
                             !grasps_[hand].state.held && action.tool.tip.allFinite();
        if (!presses) {
            std::fill(pushes.begin(), pushes.end(), Vector3::Zero());
            continue;
        }
        felt.place = action.tool.tip;
        double pressed = 0;
        const ToolShape shape = tool_shape(jaw_models_[hand], action.tool);
        const double reach = 2 * jaw_models_[hand].jaw_length;
        for (std::size_t i = 0; i < pushes.size(); ++i) {
            const double s = spheres_.arc_lengths[i], radius = spheres_.radii[i];
            const Vector3 centre = rod_->frame_at(state_, s).frame.position;
            SolidContact contact;
            if ((centre - action.tool.tip).norm() < radius + reach)
                contact = jaws_in_sphere(shape, centre, radius);
            if (!contact.by_jaw || !(contact.depth > 0)) {
                pushes[i].setZero();
                continue;
            }
            // As every tool's force: taken at the step's end, to first order.
            const Vector3 wanted = -tissue.stiffness * contact.depth * contact.normal;
            const Matrix3 stiffness = rod_->stiffness_at(state_, s, Vector3::Zero(), scratch_);
            const double yields = std::max(1e-3, contact.normal.dot(stiffness * contact.normal));
            pushes[i] = relax_contact_force(pushes[i], wanted, tissue.stiffness, yields);
            felt.force += pushes[i];
            felt.point += pushes[i].norm() * contact.point;
            pressed += pushes[i].norm();
            felt.stiffness += contact.normal * contact.normal.transpose();
            if (inputs_.loads.size() < inputs_.loads.capacity())
                inputs_.loads.push_back({s, pushes[i], Vector3::Zero()});
        }
        if (!(pressed > 0)) continue;
        felt.point /= pressed;
        // Spheres overlap: two under one jaw are one piece of wall, which is no stiffer than itself.
        felt.stiffness *= tissue.stiffness / std::max(1.0, felt.stiffness.trace());
        felt.tissue = static_cast<std::int16_t>(scene_.tissue_index(scene_.bowel->tissue));
    }
}

}  // namespace fulcrum
