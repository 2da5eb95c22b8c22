// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/tool_axes.h"

#include <cmath>

namespace fulcrum::hapticd {

std::optional<Vector3> direction_of(std::string_view word) {
    if (word.size() != 2 || (word[0] != '+' && word[0] != '-') || word[1] < 'x' || word[1] > 'z')
        return std::nullopt;
    Vector3 direction = Vector3::Zero();
    direction[word[1] - 'x'] = word[0] == '+' ? 1 : -1;
    return direction;
}

std::optional<Matrix3> axes_of(std::string_view word) {
    if (word.size() != 6) return std::nullopt;
    Matrix3 axes;
    for (int row = 0; row < 3; ++row) {
        const auto direction = direction_of(word.substr(static_cast<std::size_t>(2 * row), 2));
        if (!direction) return std::nullopt;
        axes.row(row) = direction->transpose();
    }
    return axes;
}

double roll_of(const Matrix3& tool, const Vector3& shaft) noexcept {
    const Vector3 axis = tool * shaft;
    const Vector3 across = std::abs(shaft.x()) > 0.5 ? Vector3::UnitY() : Vector3::UnitX();
    const Vector3 side = tool * across;
    const Quaternion lean = Quaternion::FromTwoVectors(-Vector3::UnitZ(), axis);
    const Vector3 x = lean * Vector3::UnitX(), y = axis.cross(x);
    return std::atan2(side.dot(y), side.dot(x));
}

}  // namespace fulcrum::hapticd
