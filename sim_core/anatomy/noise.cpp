// SPDX-License-Identifier: Apache-2.0
#include "sim_core/anatomy/noise.h"

#include <algorithm>

namespace fulcrum {
namespace {

// Smooth to second order: value noise without visible lattice lines in its gradient.
double fade(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

}  // namespace

double noise3(const Vector3& point, std::uint64_t seed) {
    const double fx = std::floor(point.x()), fy = std::floor(point.y()), fz = std::floor(point.z());
    const auto x = static_cast<std::int64_t>(fx), y = static_cast<std::int64_t>(fy),
               z = static_cast<std::int64_t>(fz);
    const double u = fade(point.x() - fx), v = fade(point.y() - fy), w = fade(point.z() - fz);
    double plane[2];
    for (int k = 0; k < 2; ++k) {
        const double a = lattice_value(x, y, z + k, seed), b = lattice_value(x + 1, y, z + k, seed);
        const double c = lattice_value(x, y + 1, z + k, seed), d = lattice_value(x + 1, y + 1, z + k, seed);
        const double low = a + u * (b - a), high = c + u * (d - c);
        plane[k] = low + v * (high - low);
    }
    return 2 * (plane[0] + w * (plane[1] - plane[0])) - 1;
}

TiledNoise::TiledNoise(int cells_x, int cells_y, int octaves, double gain, std::uint64_t seed) {
    double strength = 1, total = 0;
    for (int i = 0; i < octaves; ++i) {
        Octave octave;
        octave.cells_x = cells_x;
        octave.cells_y = cells_y;
        octave.strength = strength;
        for (int y = 0; y < cells_y; ++y) {
            for (int x = 0; x < cells_x; ++x)
                octave.values.push_back(static_cast<float>(2 * lattice_value(x, y, i, seed) - 1));
        }
        total += strength;
        strength *= gain;
        cells_x *= 2;
        cells_y *= 2;
        octaves_.push_back(std::move(octave));
    }
    for (Octave& octave : octaves_) octave.strength /= total;
}

double TiledNoise::operator()(double u, double v) const {
    u -= std::floor(u);
    v -= std::floor(v);
    double sum = 0;
    for (const Octave& octave : octaves_) {
        const double x = u * octave.cells_x, y = v * octave.cells_y;
        const int x0 = std::min(static_cast<int>(x), octave.cells_x - 1),
                  y0 = std::min(static_cast<int>(y), octave.cells_y - 1);
        const double s = fade(x - x0), t = fade(y - y0);
        const int x1 = x0 + 1 == octave.cells_x ? 0 : x0 + 1, y1 = y0 + 1 == octave.cells_y ? 0 : y0 + 1;
        const float* low = octave.values.data() + y0 * octave.cells_x;
        const float* high = octave.values.data() + y1 * octave.cells_x;
        const double a = low[x0] + s * (low[x1] - low[x0]), b = high[x0] + s * (high[x1] - high[x0]);
        sum += octave.strength * (a + t * (b - a));
    }
    return sum;
}

void TiledNoise::row(double v, int width, double* out) const {
    std::fill(out, out + width, 0.0);
    v -= std::floor(v);
    for (const Octave& octave : octaves_) {
        const int cells = octave.cells_x;
        const double y = v * octave.cells_y, strength = octave.strength;
        const int y0 = std::min(static_cast<int>(y), octave.cells_y - 1);
        const int y1 = y0 + 1 == octave.cells_y ? 0 : y0 + 1;
        const double t = fade(y - y0);
        const float* low = octave.values.data() + y0 * cells;
        const float* high = octave.values.data() + y1 * cells;
        const auto place = [&](int i) { return (i + 0.5) / width * cells; };
        for (int i = 0, end = 0; i < width; i = end) {
            // The pixels of one cell: the lattice is read once for them, and the loop over them has no
            // branch.
            const int x0 = std::min(static_cast<int>(place(i)), cells - 1), x1 = x0 + 1 == cells ? 0 : x0 + 1;
            end = std::clamp(static_cast<int>((x0 + 1.0) * width / cells - 0.5), i + 1, width);
            while (end < width && place(end) < x0 + 1) ++end;
            while (end > i + 1 && place(end - 1) >= x0 + 1) --end;
            if (x0 == cells - 1) end = width;
            const double a0 = low[x0], a1 = low[x1] - low[x0], b0 = high[x0], b1 = high[x1] - high[x0];
            for (int k = i; k < end; ++k) {
                const double s = fade(place(k) - x0);
                const double a = a0 + s * a1, b = b0 + s * b1;
                out[k] += strength * (a + t * (b - a));
            }
        }
    }
}

TiledCells::TiledCells(int cells, std::uint64_t seed) : cells_(cells) {
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            points_.push_back({static_cast<float>(lattice_value(x, y, 1, seed)),
                               static_cast<float>(lattice_value(x, y, 2, seed)),
                               static_cast<float>(lattice_value(x, y, 3, seed))});
        }
    }
}

CellDistance TiledCells::operator()(double u, double v) const {
    const double x = (u - std::floor(u)) * cells_, y = (v - std::floor(v)) * cells_;
    const int cx = std::min(static_cast<int>(x), cells_ - 1), cy = std::min(static_cast<int>(y), cells_ - 1);
    double first = 1e9, second = 1e9;
    CellDistance result;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const auto& point = points_[static_cast<std::size_t>((cy + j + cells_) % cells_ * cells_ +
                                                                 (cx + i + cells_) % cells_)];
            const double dx = cx + i + static_cast<double>(point[0]) - x,
                         dy = cy + j + static_cast<double>(point[1]) - y;
            const double distance = dx * dx + dy * dy;
            if (distance < first) {
                second = first;
                first = distance;
                result.value = static_cast<double>(point[2]);
            } else {
                second = std::min(second, distance);
            }
        }
    }
    result.nearest = std::sqrt(first);
    result.second = std::sqrt(second);
    return result;
}

}  // namespace fulcrum
