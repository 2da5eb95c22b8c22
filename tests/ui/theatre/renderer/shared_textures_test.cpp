// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/shared_textures.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace fulcrum::ui {
namespace {

TEST(SharedTextures, AreMadeOnceForEachSeedAndSize) {
    std::array<std::shared_ptr<const AnatomyTextures>, 2> both;
    std::thread other([&] { both[0] = shared_textures(7, 128); });
    both[1] = shared_textures(7, 128);
    other.join();
    EXPECT_EQ(both[0], both[1]);
    EXPECT_EQ(both[0]->fat.albedo.pixels, make_textures(7, 128).fat.albedo.pixels);
    EXPECT_NE(shared_textures(8, 128), both[0]);
    EXPECT_NE(shared_textures(7, 256)->serosa.albedo.width, both[0]->serosa.albedo.width);
    EXPECT_EQ(shared_areolar_texture(), shared_areolar_texture());
}

TEST(SharedTextures, OfAWallAreMadeOnceForEachCavityAndPeritoneum) {
    PelvisParameters pelvis;
    const CavityShape cavity = make_cavity(pelvis);
    pelvis.width = 0.11;
    const CavityShape other = make_cavity(pelvis);
    const std::shared_ptr<const TissueTexture> wall = shared_wall_texture(cavity, 7, 128);
    EXPECT_EQ(shared_wall_texture(make_cavity({}), 7, 128), wall);
    EXPECT_EQ(wall->albedo.pixels,
              make_wall_texture(cavity, shared_textures(7, 128)->peritoneum).albedo.pixels);
    EXPECT_NE(shared_wall_texture(other, 7, 128)->albedo.pixels, wall->albedo.pixels);
    EXPECT_EQ(shared_wall_texture(cavity, 7, 128), wall);
    EXPECT_NE(shared_wall_texture(cavity, 8, 128)->albedo.pixels, wall->albedo.pixels);
}

TEST(SharedTextures, OnlyTheLastTwoOutliveTheirUsers) {
    const std::weak_ptr<const AnatomyTextures> first = shared_textures(11, 128),
                                               second = shared_textures(12, 128);
    EXPECT_FALSE(first.expired());
    shared_textures(11, 128);  // the newest again
    shared_textures(13, 128);
    EXPECT_FALSE(first.expired());
    EXPECT_TRUE(second.expired());
}

}  // namespace
}  // namespace fulcrum::ui
