// SPDX-License-Identifier: Apache-2.0
// Random values over a wide range, for studies and tests.
#pragma once

#include <cmath>
#include <limits>

#include "sim_core/numerics/random.h"
#include "sim_core/numerics/types.h"

namespace fulcrum::lab {

/// Uniform in the logarithm.
inline double between(Random& random, double low, double high) {
    return low * std::pow(high / low, random.uniform());
}

inline Vector3 inside_unit_box(Random& random) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    return Vector3(x, y, z);
}

inline Vector3 direction(Random& random) {
    const Vector3 v = inside_unit_box(random);
    return v.norm() > 1e-6 ? Vector3(v.normalized()) : Vector3(Vector3::UnitX());
}

/// NaN, either infinity, or a number whose square overflows.
inline double not_a_length(Random& random) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double bad[] = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300};
    return bad[random.below(4)];
}

}  // namespace fulcrum::lab
