// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/display_skin.h"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace fulcrum {
namespace {

constexpr int lanes = 16;                  // vertices per block: two 256-bit or one 512-bit float register
constexpr int row_terms = 4 * skin_rings;  // W_j, Y_j
constexpr std::size_t block_floats = static_cast<std::size_t>(lanes) * row_terms;
constexpr double length_unit = 1.0 / 64;  // m, unit of ring positions in tangent terms: scales W and Y alike
constexpr double tangent_step = 1e-6;     // m, forward difference of the rows along the rest surface

// Row terms in the order W_0, Y_0x, Y_0y, Y_0z, W_1 ...
using Terms = std::array<double, row_terms>;

Terms terms_of(const SkinRow& row) {
    Terms terms;
    for (std::size_t j = 0; j < skin_rings; ++j) {
        terms[4 * j] = row.weight[j];
        for (std::size_t i = 0; i < 3; ++i) terms[4 * j + 1 + i] = row.offset[j][static_cast<int>(i)];
    }
    return terms;
}

void store_position(const SkinRow& row, float* block, int lane) {
    const Terms terms = terms_of(row);
    for (std::size_t i = 0; i < row_terms; ++i)
        block[i * lanes + static_cast<std::size_t>(lane)] = static_cast<float>(terms[i]);
}

// Change of the row along a tangent, scaled to the range of 16 bits: a normal needs only the directions of
// its tangents.
void store_tangent(const SkinRow& moved, const SkinRow& row, std::int16_t* block, int lane) {
    const Terms after = terms_of(moved), before = terms_of(row);
    Terms change;
    double largest = 0.0;
    for (std::size_t i = 0; i < row_terms; ++i) {
        change[i] = (after[i] - before[i]) * (i % 4 == 0 ? length_unit : 1.0);
        largest = std::max(largest, std::abs(change[i]));
    }
    const double scale = largest > 0.0 ? 32767.0 / largest : 0.0;
    for (std::size_t i = 0; i < row_terms; ++i) {
        block[i * lanes + static_cast<std::size_t>(lane)] =
            static_cast<std::int16_t>(std::lround(scale * change[i]));
    }
}

// A right-handed pair of unit tangents: first x second = normal.
void tangents_of(const Vector3& normal, Vector3& first, Vector3& second) {
    const Vector3 axis = std::abs(normal.x()) < 0.9 ? Vector3::UnitX() : Vector3::UnitY();
    first = axis.cross(normal).normalized();
    second = normal.cross(first);
}

struct Lanes {
    float x[lanes], y[lanes], z[lanes];
};

// The weights of a tangent sum to zero, so the origin of the ring positions is arbitrary: relative to the
// first ring they are small and sixteen bits lose nothing visible.
inline void shift_rings(const float* ring, float* shifted) {
    for (int j = 0; j < skin_rings; ++j) {
        for (int i = 0; i < 12; ++i) {
            shifted[12 * j + i] = i < 3 ? (ring[12 * j + i] - ring[i]) * static_cast<float>(1.0 / length_unit)
                                        : ring[12 * j + i];
        }
    }
}

// sum over rings of W_j c_j + R_j Y_j for one block; ring: 12 floats each, position then rotation by columns.
#if defined(__AVX2__) && defined(__FMA__)
inline __m256 load_eight(const float* values) {
    return _mm256_loadu_ps(values);
}
inline __m256 load_eight(const std::int16_t* values) {
    const __m128i packed = _mm_loadu_si128(reinterpret_cast<const __m128i*>(values));
    return _mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(packed));
}

