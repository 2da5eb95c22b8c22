// SPDX-License-Identifier: Apache-2.0
// What is asked of a state: frames and points of the wall, their stiffness, energy.
#include "sim_core/numerics/functions.h"
#include "sim_core/rod/rod.h"
#include "sim_core/rod/rod_system.h"

namespace fulcrum {

Vector3 tangent_of(const RodState& state, std::size_t j) {
    return (state.nodes[j + 1] - state.nodes[j]).normalized();
}

Matrix3 frame_of(const Vector3& d1, const Vector3& t) {
    Matrix3 rotation;
    rotation.col(0) = d1;
    rotation.col(1) = t.cross(d1);
    rotation.col(2) = t;
    return rotation;
}

RodMotion Rod::frame_at(const RodState& state, double s) const {
    const RodPoint point = locate(*tables_, s);
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    RodMotion motion;
    for (std::size_t k = 0; k < 3; ++k) {
        motion.frame.position += point.node_weight[k] * state.nodes[base + k];
        motion.velocity += point.node_weight[k] * state.velocities[base + k];
    }
    const Vector3 a = tangent_of(state, base), b = tangent_of(state, base + 1);
    for (std::size_t q = 0; q < 2; ++q) {
        const std::size_t j = base + q;
        const Vector3 t = q == 0 ? a : b;
        const double length = (state.nodes[j + 1] - state.nodes[j]).norm();
        motion.angular_velocity +=
            point.segment_weight[q] *
            (t.cross(state.velocities[j + 1] - state.velocities[j]) / length + t * state.spins[j]);
    }
    const double u = point.segment_weight[1];
    const Vector3 blend = a * (1 - u) + b * u;
    const double size = blend.norm();
    const Vector3 t = size > 1e-9 ? Vector3(blend / size) : a;
    Vector3 d1 = transport(state.directors[base], a, t);
    const double angle = u * state.joint_twist[base + 1];
    if (angle != 0) d1 = d1 * math::cos(angle) + t.cross(d1) * math::sin(angle);
    d1 = (d1 - t * t.dot(d1)).normalized();
    motion.frame.rotation = frame_of(d1, t);
    return motion;
}

Vector3 Rod::wall_point(const RodState& state, double s, const Vector3& offset) const {
    const RodPoint point = locate(*tables_, s);
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    Vector3 position = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) position += point.node_weight[k] * state.nodes[base + k];
    for (std::size_t q = 0; q < 2; ++q) {
        position += point.segment_weight[q] *
                    (frame_of(state.directors[base + q], tangent_of(state, base + q)) * offset);
    }
    return position;
}

Vector3 Rod::wall_velocity(const RodState& state, double s, const Vector3& offset) const {
    const RodPoint point = locate(*tables_, s);
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    Vector3 velocity = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) velocity += point.node_weight[k] * state.velocities[base + k];
    for (std::size_t q = 0; q < 2; ++q) {
        const std::size_t j = base + q;
        const Vector3 t = tangent_of(state, j);
        const double length = (state.nodes[j + 1] - state.nodes[j]).norm();
        const Vector3 turn =
            t.cross(state.velocities[j + 1] - state.velocities[j]) / length + t * state.spins[j];
        velocity += point.segment_weight[q] * turn.cross(frame_of(state.directors[j], t) * offset);
    }
    return velocity;
}

Vector3 Rod::wall_offset(const RodState& state, double s, const Vector3& position) const {
    const RodPoint point = locate(*tables_, s);
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    Vector3 away = position;
    Matrix3 blend = Matrix3::Zero();
    for (std::size_t k = 0; k < 3; ++k) away -= point.node_weight[k] * state.nodes[base + k];
    for (std::size_t q = 0; q < 2; ++q) {
        blend += point.segment_weight[q] * frame_of(state.directors[base + q], tangent_of(state, base + q));
    }
    return blend.inverse() * away;
}

Matrix3 Rod::stiffness_at(const RodState& state, double s, const Vector3& offset, RodScratch& scratch) const {
    RodScratch::Data& d = scratch.data();
    shape_from_state(*tables_, spec_, state, state.ends, d.trial);
    const RodPoint point = locate(*tables_, s);
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    RodJacobian jacobian;
    wall_jacobian(d.trial, point, offset, jacobian);
    Matrix3 compliance;
    for (int axis = 0; axis < 3; ++axis) {
        for (double& entry : d.column) entry = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 4; ++c) d.column[4 * (base + k) + c] = jacobian.column[k][c][axis];
        }
        const std::size_t last = 4 * static_cast<std::size_t>(spec_.segments);
        for (std::size_t c = 0; c < 3; ++c) {
            if (d.fixed[0]) d.column[c] = 0;
            if (d.fixed[1]) d.column[last + c] = 0;
        }
        d.column[last + 3] = 0;
        d.factor.solve(d.column.data());
        for (int row = 0; row < 3; ++row) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t c = 0; c < 4; ++c)
                    sum += jacobian.column[k][c][row] * d.column[4 * (base + k) + c];
            }
            compliance(row, axis) = sum;
        }
    }
    compliance = (0.5 * (compliance + compliance.transpose())).eval();
    compliance.diagonal().array() += 1e-18;
    Matrix3 stiffness = compliance.inverse();
    for (std::size_t g = 0; g < d.saved_grasps.size(); ++g) {
        const RodGrasp& grasp = d.saved_grasps[g];
        if (grasp.s == s && grasp.offset == offset)
            stiffness -= (grasp.rigid() ? tables_->grasp_penalty : grasp.stiffness) * Matrix3::Identity();
    }
    return stiffness;
}

RodEnergy Rod::energy(const RodState& state, const RodInputs& inputs) const {
    RodShape shape;
    RodJointTerms joints;
    RodSectionTerms section;
    shape.resize(spec_.segments);
    joints.resize(spec_.segments);
    if (tables_->section) section.resize(spec_.segments);
    shape_from_state(*tables_, spec_, state, state.ends, shape);
    RodEnergy energy;
    if (tables_->section) {
        section_terms(*tables_, shape, false, section, joints);
    } else {
        joint_terms(*tables_, shape, false, joints);
    }
    energy.bend = joints.bend;
    energy.twist = joints.twist;
    energy.stretch = tables_->section ? section.stretch : stretch_energy(*tables_, shape);
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        energy.external -= node_mass_[i] * inputs.gravity.dot(state.nodes[i]);
        if (!inputs.nodal_forces.empty()) energy.external -= inputs.nodal_forces[i].dot(state.nodes[i]);
        energy.kinetic += 0.5 * node_mass_[i] * state.velocities[i].squaredNorm();
    }
    for (std::size_t j = 0; j < state.spins.size(); ++j)
        energy.kinetic += 0.5 * tables_->spin_inertia[j] * state.spins[j] * state.spins[j];
    for (const RodLoad& load : inputs.loads)
        energy.external -= load.force.dot(point_position(shape, locate(*tables_, load.s)));
    return energy;
}

}  // namespace fulcrum
