// SPDX-License-Identifier: Apache-2.0
// Elementary functions for the physics, compiled with the product because the C library selects its code by
// CPU and returns different bits. All take and return double, are deterministic on every machine that runs
// this build, and have an error below 2 ulp in the stated range.
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
