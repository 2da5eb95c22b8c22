// SPDX-License-Identifier: Apache-2.0
// What records call the variant of a task's own scene, and the fidelity that results are compared at.
// Permanent.
#pragma once

namespace fulcrum {

inline constexpr const char* standard_variant = "standard";
inline constexpr const char* standard_fidelity = "standard";

}  // namespace fulcrum
