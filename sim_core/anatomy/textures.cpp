// SPDX-License-Identifier: Apache-2.0
// The textures: colour from seeded noise and grown vessels, relief from the same fields, so that a visible
// vessel is also raised.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/anatomy/noise.h"
#include "sim_core/anatomy/vessels.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

using Colour = Eigen::Array3d;  // sRGB, 0 .. 255

struct Texel {
    Colour colour = Colour::Zero();
    double wetness = 1;  // 0 dry .. 1 wet
    double height = 0;   // mm
};

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5);
}

Colour blend(const Colour& a, const Colour& b, double t) {
    return a + std::clamp(t, 0.0, 1.0) * (b - a);
}

/// Fields of noise at the pixels of the row that is being made: a row at a time costs a third of a pixel at a
/// time.
class NoiseRows {
  public:
    NoiseRows(int width, std::vector<TiledNoise> fields) : fields_(std::move(fields)) {
        rows_.assign(fields_.size(), std::vector<double>(static_cast<std::size_t>(width)));
    }
    void begin(double v) {
        for (std::size_t k = 0; k < fields_.size(); ++k)
            fields_[k].row(v, static_cast<int>(rows_[k].size()), rows_[k].data());
    }
    double at(std::size_t field, int i) const { return rows_[field][static_cast<std::size_t>(i)]; }

  private:
    std::vector<TiledNoise> fields_;
    std::vector<std::vector<double>> rows_;
};

// Evaluates texels and turns heights into normals; the tile measures width_mm by height_mm.
template <typename Shade>
TissueTexture bake(int width, int height, double width_mm, double height_mm, NoiseRows& noise,
                   Shade&& shade) {
    TissueTexture texture;
    const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    texture.albedo = {width, height, 4, std::vector<std::uint8_t>(4 * texels)};
    texture.normal = {width, height, 4, std::vector<std::uint8_t>(4 * texels)};
    std::vector<float> relief(texels);
    for (int j = 0; j < height; ++j) {
        noise.begin((j + 0.5) / height);
        for (int i = 0; i < width; ++i) {
            const std::size_t k =
                static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
            const Texel texel = shade(i, j, (i + 0.5) / width, (j + 0.5) / height);
            for (int c = 0; c < 3; ++c)
                texture.albedo.pixels[4 * k + static_cast<std::size_t>(c)] = byte(texel.colour[c]);
            texture.albedo.pixels[4 * k + 3] = byte(255 * texel.wetness);
            relief[k] = static_cast<float>(texel.height);
        }
    }
    const auto [low, high] = std::minmax_element(relief.begin(), relief.end());
    const double base = *low, range = std::max(1e-6F, *high - *low);
    const auto at = [&](int i, int j) {
        i = (i + width) % width;
        j = (j + height) % height;
        return static_cast<double>(relief[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(i)]);
    };
    const double per_x = width / (2 * width_mm), per_y = height / (2 * height_mm);
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const std::size_t k =
                static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
            const Vector3 normal =
                Vector3((at(i - 1, j) - at(i + 1, j)) * per_x, (at(i, j - 1) - at(i, j + 1)) * per_y, 1)
                    .normalized();
            for (int c = 0; c < 3; ++c)
                texture.normal.pixels[4 * k + static_cast<std::size_t>(c)] = byte(127.5 + 127.5 * normal[c]);
            texture.normal.pixels[4 * k + 3] = byte(255 * (at(i, j) - base) / range);
        }
    }
    return texture;
}

// Share of a taenia at u: three bands at 1/6, 3/6, 5/6 of the circumference.
double taenia_at(double u, double wobble) {
    const double turned = 3 * (u + 1.0 / 6.0) + wobble;
    const double off = std::abs(turned - std::round(turned));
    return 1 - smooth_step(0.055, 0.125, off);
}

