// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/registry.h"

#include "sim_core/world/couplings/membranes_on_bowel.h"
#include "sim_core/world/couplings/septa_on_rectum.h"
#include "sim_core/world/parts/bands/bands_part.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/parts/camera_targets/camera_targets_part.h"
#include "sim_core/world/parts/membranes/membranes_part.h"
#include "sim_core/world/parts/objects/objects_part.h"
#include "sim_core/world/parts/sheet/sheet_part.h"
#include "sim_core/world/parts/structures/structures_part.h"
#include "sim_core/world/parts/targets/targets_part.h"
#include "sim_core/world/parts/wall/wall_part.h"

namespace fulcrum {
namespace {

/// Builds the part where the scene lists it, else returns null. `parts` are those before it.
using PartBuilder = std::unique_ptr<Part> (*)(const Scene& scene, std::uint64_t seed, const PartList& parts);

constexpr PartBuilder part_builders[] = {
    build_targets,         build_wall,         build_bowel_part,
    build_membranes_part,  build_sheet_part,   build_bands_part,
    build_structures_part, build_objects_part, build_camera_targets,
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
