// SPDX-License-Identifier: Apache-2.0
#include "sim_core/anatomy/noise.h"

#include <gtest/gtest.h>

#include <vector>

namespace fulcrum {
namespace {

TEST(TiledNoise, ARowHasTheValuesOfItsPixelsBitForBit) {
    // Also widths that are no multiple of the cells, and cells smaller than a pixel.
    for (const int cells : {1, 3, 7, 64, 150}) {
        const TiledNoise noise(cells, 5, 3, 0.55, 17);
        for (const int width : {1, 16, 100, 128, 1024}) {
            std::vector<double> row(static_cast<std::size_t>(width));
            for (const double v : {0.0, 0.13, 0.999, 1.0, -0.25, 2.6}) {
                noise.row(v, width, row.data());
                for (int i = 0; i < width; ++i)
                    ASSERT_EQ(row[static_cast<std::size_t>(i)], noise((i + 0.5) / width, v))
                        << cells << " cells, pixel " << i << " of " << width << ", v " << v;
            }
        }
    }
}

}  // namespace
}  // namespace fulcrum