// The compiler spills the six sums of a block unless they are written out.
template <typename Value>
inline void accumulate(const Value* block, const float* ring, Lanes& out) {
    static_assert(lanes == 16, "two registers of eight");
    __m256 x0 = _mm256_setzero_ps(), x1 = x0, y0 = x0, y1 = x0, z0 = x0, z1 = x0;
    for (int term = 0; term < row_terms; ++term) {
        const __m256 low = load_eight(block + term * lanes), high = load_eight(block + term * lanes + 8);
        const __m256 fx = _mm256_broadcast_ss(ring + 3 * term), fy = _mm256_broadcast_ss(ring + 3 * term + 1),
                     fz = _mm256_broadcast_ss(ring + 3 * term + 2);
        x0 = _mm256_fmadd_ps(low, fx, x0);
        x1 = _mm256_fmadd_ps(high, fx, x1);
        y0 = _mm256_fmadd_ps(low, fy, y0);
        y1 = _mm256_fmadd_ps(high, fy, y1);
        z0 = _mm256_fmadd_ps(low, fz, z0);
        z1 = _mm256_fmadd_ps(high, fz, z1);
    }
    _mm256_storeu_ps(out.x, x0);
    _mm256_storeu_ps(out.x + 8, x1);
    _mm256_storeu_ps(out.y, y0);
    _mm256_storeu_ps(out.y + 8, y1);
    _mm256_storeu_ps(out.z, z0);
    _mm256_storeu_ps(out.z + 8, z1);
}
#else
template <typename Value>
inline void accumulate(const Value* block, const float* ring, Lanes& out) {
    out = Lanes{};
    for (int term = 0; term < row_terms; ++term) {
        for (int l = 0; l < lanes; ++l) {
            const float value = static_cast<float>(block[term * lanes + l]);
            out.x[l] += value * ring[3 * term];
            out.y[l] += value * ring[3 * term + 1];
            out.z[l] += value * ring[3 * term + 2];
        }
    }
}
#endif

// 1 / sqrt(x), relative error below 1e-6, x > 0: a seed from the exponent and three Newton steps. Unlike the
// library's square root it sets no errno, so the compiler can vectorise it.
inline float inverse_root(float x) {
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    bits = 0x5f375a86u - (bits >> 1);
    float y;
    std::memcpy(&y, &bits, sizeof y);
    const float half = 0.5f * x;
    y *= 1.5f - half * y * y;
    y *= 1.5f - half * y * y;
    y *= 1.5f - half * y * y;
    return y;
}

inline void cross_unit(const Lanes& a, const Lanes& b, Lanes& out) {
    for (int l = 0; l < lanes; ++l) {
        const float x = a.y[l] * b.z[l] - a.z[l] * b.y[l];
        const float y = a.z[l] * b.x[l] - a.x[l] * b.z[l];
        const float z = a.x[l] * b.y[l] - a.y[l] * b.x[l];
        const float scale = inverse_root(x * x + y * y + z * z + 1e-30f);
        out.x[l] = x * scale;
        out.y[l] = y * scale;
        out.z[l] = z * scale;
    }
}

inline void scatter(const Lanes& values, const std::int32_t* vertices, float* out) {
    for (int l = 0; l < lanes; ++l) {
        const std::int32_t v = vertices[l];
        if (v < 0) break;
        out[3 * v] = values.x[l];
        out[3 * v + 1] = values.y[l];
        out[3 * v + 2] = values.z[l];
    }
}

}  // namespace

