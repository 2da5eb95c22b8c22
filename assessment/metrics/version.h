// SPDX-License-Identifier: Apache-2.0
// The program's version, stored with every attempt.
#pragma once

namespace fulcrum {

/// Raised with every change after which the same inputs can give another state, other events, other forces,
/// or a state that is stored otherwise: the check of the store simulates attempts of this version only, and
/// stored states of another version are not read.
inline constexpr const char* program_version = "0.1.3";

}  // namespace fulcrum
