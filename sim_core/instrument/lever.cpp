// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/lever.h"

namespace fulcrum {
namespace {

constexpr double shortest_lever = 1e-6;  // m

bool usable_handle(const Vector3& handle) {
    return handle.allFinite() && handle.norm() >= shortest_lever;
}

// Matrix of v x.
Matrix3 cross_matrix(const Vector3& v) {
    Matrix3 matrix;
    matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return matrix;
}

}  // namespace

HandLoad load_at_hand(const Vector3& handle, const ToolLoad& load) {
    HandLoad hand;
    if (!usable_handle(handle)) return hand;
    const double length = handle.norm();
    const Vector3 out = handle / length;
    const Vector3 force = out * out.dot(load.force) + load.moment.cross(out) / length;
    const double torque = -load.moment.dot(out);
    if (!force.allFinite() || !(torque - torque == 0)) return hand;
    hand.force = force;
    hand.torque = torque;
    return hand;
}

void ToolMatrix::add(const Matrix3& matrix, const Vector3& arm) {
    const Matrix3 turn = cross_matrix(arm);
    direct_ += matrix;
    mixed_ += matrix * turn;
    turning_ += turn.transpose() * matrix * turn;
}

void ToolMatrix::add(const ToolMatrix& other) {
    direct_ += other.direct_;
    mixed_ += other.mixed_;
    turning_ += other.turning_;
}

Matrix3 ToolMatrix::at_hand(const Vector3& handle) const {
    if (!usable_handle(handle) || !all_finite()) return Matrix3::Zero();
    const double length = handle.norm();
    const Vector3 out = handle / length;
    // J = P - X W with P = u u^T and W the matrix of u x, over |h|.
    const Matrix3 slide = out * out.transpose(), turn = cross_matrix(out) / length;
    const Matrix3 cross = slide * mixed_ * turn;
    const Matrix3 sum =
        slide * direct_ * slide - cross - cross.transpose() + turn.transpose() * turning_ * turn;
    return sum.allFinite() ? sum : Matrix3(Matrix3::Zero());
}

}  // namespace fulcrum
