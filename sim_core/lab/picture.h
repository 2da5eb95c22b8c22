// SPDX-License-Identifier: Apache-2.0
// Draws an experiment's panels in software: the same meshes give the same pixels on any machine, with no
// window, no driver.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/lab/experiment.h"

namespace fulcrum::lab {

struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< sRGB, rows from the top, 3 bytes a pixel
};

/// One panel: lit from the camera and from above, on white, smoothed by drawing at twice the size.
Picture draw_panel(const ExperimentPanel& panel, int width, int height);

}  // namespace fulcrum::lab
