// SPDX-License-Identifier: Apache-2.0
// Bands as the viewport, the monitor and the operators see them after a step (WorldSnapshot::bands). Vectors
// have their final size from the start.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/strand/strand.h"

namespace fulcrum {

struct BandView {
    std::array<Vector3, strand_nodes> position;       ///< m
    std::array<float, strand_segments> heat{};        ///< degrees C
    std::array<float, strand_segments> char_share{};  ///< 0 moist .. 1 dry and black
    std::array<float, strand_segments> coagulated{};  ///< 0 .. 1, white
    std::uint32_t parted = 0;                         ///< bit s: segment s is divided
    bool torn = false;                                ///< it gave way to traction, not to an instrument
    float tension = 0;                                ///< N, largest along it
    std::int32_t vessel = -1;                         ///< index of the vessel in it, -1 none
    std::uint32_t clips = 0;                          ///< bit n: a clip sits at node n
    float parted_tension = 0;                         ///< N, when it was divided first
    bool divided() const { return parted != 0; }
};

struct BandsView {
    std::vector<BandView> bands;

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(bands);
    }
};

}  // namespace fulcrum