DisplaySkin::DisplaySkin(const BowelSkin& skin)
    : skin_(&skin), vertices_(skin.vertices()), rings_(skin.rings()) {
    SkinBinder binder(skin.cage());
    const auto& order = skin.by_ring();
    const auto& offsets = skin.by_ring_offsets();
    for (int r = 0; r < rings_; ++r) {
        const auto begin = offsets[static_cast<std::size_t>(r)],
                   end = offsets[static_cast<std::size_t>(r) + 1];
        for (std::int32_t first = begin; first < end; first += lanes) {
            block_ring_.push_back(r);
            position_rows_.resize(position_rows_.size() + block_floats, 0.0f);
            tangent_rows_.resize(tangent_rows_.size() + 2 * block_floats, 0);
            float* const position = position_rows_.data() + position_rows_.size() - block_floats;
            std::int16_t* const tangent = tangent_rows_.data() + tangent_rows_.size() - 2 * block_floats;
            for (int l = 0; l < lanes; ++l) {
                const std::int32_t v = first + l < end ? order[static_cast<std::size_t>(first + l)] : -1;
                block_vertices_.push_back(v);
                if (v < 0) continue;
                const auto n = static_cast<std::size_t>(v);
                const Vector3& point = skin.rest().vertices[n];
                const int gap = binder.gap_of(point);
                Vector3 directions[2];
                tangents_of(skin.rest_normals()[n], directions[0], directions[1]);
                store_position(skin.rows()[n], position, l);
                for (int t = 0; t < 2; ++t) {
                    const SkinRow moved = binder.bind(gap, point + tangent_step * directions[t]);
                    store_tangent(moved, skin.rows()[n], tangent + static_cast<std::size_t>(t) * block_floats,
                                  l);
                }
            }
        }
    }
}

void DisplaySkin::evaluate(const RingFrame* frames, float* ring_floats, float* positions,
                           float* normals) const {
    for (int r = 0; r < rings_; ++r) {
        float* const ring = ring_floats + 12 * r;
        for (int i = 0; i < 3; ++i) ring[i] = static_cast<float>(frames[r].position[i]);
        for (int column = 0; column < 3; ++column) {
            for (int i = 0; i < 3; ++i) {
                ring[3 + 3 * column + i] = static_cast<float>(frames[r].rotation(i, column));
            }
        }
    }
    std::int32_t shifted_for = -1;
    float shifted[12 * skin_rings];  // rings of the block for its tangents: relative to the first ring, in
                                     // length units
    for (std::size_t block = 0; block < block_ring_.size(); ++block) {
        const float* const ring = ring_floats + 12 * block_ring_[block];
        const std::int32_t* const vertices = block_vertices_.data() + block * lanes;
        Lanes values;
        accumulate(position_rows_.data() + block * block_floats, ring, values);
        scatter(values, vertices, positions);
        if (normals == nullptr) continue;
        if (shifted_for != block_ring_[block]) {
            shifted_for = block_ring_[block];
            shift_rings(ring, shifted);
        }
        Lanes first, second;
        accumulate(tangent_rows_.data() + 2 * block * block_floats, shifted, first);
        accumulate(tangent_rows_.data() + (2 * block + 1) * block_floats, shifted, second);
        cross_unit(first, second, values);
        scatter(values, vertices, normals);
    }
}

void DisplaySkin::add_dents(const DentVertex* dents, int count, float* positions, float* normals) const {
    for (int i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            positions[3 * dents[i].vertex + axis] += static_cast<float>(dents[i].displacement[axis]);
        }
    }
    if (normals == nullptr) return;
    const auto position = [positions](std::int32_t v) {
        return Eigen::Vector3f(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
    };
    const auto renew = [&](std::int32_t vertex) {
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        for (const auto t : skin_->adjacency().triangles_of(vertex)) {
            const Triangle& triangle = skin_->rest().triangles[static_cast<std::size_t>(t)];
            const Eigen::Vector3f a = position(triangle[0]);
            sum += (position(triangle[1]) - a).cross(position(triangle[2]) - a);
        }
        const float length = sum.norm();
        if (!(length > 0.0f)) return;
        for (int axis = 0; axis < 3; ++axis) normals[3 * vertex + axis] = sum[axis] / length;
    };
    for (int i = 0; i < count; ++i) {
        renew(dents[i].vertex);
        for (const auto neighbour : skin_->adjacency().neighbours_of(dents[i].vertex)) renew(neighbour);
    }
}

std::size_t DisplaySkin::bytes() const {
    return sizeof(float) * position_rows_.size() + sizeof(std::int16_t) * tangent_rows_.size() +
           sizeof(std::int32_t) * (block_ring_.size() + block_vertices_.size());
}

}  // namespace fulcrum
