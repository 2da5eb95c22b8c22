// SPDX-License-Identifier: Apache-2.0
// The program's version, stored with every attempt.
#pragma once

namespace fulcrum {

inline constexpr const char* program_version = "0.1.0";

}  // namespace fulcrum
