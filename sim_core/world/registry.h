// SPDX-License-Identifier: Apache-2.0
// Which parts and couplings a scene asks for, one line each. The order is that of building, publishing and
// hashing.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim_core/world/part/part.h"

namespace fulcrum {

/// Throws InputError. The scene must outlive the parts; the seed draws the variant.
PartList build_parts(const Scene& scene, std::uint64_t seed);
/// Of these parts, which must outlive them; not settled. Throws InputError.
std::vector<std::unique_ptr<Coupling>> build_couplings(const Scene& scene, const PartList& parts);

}  // namespace fulcrum
