// SPDX-License-Identifier: Apache-2.0
// Seeded lattice noise: the same value for the same arguments on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// 64 mixed bits of a lattice point (finaliser of SplitMix64).
inline std::uint64_t lattice_bits(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) {
    std::uint64_t h = seed * 0x9e3779b97f4a7c15ULL;
    h ^= static_cast<std::uint64_t>(x) * 0xbf58476d1ce4e5b9ULL;
    h = (h ^ (h >> 29U)) * 0x94d049bb133111ebULL;
    h ^= static_cast<std::uint64_t>(y) * 0xd6e8feb86659fd93ULL;
    h = (h ^ (h >> 31U)) * 0xbf58476d1ce4e5b9ULL;
    h ^= static_cast<std::uint64_t>(z) * 0xa0761d6478bd642fULL;
    h = (h ^ (h >> 30U)) * 0x94d049bb133111ebULL;
    return h ^ (h >> 31U);
}

/// Uniform in [0, 1) by lattice point.
inline double lattice_value(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) {
    return static_cast<double>(lattice_bits(x, y, z, seed) >> 11U) * 0x1.0p-53;
}

/// 3 t2 - 2 t3 of t clamped to [0, 1].
inline double smooth_step(double low, double high, double x) {
    double t = (x - low) / (high - low);
    t = t < 0 ? 0 : (t > 1 ? 1 : t);
    return t * t * (3 - 2 * t);
}

/// Smooth value noise in [-1, 1], features of size 1.
double noise3(const Vector3& point, std::uint64_t seed);

/// Sum of octaves of smooth value noise on a torus, each of twice the frequency and `gain` times the
/// amplitude, about [-1, 1].
class TiledNoise {
  public:
    TiledNoise(int cells_x, int cells_y, int octaves, double gain, std::uint64_t seed);
    /// u and v in tiles, periodic with period 1.
    double operator()(double u, double v) const;
    /// The values at u = (i + 0.5) / width for i = 0 .. width - 1, bit for bit; `out` has width places.
    void row(double v, int width, double* out) const;

  private:
    struct Octave {
        int cells_x = 0, cells_y = 0;
        double strength = 0;
        std::vector<float> values;
    };
    std::vector<Octave> octaves_;
};

/// Distances to the nearest and second nearest of one random point per cell on a torus, in cells, and the
/// random number of the nearest point.
struct CellDistance {
    double nearest = 0, second = 0, value = 0;
};
class TiledCells {
  public:
    TiledCells(int cells, std::uint64_t seed);
    /// u and v in tiles.
    CellDistance operator()(double u, double v) const;

  private:
    int cells_;
    std::vector<std::array<float, 3>> points_;  // position in the cell, random number
};

}  // namespace fulcrum
