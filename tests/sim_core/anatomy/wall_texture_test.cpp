// SPDX-License-Identifier: Apache-2.0
// The wall's texture compared with the tile that it is made from.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

TissueTexture plain_tile(std::uint8_t red, std::uint8_t slope) {
    TissueTexture tile;
    tile.albedo = {64, 64, 4, {}};
    for (int i = 0; i < 64 * 64; ++i)
        tile.albedo.pixels.insert(tile.albedo.pixels.end(), {red, 100, 80, 200});
    tile.normal = {64, 64, 4, {}};
    for (int i = 0; i < 64 * 64; ++i)
        tile.normal.pixels.insert(tile.normal.pixels.end(), {slope, 127, 255, 255});
    return tile;
}

TEST(WallTexture, PlainTileGivesPlainWallWithYellowFat) {
    CavityShape cavity = make_cavity({});
    std::fill(cavity.fat.begin(), cavity.fat.end(), 0.0F);
    const TissueTexture lean = make_wall_texture(cavity, plain_tile(180, 127), 256);
    ASSERT_EQ(lean.albedo.width, 256);
    ASSERT_EQ(lean.albedo.height, 128);
    for (std::size_t k = 0; k < lean.albedo.pixels.size(); k += 4) {
        ASSERT_NEAR(lean.albedo.pixels[k], 180, 1);
        ASSERT_NEAR(lean.albedo.pixels[k + 1], 100, 1);
        ASSERT_NEAR(lean.albedo.pixels[k + 3], 140, 1);  // wetness of a wall: 0.7 of the film's
        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(lean.normal.pixels[k + c], 127.5, 1.0);
    }
    std::fill(cavity.fat.begin(), cavity.fat.end(), 1.0F);
    const TissueTexture fat = make_wall_texture(cavity, plain_tile(180, 127), 256);
    for (std::size_t k = 0; k < fat.albedo.pixels.size(); k += 4) {
        ASSERT_GT(fat.albedo.pixels[k], 190);
        ASSERT_LT(fat.albedo.pixels[k + 2], 80);
    }
}

TEST(WallTexture, ReliefIsInTheWallPlaneAndColoursAreInterpolated) {
    const CavityShape cavity = make_cavity({});
    // The tile slopes along its first axis: projected along x that is y, along y it is z, along z it is x.
    const TissueTexture wall = make_wall_texture(cavity, plain_tile(180, 190), 256);
    const double slope = 190 / 127.5 - 1;
    for (std::size_t k = 0; k < wall.normal.pixels.size(); k += 4) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) sum += wall.normal.pixels[k + c] / 127.5 - 1;
        ASSERT_NEAR(sum, slope, 0.02);  // weights add up to 1; one projection gives to one axis each
    }
    const AnatomyTextures textures = make_textures(3, 128);
    EXPECT_EQ(make_wall_texture(cavity, textures.peritoneum, 256).albedo.pixels,
              make_wall_texture(cavity, textures.peritoneum, 256).albedo.pixels);
}

TEST(WallTexture, RefusesMeshesThatAreNotTubes) {
    CavityShape cavity = make_cavity({});
    EXPECT_THROW(make_wall_texture(cavity, plain_tile(1, 1), 64), InputError);
    cavity.mesh.vertices.pop_back();
    EXPECT_THROW(make_wall_texture(cavity, plain_tile(1, 1), 256), InputError);
}

}  // namespace
}  // namespace fulcrum
