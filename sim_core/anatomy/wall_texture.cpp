// SPDX-License-Identifier: Apache-2.0
// Texture of the wall: three projections of the peritoneum blended once, so that rendering needs one look-up
// instead of three.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr double tile = 0.12;             // m, as for the peritoneum
constexpr double plane_threshold = 0.52;  // weight below which a projection is not visible

std::size_t offset(const Image& image, int i, int j) {
    return static_cast<std::size_t>(image.channels) *
           (static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) +
            static_cast<std::size_t>(i));
}

// Four channels, half the size: each pixel is the mean of four.
Image halved(const Image& image) {
    Image half{image.width / 2, image.height / 2, 4, {}};
    half.pixels.resize(image.pixels.size() / 4);
    for (int j = 0; j < half.height; ++j) {
        for (int i = 0; i < half.width; ++i) {
            for (std::size_t c = 0; c < 4; ++c) {
                const int sum = image.pixels[offset(image, 2 * i, 2 * j) + c] +
                                image.pixels[offset(image, 2 * i + 1, 2 * j) + c] +
                                image.pixels[offset(image, 2 * i, 2 * j + 1) + c] +
                                image.pixels[offset(image, 2 * i + 1, 2 * j + 1) + c];
                half.pixels[offset(half, i, j) + c] = static_cast<std::uint8_t>((sum + 2) / 4);
            }
        }
    }
    return half;
}

using Pixel = Eigen::Array4f;

// Bilinear sample of a periodic tile; u and v in tiles.
Pixel sample(const Image& image, double u, double v) {
    const double x = (u - std::floor(u)) * image.width - 0.5, y = (v - std::floor(v)) * image.height - 0.5;
    const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    const auto fx = static_cast<float>(x - i), fy = static_cast<float>(y - j);
    const auto at = [&image](int column, int row) {
        const std::uint8_t* p = image.pixels.data() + offset(image, (column + image.width) % image.width,
                                                             (row + image.height) % image.height);
        return Pixel(p[0], p[1], p[2], p[3]);
    };
    return (1 - fy) * ((1 - fx) * at(i, j) + fx * at(i + 1, j)) +
           fy * ((1 - fx) * at(i, j + 1) + fx * at(i + 1, j + 1));
}

// A closed tube of rows between two poles, as created by make_cavity.
struct Rows {
    explicit Rows(const TriangleMesh& mesh) : mesh_(mesh) {
        const auto last = static_cast<std::int32_t>(mesh.vertices.size()) - 1;
        for (const Triangle& triangle : mesh.triangles) {
            if (std::find(triangle.begin(), triangle.end(), 0) != triangle.end()) ++columns_;
        }
        if (columns_ < 3 || (last - 1) % columns_ != 0 ||
            mesh.texture_coordinates.size() != mesh.vertices.size())
            throw InputError("wall texture", "mesh", "the mesh is not a tube of rows between two poles",
                             "give a cavity made by make_cavity");
        for (const Triangle& triangle : mesh.triangles) {
            for (const auto vertex : triangle) {
                if (vertex < 0 || vertex > last)
                    throw InputError("wall texture", "mesh", "a triangle uses a vertex that does not exist",
                                     "give a complete mesh");
            }
        }
        normals_ = vertex_normals(mesh);
        rows_ = (last - 1) / columns_;
        heights_.push_back(0);
        for (int row = 0; row < rows_; ++row)
            heights_.push_back(mesh.texture_coordinates[static_cast<std::size_t>(1 + row * columns_)].y());
        heights_.push_back(1);
    }

    // Vertex of a row (0 and rows + 1: the poles) and a column.
    std::size_t vertex(int row, int column) const {
        if (row <= 0) return 0;
        if (row > rows_) return mesh_.vertices.size() - 1;
        return static_cast<std::size_t>(1 + (row - 1) * columns_ + column % columns_);
    }
    // Row below the height v, and the fraction of v above it, 0 .. 1.
    std::pair<int, double> below(double v) const {
        const auto above = std::upper_bound(heights_.begin() + 1, heights_.end() - 1, v);
        const auto row = static_cast<std::size_t>(above - heights_.begin()) - 1;
        return {static_cast<int>(row),
                std::clamp((v - heights_[row]) / (heights_[row + 1] - heights_[row]), 0.0, 1.0)};
    }
    double girth() const {
        double widest = 0;
        for (int row = 1; row <= rows_; ++row) {
            double length = 0;
            for (int k = 0; k < columns_; ++k)
                length += (mesh_.vertices[vertex(row, k + 1)] - mesh_.vertices[vertex(row, k)]).norm();
            widest = std::max(widest, length);
        }
        return widest;
    }

