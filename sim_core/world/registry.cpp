// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/registry.h"

#include "sim_core/world/couplings/membranes_on_bowel.h"
#include "sim_core/world/couplings/septa_on_rectum.h"

namespace fulcrum {
// Each builds its part where the scene lists it, else returns null. `parts` are those before it.
#define WORLD_PART(name, view) PART_WITHOUT_VIEW(name)
#define PART_WITHOUT_VIEW(name) \
    std::unique_ptr<Part> build_##name##_part(const Scene& scene, std::uint64_t seed, const PartList& parts);
#include "sim_core/world/part/world_parts.inc"

namespace {

using PartBuilder = std::unique_ptr<Part> (*)(const Scene& scene, std::uint64_t seed, const PartList& parts);

constexpr PartBuilder part_builders[] = {
#define WORLD_PART(name, view) PART_WITHOUT_VIEW(name)
#define PART_WITHOUT_VIEW(name) build_##name##_part,
#include "sim_core/world/part/world_parts.inc"
};

/// Builds the coupling where both its ends are there, else returns null.
using CouplingBuilder = std::unique_ptr<Coupling> (*)(const Scene& scene, const PartList& parts);

constexpr CouplingBuilder coupling_builders[] = {
    build_membranes_on_bowel,
    build_septa_on_rectum,
};

}  // namespace

PartList build_parts(const Scene& scene, std::uint64_t seed) {
    PartList parts;
    for (const PartBuilder build : part_builders) {
        if (std::unique_ptr<Part> part = build(scene, seed, parts)) parts.push_back(std::move(part));
    }
    return parts;
}

std::vector<std::unique_ptr<Coupling>> build_couplings(const Scene& scene, const PartList& parts) {
    std::vector<std::unique_ptr<Coupling>> couplings;
    for (const CouplingBuilder build : coupling_builders) {
        if (std::unique_ptr<Coupling> coupling = build(scene, parts))
            couplings.push_back(std::move(coupling));
    }
    return couplings;
}

}  // namespace fulcrum
