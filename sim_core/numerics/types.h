// SPDX-License-Identifier: Apache-2.0
// Vector and matrix types used in all rooms. Units inside the program are SI: m, kg, s, N, Pa, rad.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace fulcrum {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// The two operating hands. Arrays over hands are indexed with these values.
enum class Hand : std::uint8_t { left = 0, right = 1 };
inline constexpr int hand_count = 2;
constexpr const char* hand_name(Hand hand) {
    return hand == Hand::left ? "left" : "right";
}

}  // namespace fulcrum
