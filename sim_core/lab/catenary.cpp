// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/catenary.h"

#include <cmath>

namespace fulcrum::lab {

CatenaryPoint catenary_point(const Catenary& catenary, double tension, double s) {
    const double weight = catenary.weight * catenary.length, half = 0.5 * weight;
    const double below = half - weight * s / catenary.length;  // vertical part of the tension at s
    CatenaryPoint point;
    point.x = tension * s / catenary.axial_stiffness +
              tension * catenary.length / weight * (std::asinh(half / tension) - std::asinh(below / tension));
    point.z = -(weight * s / catenary.axial_stiffness * (0.5 - 0.5 * s / catenary.length) +
                tension * catenary.length / weight *
                    (std::sqrt(1 + half * half / (tension * tension)) -
                     std::sqrt(1 + below * below / (tension * tension))));
    return point;
}

double catenary_tension(const Catenary& catenary) {
    double low = 1e-9 * catenary.weight * catenary.length, high = 1e6 * catenary.weight * catenary.length;
    for (int i = 0; i < 200; ++i) {
        const double middle = std::sqrt(low * high);
        (catenary_point(catenary, middle, catenary.length).x < catenary.span ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

}  // namespace fulcrum::lab
