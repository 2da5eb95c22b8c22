// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run` with "model": "skin": mean value coordinates of a mesh in a cage, applied to the deformed
// cage (docs/FORMATS.md).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "sim_core/geometry/mesh.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::lab {

/// How a cage's vertices form rings: ring[r][k] is a vertex number, counterclockwise about the direction of
/// the rings.
struct RingLayout {
    int per_ring = 0;
    std::vector<std::int32_t> ring_vertices;  ///< ring by ring
};

/// Rings of a tube whose vertices are in ring order, with no, one trailing or one leading and trailing pair
/// of cap centres. Empty if the triangles do not join such rings.
std::optional<RingLayout> find_rings(const TriangleMesh& cage);

/// {"model": "skin", "cage", "rest", "deformed_cage", "scope": "global|local"} gives {"vertices",
/// "weights_sum_error", "linear_error_m", "time_us", "bind_us"}. Local scope (k = 1, blended) needs a cage of
/// rings. Throws InputError.
nlohmann::json run_skin_study(const JsonDocument& study);

}  // namespace fulcrum::lab