TissueTexture serosa(std::uint64_t seed, int size) {
    const int width = size, height = 2 * size;
    VesselField vessels(width, height);
    // Vasa recta run around the tube from the mesenteric side and branch towards the antimesenteric side.
    VesselGrowth growth;
    growth.trees = 26;
    growth.trunk_radius = 0.0032;
    growth.along = Eigen::Vector2d(1, 0);
    growth.reach = 0.46;
    growth.seed = seed + 11;
    vessels.grow(growth);
    growth.trees = 120;
    growth.trunk_radius = 0.0022;
    growth.along = Eigen::Vector2d(0.6, 0.8);
    growth.reach = 0.14;
    growth.seed = seed + 12;
    vessels.grow(growth);
    const Colour pink(216, 118, 106), salmon(196, 86, 72), pale(230, 162, 146), band(240, 208, 188),
        vein(126, 30, 40), artery(176, 34, 30);
    NoiseRows noise(width, {{4, 8, 4, 0.55, seed + 1},
                            {64, 128, 2, 0.6, seed + 2},
                            {96, 12, 2, 0.6, seed + 3},
                            {8, 150, 2, 0.5, seed + 4},
                            {6, 6, 1, 1.0, seed + 5},
                            {9, 18, 1, 1.0, seed + 6}});
    return bake(width, height, 100, 200, noise, [&](int i, int j, double u, double) {
        Texel texel;
        const double cloud = noise.at(0, i);
        const double fine = noise.at(1, i);
        const double fibres = noise.at(2, i);  // stretched along the tube
        const double rings = noise.at(3, i);   // circular muscle visible through the serosa
        const double taenia = taenia_at(u, 0.05 * noise.at(4, i));
        texel.colour = blend(salmon, pink, 0.55 + 0.75 * cloud);
        texel.colour = blend(texel.colour, pale, 0.22 + 0.35 * fine);
        texel.colour *= 1 + 0.035 * rings * (1 - taenia);
        texel.colour = blend(texel.colour, band, taenia * (0.62 + 0.25 * fibres));
        const double vessel = vessels.at(i, j) * (1 - 0.72 * taenia);
        const double kind = smooth_step(-0.15, 0.15, noise.at(5, i));
        texel.colour = blend(texel.colour, blend(artery, vein, kind), 0.62 * vessel);
        // A halo: blood beneath the serosa tints its neighbourhood.
        texel.wetness = 0.86 + 0.14 * fine;
        texel.height =
            0.12 * cloud + 0.05 * fine + 0.16 * vessel + taenia * (0.10 + 0.06 * fibres) + 0.02 * rings;
        return texel;
    });
}

TissueTexture fat(std::uint64_t seed, int size) {
    VesselField vessels(size, size);
    VesselGrowth growth;
    growth.trees = 9;
    growth.trunk_radius = 0.0050;
    growth.along = Eigen::Vector2d(0, 1);
    growth.reach = 0.5;
    growth.seed = seed + 21;
    vessels.grow(growth);
    const Colour bright(238, 196, 104), deep(206, 142, 58), pale(246, 222, 156), cleft(168, 92, 44),
        blood(150, 40, 34);
    NoiseRows noise(size, {{6, 6, 3, 0.5, seed + 22}, {6, 6, 3, 0.5, seed + 23}, {3, 3, 4, 0.5, seed + 26}});
    const TiledCells cells_3(14, seed + 24);
    const TiledCells cells_4(38, seed + 25);
    return bake(size, size, 60, 60, noise, [&](int i, int j, double u, double v) {
        Texel texel;
        const double wx = 0.055 * noise.at(0, i);
        const double wy = 0.055 * noise.at(1, i);
        const CellDistance lobe = cells_3(u + wx, v + wy);
        const CellDistance lobule = cells_4(u + wx, v + wy);
        const double body = smooth_step(0.0, 0.5, lobe.second - lobe.nearest);
        const double small = smooth_step(0.0, 0.45, lobule.second - lobule.nearest);
        const double cloud = noise.at(2, i);
        texel.colour = blend(deep, bright, 0.55 + 0.5 * cloud + 0.35 * (lobe.value - 0.5));
        texel.colour = blend(texel.colour, pale, 0.30 * small * body);
        texel.colour = blend(cleft, texel.colour, 0.35 + 0.50 * body + 0.15 * small);
        const double vessel = vessels.at(i, j);
        texel.colour = blend(texel.colour, blood, 0.5 * vessel);
        texel.wetness = 0.80 + 0.2 * body;
        texel.height = 0.9 * std::sqrt(body) + 0.16 * std::sqrt(small) * body + 0.10 * vessel;
        return texel;
    });
}

