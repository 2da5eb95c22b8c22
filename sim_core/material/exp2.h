// SPDX-License-Identifier: Apache-2.0
// The two material laws of the bowel wall under uniaxial strain e (docs/THEORY.md, section 1.1). `linear`:
// sigma = E e. `EXP2`, which Pan et al. 2011 call impractical in real time: W = E0 / (2 a) (exp(a e^2) - 1),
// sigma = E0 e exp(a e^2); odd in e, E0 is the stiffness at rest. Same bits on every machine (exp from
// numerics/functions.h).
#pragma once

#include <cstdint>

namespace fulcrum {

enum class MaterialLaw : std::uint8_t { linear, exp2 };

/// Coefficients of EXP2. Defaults: provisional values of this project, chosen so that the best straight line
/// through 0 to 20 % strain has the 32.3 kPa that Pan et al. 2011 use for the linear law.
struct Exp2 {
    double rest_stiffness = 30.0e3;  ///< Pa, E0, > 0
    double exponent = 3.0;           ///< a, dimensionless, 0.01 .. 100
};

/// E0 divided by the modulus of the linear law that fits EXP2 best on 0 to 20 % strain (30.0 / 32.3).
inline constexpr double exp2_rest_share = 30.0 / 32.3;

double exp2_energy_density(const Exp2& law, double strain);  ///< J/m3
double exp2_stress(const Exp2& law, double strain);          ///< Pa
double exp2_tangent(const Exp2& law, double strain);         ///< Pa, d stress / d strain, > 0

/// exp(v) - 1 without cancellation near 0; v any finite number.
double exponential_less_one(double v);

}  // namespace fulcrum
