// SPDX-License-Identifier: Apache-2.0
// The version of the simulation's results, to which measurements of the simulation belong.
#pragma once

namespace fulcrum {

/// Raised with every change after which an attempt of the same inputs has another state hash
/// (tests/assessment/attempt/golden_hashes_test.cpp).
inline constexpr int physics_version = 4;

}  // namespace fulcrum
