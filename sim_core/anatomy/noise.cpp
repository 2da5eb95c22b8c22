// SPDX-License-Identifier: Apache-2.0
#include "sim_core/anatomy/noise.h"

#include <algorithm>

namespace fulcrum {
namespace {

// Second-order smooth: value noise without visible lattice lines in its gradient.
double fade(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

std::int64_t wrap(std::int64_t i, int period) {
    const std::int64_t r = i % period;
    return r < 0 ? r + period : r;
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

double tiled_noise(double x, double y, int period_x, int period_y, std::uint64_t seed) {
    const double fx = std::floor(x), fy = std::floor(y);
    const double u = fade(x - fx), v = fade(y - fy);
    const std::int64_t x0 = wrap(static_cast<std::int64_t>(fx), period_x), x1 = wrap(x0 + 1, period_x);
    const std::int64_t y0 = wrap(static_cast<std::int64_t>(fy), period_y), y1 = wrap(y0 + 1, period_y);
    const double a = lattice_value(x0, y0, 0, seed), b = lattice_value(x1, y0, 0, seed);
    const double c = lattice_value(x0, y1, 0, seed), d = lattice_value(x1, y1, 0, seed);
    const double low = a + u * (b - a), high = c + u * (d - c);
    return 2 * (low + v * (high - low)) - 1;
}

double tiled_turbulence(double x, double y, int cells_x, int cells_y, int octaves, double gain,
                        std::uint64_t seed) {
    double sum = 0, strength = 1, total = 0;
    for (int i = 0; i < octaves; ++i) {
        sum += strength *
               tiled_noise(x * cells_x, y * cells_y, cells_x, cells_y, seed + static_cast<std::uint64_t>(i));
        total += strength;
        strength *= gain;
        cells_x *= 2;
        cells_y *= 2;
    }
    return sum / total;
}

CellDistance tiled_cells(double x, double y, int period_x, int period_y, std::uint64_t seed) {
    const double fx = std::floor(x), fy = std::floor(y);
    CellDistance result;
    double first = 1e9, second = 1e9;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            const std::int64_t cx = wrap(static_cast<std::int64_t>(fx) + i, period_x);
            const std::int64_t cy = wrap(static_cast<std::int64_t>(fy) + j, period_y);
            const std::uint64_t bits = lattice_bits(cx, cy, 1, seed);
            const double px = static_cast<double>(bits & 0xffffU) * 0x1.0p-16;
            const double py = static_cast<double>((bits >> 16U) & 0xffffU) * 0x1.0p-16;
            const double dx = fx + i + px - x, dy = fy + j + py - y;
            const double distance = dx * dx + dy * dy;
            if (distance < first) {
                second = first;
                first = distance;
                result.value = static_cast<double>((bits >> 32U) & 0xffffU) * 0x1.0p-16;
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
