// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

int channel(const Image& image, int x, int y, int c) {
    x = (x + image.width) % image.width;
    y = (y + image.height) % image.height;
    return image.pixels[static_cast<std::size_t>((y * image.width + x) * image.channels + c)];
}

double mean(const Image& image, int c, double u_low, double u_high) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = static_cast<int>(u_low * image.width); x < static_cast<int>(u_high * image.width); ++x) {
            sum += channel(image, x, y, c);
            ++count;
        }
    }
    return sum / count;
}

// Mean step between neighbours across the tile's border over that inside; 1 if there is no visible seam.
double border_step(const Image& image) {
    double border = 0, inside = 0;
    for (int y = 0; y < image.height; ++y) {
        border += std::abs(channel(image, image.width - 1, y, 1) - channel(image, 0, y, 1));
        for (const int x : {image.width / 5, image.width / 3, image.width / 2 + 9, 3 * image.width / 4})
            inside += 0.25 * std::abs(channel(image, x, y, 1) - channel(image, x + 1, y, 1));
    }
    for (int x = 0; x < image.width; ++x) {
        border += std::abs(channel(image, x, image.height - 1, 1) - channel(image, x, 0, 1));
        for (const int y : {image.height / 5, image.height / 3, image.height / 2 + 9, 3 * image.height / 4})
            inside += 0.25 * std::abs(channel(image, x, y, 1) - channel(image, x, y + 1, 1));
    }
    return border / inside;
}

TEST(Textures, SizesAndChannelsAreRightAndBytesRepeat) {
    const AnatomyTextures one = make_textures(5, 256), two = make_textures(5, 256),
                          other = make_textures(6, 256);
    EXPECT_EQ(one.serosa.albedo.width, 256);
    EXPECT_EQ(one.serosa.albedo.height, 512);
    const TissueTexture* mine[] = {&one.serosa, &one.fat, &one.peritoneum, &one.steel};
    const TissueTexture* again[] = {&two.serosa, &two.fat, &two.peritoneum, &two.steel};
    for (int i = 0; i < 4; ++i) {
        for (const Image* image : {&mine[i]->albedo, &mine[i]->normal}) {
            EXPECT_EQ(image->pixels.size(), static_cast<std::size_t>(image->width * image->height * 4));
        }
        EXPECT_EQ(mine[i]->albedo.pixels, again[i]->albedo.pixels);
        EXPECT_EQ(mine[i]->normal.pixels, again[i]->normal.pixels);
    }
    EXPECT_NE(one.serosa.albedo.pixels, other.serosa.albedo.pixels);
}

TEST(Textures, TilesAreSeamless) {
    const AnatomyTextures textures = make_textures(1, 512);
    for (const TissueTexture* texture : {&textures.serosa, &textures.fat, &textures.peritoneum}) {
        EXPECT_LT(border_step(texture->albedo), 1.5);
        EXPECT_LT(border_step(texture->normal), 1.5);
    }
}

TEST(Textures, NormalsAreUnitAndPointOutward) {
    const AnatomyTextures textures = make_textures(1, 256);
    for (const TissueTexture* texture :
         {&textures.serosa, &textures.fat, &textures.peritoneum, &textures.steel}) {
        const Image& n = texture->normal;
        for (int y = 0; y < n.height; y += 7) {
            for (int x = 0; x < n.width; x += 5) {
                double square = 0;
                for (int c = 0; c < 3; ++c) square += std::pow(channel(n, x, y, c) / 127.5 - 1, 2);
                EXPECT_NEAR(square, 1, 0.03);
                EXPECT_GT(channel(n, x, y, 2), 127);
            }
        }
    }
}

TEST(Textures, ColoursMatchTheTissue) {
    const AnatomyTextures textures = make_textures(1, 512);
    const Image& serosa = textures.serosa.albedo;
    // Pink between the taeniae (u = 1/3), pale on them (u = 1/2).
    const double red = mean(serosa, 0, 0.30, 0.37), green = mean(serosa, 1, 0.30, 0.37),
                 blue = mean(serosa, 2, 0.30, 0.37);
    EXPECT_GT(red, 1.4 * green);
    EXPECT_GT(green, blue);
    EXPECT_GT(mean(serosa, 1, 0.485, 0.515), 1.2 * green);
    const Image& fat = textures.fat.albedo;
    EXPECT_GT(mean(fat, 1, 0, 1), 1.5 * mean(fat, 2, 0, 1));
    EXPECT_GT(mean(fat, 0, 0, 1), mean(fat, 1, 0, 1));
    const Image& wall = textures.peritoneum.albedo;
    EXPECT_LT(mean(wall, 0, 0, 1), 1.6 * mean(wall, 1, 0, 1));
    const Image& steel = textures.steel.albedo;
    EXPECT_NEAR(mean(steel, 0, 0, 1), mean(steel, 2, 0, 1), 14);
    // Vessels: some texels much redder than their surroundings, most not.
    int vessels = 0;
    for (int y = 0; y < serosa.height; ++y) {
        for (int x = static_cast<int>(0.25 * serosa.width); x < static_cast<int>(0.42 * serosa.width); ++x)
            vessels += channel(serosa, x, y, 1) < 0.72 * green ? 1 : 0;
    }
    const double share = vessels / (0.17 * serosa.width * serosa.height);
    EXPECT_GT(share, 0.005);
    EXPECT_LT(share, 0.25);
}

TEST(Textures, AreolarTextureHasPaleFibresOverFatAndIsSeamless) {
    const TissueTexture areolar = make_areolar_texture(4, 256), again = make_areolar_texture(4, 256);
    const Image& colour = areolar.albedo;
    EXPECT_EQ(colour.pixels, again.albedo.pixels);
    EXPECT_NE(colour.pixels, make_areolar_texture(5, 256).albedo.pixels);
    EXPECT_GT(mean(colour, 0, 0, 1), mean(colour, 1, 0, 1));
    EXPECT_GT(mean(colour, 1, 0, 1), mean(colour, 2, 0, 1));
    int pale = 0;
    for (int y = 0; y < colour.height; ++y) {
        for (int x = 0; x < colour.width; ++x) pale += channel(colour, x, y, 2) > 165 ? 1 : 0;
    }
    const double share = pale / (1.0 * colour.width * colour.height);
    EXPECT_GT(share, 0.03);
    EXPECT_LT(share, 0.5);
    EXPECT_LT(border_step(colour), 2.0);
    EXPECT_THROW(make_areolar_texture(4, 300), InputError);
}

TEST(Textures, SizesOtherThanPowersOfTwoAreRefused) {
    EXPECT_THROW(make_textures(1, 300), InputError);
    EXPECT_THROW(make_textures(1, 64), InputError);
}

}  // namespace
}  // namespace fulcrum