    const TriangleMesh& mesh_;
    std::vector<Vector3> normals_;
    std::vector<double> heights_;
    int columns_ = 0, rows_ = 0;
};

}  // namespace

TissueTexture make_wall_texture(const CavityShape& cavity, const TissueTexture& peritoneum, int width) {
    if (width < 128 || width > 4096)
        throw InputError("texture parameters", "width", "the value is out of range", "give 128 to 4096");
    const Rows rows(cavity.mesh);
    Image albedo = peritoneum.albedo, relief = peritoneum.normal;
    // A tile finer than the wall's own pixels would only cause sparkle.
    const double pixel = rows.girth() / width;
    while (2 * tile / albedo.width <= pixel && albedo.width % 2 == 0 && albedo.width > 16) {
        albedo = halved(albedo);
        relief = halved(relief);
    }
    TissueTexture wall;
    wall.albedo = {width, width / 2, 4, {}};
    wall.normal = wall.albedo;
    for (Image* image : {&wall.albedo, &wall.normal})
        image->pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(width / 2));
    for (int j = 0; j < wall.albedo.height; ++j) {
        const auto [row, up] = rows.below((j + 0.5) / wall.albedo.height);
        for (int i = 0; i < width; ++i) {
            const double along = (i + 0.5) / width * rows.columns_;
            const int column = static_cast<int>(along);
            const double across = along - column;
            const std::array<std::size_t, 4> corner = {rows.vertex(row, column), rows.vertex(row, column + 1),
                                                       rows.vertex(row + 1, column),
                                                       rows.vertex(row + 1, column + 1)};
            const std::array<double, 4> share = {(1 - across) * (1 - up), across * (1 - up),
                                                 (1 - across) * up, across * up};
            Vector3 place = Vector3::Zero(), normal = Vector3::Zero();
            double fat = 0;
            for (std::size_t c = 0; c < 4; ++c) {
                place += share[c] * cavity.mesh.vertices[corner[c]];
                normal += share[c] * rows.normals_[corner[c]];
                fat += share[c] * static_cast<double>(cavity.fat[corner[c]]);
            }
            normal.normalize();
            Vector3 weight = (normal.cwiseAbs().array() - plane_threshold).max(0.0);
            weight /= weight.sum() + 1e-9;
            Pixel colour = Pixel::Zero();
            Vector3 raised = Vector3::Zero();
            for (int axis = 0; axis < 3; ++axis) {
                if (weight[axis] <= 0) continue;
                const int first = (axis + 1) % 3, second = (axis + 2) % 3;
                const double u = place[first] / tile, v = place[second] / tile;
                colour += static_cast<float>(weight[axis]) * sample(albedo, u, v);
                const Pixel slope = sample(relief, u, v) / 127.5F - 1.0F;
                raised[first] += weight[axis] * static_cast<double>(slope[0]);
                raised[second] += weight[axis] * static_cast<double>(slope[1]);
            }
            // Fat beneath the film: yellow where there is much of it. Light adds linearly, not in sRGB.
            const Eigen::Array3f plain = (colour.head<3>() / 255.0F).square();
            const Eigen::Array3f yellow =
                plain * Eigen::Array3f(1.10F, 1.02F, 0.62F) + Eigen::Array3f(0.10F, 0.055F, 0.0F);
            const Eigen::Array3f own =
                (plain + static_cast<float>(0.8 * fat) * (yellow - plain)).min(1.0F).sqrt();
            const std::size_t at = offset(wall.albedo, i, j);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto k = static_cast<Eigen::Index>(c);
                wall.albedo.pixels[at + c] = static_cast<std::uint8_t>(255.0F * own[k] + 0.5F);
                wall.normal.pixels[at + c] =
                    static_cast<std::uint8_t>(std::clamp(127.5 * (raised[k] + 1.0), 0.0, 255.0) + 0.5);
            }
            wall.albedo.pixels[at + 3] = static_cast<std::uint8_t>(0.7F * colour[3] + 0.5F);
            wall.normal.pixels[at + 3] = 255;
        }
    }
    return wall;
}

}  // namespace fulcrum
