// SPDX-License-Identifier: Apache-2.0
#include "sim_core/material/exp2.h"

#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {

double exponential_less_one(double v) {
    if (std::fabs(v) > 0.5) return math::exp(v) - 1.0;
    double sum = 1.0;  // v (1 + v/2 (1 + v/3 (...))), to below 1 ulp
    for (int k = 15; k >= 2; --k) sum = 1.0 + v / k * sum;
    return v * sum;
}

double exp2_energy_density(const Exp2& law, double strain) {
    return 0.5 * law.rest_stiffness / law.exponent * exponential_less_one(law.exponent * strain * strain);
}

double exp2_stress(const Exp2& law, double strain) {
    return law.rest_stiffness * strain * math::exp(law.exponent * strain * strain);
}

double exp2_tangent(const Exp2& law, double strain) {
    const double power = law.exponent * strain * strain;
    return law.rest_stiffness * (1.0 + 2.0 * power) * math::exp(power);
}

}  // namespace fulcrum
