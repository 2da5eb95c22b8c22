// SPDX-License-Identifier: Apache-2.0
// Where bands, vessels and nerve stand: drawn from the attempt's seed. Same seed, same places.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/scene/bands_spec.h"
#include "sim_core/world/field/operative_field.h"

namespace fulcrum {

struct BandPlace {
    Vector3 root = Vector3::Zero(),
            end = Vector3::Zero();  ///< m, the posts' heads; a vessel comes from the root
    std::int32_t vessel = -1;
    Vector3 vessel_root = Vector3::Zero();  ///< m, on the bed, where its branch leaves
};

struct BandsLayout {
    std::vector<BandPlace> bands;
    std::vector<std::int32_t> vessel_bands;  ///< by vessel
    std::vector<Vector3> nerve;              ///< m, a line along y
    FieldBed bed;                            ///< level cells
};

BandsLayout place_bands(const BandsSpec& spec, std::uint64_t seed);
/// The bed as the instruments feel it, normals up.
TriangleMesh bed_mesh(const BandsSpec& spec);

/// Which heat patches of a field are bands': segments of all bands come first, segment s of band b is
/// b * strand_segments + s.
struct BandPatches {
    std::size_t roots = 0;  ///< patch of the first vessel's root
    std::vector<std::int32_t>
        segment_links;  ///< link between segment s and s + 1 of band b at [b * (segments - 1) + s]
};
FieldModel make_bands_field(const BandsSpec& spec, const BandsLayout& layout, BandPatches& patches);

}  // namespace fulcrum
