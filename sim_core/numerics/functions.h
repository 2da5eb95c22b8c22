// SPDX-License-Identifier: Apache-2.0
// Elementary functions of the physics, compiled with the product: the C library picks its code by CPU and
// changes bits. All: double in, double out, deterministic on every machine that runs this build; error below
// 2 ulp in the range named.
#pragma once

namespace fulcrum::math {

double sin(double x);  ///< |x| <= 1e6 rad; NaN for non-finite x
double cos(double x);  ///< |x| <= 1e6 rad; NaN for non-finite x
void sin_cos(double x, double& sine, double& cosine);
double tan(double x);
double exp(double x);              ///< overflows to infinity above 709.78, to 0 below -745.2
double log(double x);              ///< x > 0; -infinity at 0; NaN below
double atan2(double y, double x);  ///< (-pi, pi]
double acos(double x);             ///< x clamped to [-1, 1]
double asin(double x);             ///< x clamped to [-1, 1]
double hypot3(double x, double y, double z);

}  // namespace fulcrum::math
