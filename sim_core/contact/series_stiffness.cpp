// SPDX-License-Identifier: Apache-2.0
#include "sim_core/contact/series_stiffness.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace fulcrum {

Matrix3 stiffness_in_series(const Matrix3& tissue, double wall) {
    const Matrix3 rigid = wall * Matrix3::Identity();
    // Above this the series equals the wall to the last digit, and squares stay finite.
    constexpr double largest = 1e30;
    if (!tissue.allFinite() || tissue.cwiseAbs().maxCoeff() > largest) return rigid;
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(0.5 * (tissue + tissue.transpose()));
    if (solver.info() != Eigen::Success) return rigid;
    Vector3 values = solver.eigenvalues();
    for (double& value : values) {
        value = std::max(0.0, value);
        value *= wall / (value + wall);
    }
    const Matrix3 series = solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
    return 0.5 * (series + series.transpose());
}

}  // namespace fulcrum
