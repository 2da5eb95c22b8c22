// SPDX-License-Identifier: Apache-2.0
// The version of the simulation's results, to which measurements of the simulation belong.
#pragma once

namespace fulcrum {

/// Raised with every change after which operators' attempts have other state hashes
/// (tests/assessment/attempt/golden_hashes_test.cpp): what was measured with operators is then measured
/// again. A change that only other inputs meet raises program_version alone.
inline constexpr int physics_version = 4;

}  // namespace fulcrum
