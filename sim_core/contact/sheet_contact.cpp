// SPDX-License-Identifier: Apache-2.0
#include "sim_core/contact/sheet_contact.h"

#include <algorithm>

namespace fulcrum {

void touch_sheet(const ToolContactModel& model, const LocalModel& local, const ToolKinematics& tool,
                 ToolContactResult& result) {
    const SheetContactModel& sheet = local.sheet;
    if (sheet.tissue < 0) return;
    const Vector3 place = tool.tip - sheet.back * tool.axis, arm = place - tool.trocar;
    const Vector3 moved = place - sheet.place;
    const Vector3& n = sheet.normal;
    const double along = moved.dot(n), approach = (tool.tip_velocity - sheet.velocity).dot(n);
    double push = 0, undamped = 0;
    if (sheet.pushes) {
        push = sheet.push - sheet.stiffness * along;
        undamped = std::max(0.0, push);
        // Damping rises with the depth, so that first contact causes no jump.
        const double depth = push / std::max(1e-9, sheet.stiffness);
        const double share = std::clamp(depth / model.onset_depth, 0.0, 1.0);
        push = push > 0 ? std::max(0.0, push - share * sheet.damping * approach) : 0.0;
    }
    Vector3 drag = sheet.drag + sheet.drag_stiffness * (moved - along * n);
    const double most = sheet.grip + sheet.friction * push, size = drag.norm();
    const double undamped_most = sheet.grip + sheet.friction * undamped;
    const Vector3 undamped_force = (size > undamped_most ? undamped_most / size : 1.0) * drag - undamped * n;
    if (size > most) drag *= most / size;
    const Vector3 force = drag - push * n;
    const Matrix3 across = n * n.transpose();
    const double push_slope = undamped > 0 ? sheet.stiffness : 0.0;
    // Sliding drag too: when the hand turns around it is a spring at once.
    const double drag_slope = undamped_most > 0 ? sheet.drag_stiffness : 0.0;
    result.tissue_load.add(arm, force, undamped_force,
                           push_slope * across + drag_slope * (Matrix3::Identity() - across),
                           (undamped > 0 ? sheet.damping : 0.0) * across);
    result.cutting = sheet.cutting;
    if (!(force.squaredNorm() > 0)) return;
    result.sheet_force = force;
    result.force += force;
    result.torque += arm.cross(force);
    if (!result.touching_surface) {  // otherwise the bowel's own contact gives the point of load
        result.point = tool.tip;
        result.normal = n;
    }
    if (push > 0) {
        result.stiffness += sheet.stiffness * n * n.transpose();
        result.damping = std::max(result.damping, sheet.damping);
    }
    if (size <= most) result.stiffness += sheet.drag_stiffness * (Matrix3::Identity() - n * n.transpose());
}

}  // namespace fulcrum
