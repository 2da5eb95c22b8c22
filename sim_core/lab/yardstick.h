// SPDX-License-Identifier: Apache-2.0
// The yardstick of all speed measurements: one 512 x 512 x 512 double matrix product by Eigen (G). mG =
// G/1000.
#pragma once

namespace fulcrum::lab {

/// Runs the product once and returns its wall time in microseconds. Built for the machine it is compiled on,
/// in a separate namespace, so that measurements compare across machines while the product keeps one
/// instruction set.
double time_yardstick_us();

}  // namespace fulcrum::lab