TissueTexture peritoneum(std::uint64_t seed, int size) {
    VesselField vessels(size, size);
    VesselGrowth growth;
    growth.trees = 10;
    growth.trunk_radius = 0.0042;
    growth.along = Eigen::Vector2d(0.8, 0.6);
    growth.reach = 0.42;
    growth.seed = seed + 31;
    vessels.grow(growth);
    growth.trees = 50;
    growth.trunk_radius = 0.0022;
    growth.along = Eigen::Vector2d(-0.4, 0.9);
    growth.reach = 0.16;
    growth.seed = seed + 32;
    vessels.grow(growth);
    const Colour grey(200, 150, 140), muscle(166, 74, 66), film(222, 196, 190), vein(104, 66, 92),
        artery(160, 52, 50);
    const TiledNoise lengthwise(7, 44, 3, 0.55, seed + 34);
    NoiseRows noise(size,
                    {{3, 3, 5, 0.55, seed + 33}, {48, 48, 2, 0.6, seed + 35}, {5, 5, 1, 1.0, seed + 36}});
    return bake(size, size, 120, 120, noise, [&](int i, int j, double u, double v) {
        Texel texel;
        const double cloud = noise.at(0, i);
        const double strands = lengthwise(u + 0.04 * cloud, v);
        const double fine = noise.at(1, i);
        texel.colour = blend(grey, muscle, 0.42 + 0.9 * cloud);
        texel.colour = blend(texel.colour, film, 0.26 + 0.30 * strands + 0.12 * fine);
        const double vessel = vessels.at(i, j);
        const double kind = smooth_step(-0.2, 0.2, noise.at(2, i));
        texel.colour = blend(texel.colour, blend(artery, vein, kind), 0.42 * vessel);  // beneath the film
        texel.wetness = 0.9 + 0.1 * fine;
        texel.height = 0.30 * cloud + 0.12 * strands + 0.04 * fine + 0.12 * vessel;
        return texel;
    });
}

TissueTexture steel(std::uint64_t seed, int size) {
    const Colour dark(150, 153, 158), light(206, 209, 214);
    NoiseRows noise(size, {{size / 4, 3, 2, 0.7, seed + 41}, {4, 4, 3, 0.5, seed + 42}});
    return bake(size, size, 20, 20, noise, [&](int i, int, double, double) {
        Texel texel;
        const double brush = noise.at(0, i);
        const double wear = noise.at(1, i);
        texel.colour = blend(dark, light, 0.5 + 0.55 * brush + 0.25 * wear);
        texel.wetness = 0.75 + 0.2 * wear;
        texel.height = 0.006 * brush;
        return texel;
    });
}

void check_size(int size) {
    if (size < 128 || size > 2048 || (size & (size - 1)) != 0)
        throw InputError("texture parameters", "size", "the value is out of range",
                         "give a power of two, 128 to 2048");
}

}  // namespace

TissueTexture make_areolar_texture(std::uint64_t seed, int size) {
    check_size(size);
    const Colour yellow(212, 164, 92), film(214, 178, 160), fibre(246, 236, 226), deep(172, 92, 70);
    NoiseRows noise(size,
                    {{3, 3, 4, 0.55, seed + 51}, {5, 5, 2, 0.5, seed + 55}, {60, 60, 2, 0.6, seed + 54}});
    // Fibres: crests of noise stretched along one direction each, bent by the cloud noise, with varying
    // density.
    const TiledNoise lengthwise(2, 17, 4, 0.62, seed + 52), crosswise(13, 3, 4, 0.62, seed + 53);
    return bake(size, size, 40, 40, noise, [&](int i, int, double u, double v) {
        const auto crest = [](double n) {
            const double ridge = 1 - std::min(1.0, 4.5 * std::abs(n));
            return ridge * ridge;
        };
        Texel texel;
        const double wide = noise.at(0, i), warp = 0.11 * wide, fine = noise.at(2, i);
        const double dense = smooth_step(-0.5, 0.6, noise.at(1, i));
        const double strands = std::max(crest(lengthwise(u + warp, v - warp)) * (0.35 + 0.65 * dense),
                                        crest(crosswise(u - warp, v + warp)) * (0.85 - 0.6 * dense));
        texel.colour = blend(blend(deep, yellow, 0.55 + 0.7 * wide), film, 0.28 + 0.20 * dense + 0.10 * fine);
        texel.colour = blend(texel.colour, fibre, 0.62 * strands);
        texel.wetness = 0.85 + 0.15 * strands;
        texel.height = 0.12 * wide + 0.10 * strands + 0.02 * fine;
        return texel;
    });
}

AnatomyTextures make_textures(std::uint64_t seed, int size) {
    check_size(size);
    AnatomyTextures textures;
    textures.serosa = serosa(seed, size);
    textures.fat = fat(seed, size / 2);
    textures.peritoneum = peritoneum(seed, size);
    textures.steel = steel(seed, std::max(64, size / 8));
    return textures;
}

}  // namespace fulcrum
