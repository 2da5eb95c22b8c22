// SPDX-License-Identifier: Apache-2.0
// Eight triangles side by side, in single precision: the test that rejects most triangles around a point, one
// instruction for all eight. Any thread; no allocation.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "sim_core/numerics/types.h"

namespace fulcrum {

inline constexpr int packet_size = 8;

/// A point in single precision; the tolerance of the test covers its rounding.
struct FloatPoint {
    explicit FloatPoint(const Vector3& point)
        : x(static_cast<float>(point.x())),
          y(static_cast<float>(point.y())),
          z(static_cast<float>(point.z())) {}
    float x, y, z;
};

/// Four planes per triangle: its own, and one through each edge, perpendicular to it, pointing outward. A
/// lane without a triangle (triangle -1) has planes that no point is near.
struct alignas(32) TrianglePacket {
    float x[4][packet_size], y[4][packet_size], z[4][packet_size], offset[4][packet_size];
    /// For each edge that keeps the feet that fall on it: sine of the ridge angle; the wedge in which feet
    /// fall on the edge is at most distance times it wide (a border: 1e9). -1e9 if the triangle beyond the
    /// edge keeps them.
    float wedge[3][packet_size];
    std::int32_t triangle[packet_size];

    static constexpr float slack =
        2e-6F;  ///< m, rounding error of a plane's height for coordinates below 1 m

    void clear(int lane) {
        for (int plane = 0; plane < 4; ++plane) {
            x[plane][lane] = y[plane][lane] = z[plane][lane] = 0;
            offset[plane][lane] = 1e9F;
        }
        for (auto& edge : wedge) edge[lane] = -1e9F;
        triangle[lane] = -1;
    }
    void copy(int lane, const TrianglePacket& from, int from_lane) {
        for (int plane = 0; plane < 4; ++plane) {
            x[plane][lane] = from.x[plane][from_lane];
            y[plane][lane] = from.y[plane][from_lane];
            z[plane][lane] = from.z[plane][from_lane];
            offset[plane][lane] = from.offset[plane][from_lane];
        }
        for (int edge = 0; edge < 3; ++edge) wedge[edge][lane] = from.wedge[edge][from_lane];
        triangle[lane] = from.triangle[from_lane];
    }
    /// m, over plane 0 (the triangle's own) to 3.
    float height(int plane, int lane, const FloatPoint& at) const {
        return x[plane][lane] * at.x + y[plane][lane] * at.y + z[plane][lane] * at.z - offset[plane][lane];
    }

    /// Tells for each triangle whether a point must be tested against it: yes if concern < 0. A triangle is
    /// skipped only if its foot of the point is further away than reach, or belongs to a neighbour that is at
    /// least as near. Across an edge that is flat or a valley as seen from the free side the neighbour is
    /// nearer; on a ridge the lower number is responsible. Points behind a triangle's plane are always
    /// tested. The value changes by at most the point's motion. Returns a bit mask of the lanes with concern
    /// < limit.
    unsigned concern(const FloatPoint& at, float reach, float limit, float (&result)[packet_size]) const;
};

#if defined(__AVX__)
inline unsigned TrianglePacket::concern(const FloatPoint& at, float reach, float limit,
                                        float (&result)[packet_size]) const {
    const __m256 px = _mm256_set1_ps(at.x), py = _mm256_set1_ps(at.y), pz = _mm256_set1_ps(at.z);
    const auto height_over = [&](int plane) {
        const __m256 in_plane = _mm256_add_ps(_mm256_mul_ps(_mm256_load_ps(x[plane]), px),
                                              _mm256_mul_ps(_mm256_load_ps(y[plane]), py));
        return _mm256_sub_ps(_mm256_add_ps(in_plane, _mm256_mul_ps(_mm256_load_ps(z[plane]), pz)),
                             _mm256_load_ps(offset[plane]));
    };
    const __m256 far = _mm256_set1_ps(reach + slack), sign = _mm256_set1_ps(-0.0F);
    __m256 passed = _mm256_set1_ps(-1e30F), kept = passed;
    for (int edge = 0; edge < 3; ++edge) {
        const __m256 out = height_over(edge + 1);
        passed = _mm256_max_ps(passed, out);
        const __m256 left = _mm256_sub_ps(_mm256_mul_ps(far, _mm256_load_ps(wedge[edge])), out);
        kept = _mm256_max_ps(kept, _mm256_min_ps(out, left));
    }
    const __m256 height = height_over(0);
    // The neighbour's: in front, beyond an edge, and in no wedge that this triangle keeps.
    const __m256 front = _mm256_min_ps(_mm256_min_ps(height, passed), _mm256_xor_ps(kept, sign));
    const __m256 worst = _mm256_max_ps(_mm256_sub_ps(_mm256_andnot_ps(sign, height), far),
                                       _mm256_sub_ps(front, _mm256_set1_ps(slack)));
    _mm256_storeu_ps(result, worst);
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(worst, _mm256_set1_ps(limit), _CMP_LT_OQ)));
}
#else
inline unsigned TrianglePacket::concern(const FloatPoint& at, float reach, float limit,
                                        float (&result)[packet_size]) const {
    const float far = reach + slack;
    unsigned lanes = 0;
    for (int lane = 0; lane < packet_size; ++lane) {
        float passed = -1e30F, kept = passed;
        for (int edge = 0; edge < 3; ++edge) {
            const float out = height(edge + 1, lane, at);
            passed = std::max(passed, out);
            kept = std::max(kept, std::min(out, far * wedge[edge][lane] - out));
        }
        const float over = height(0, lane, at);
        const float front = std::min(std::min(over, passed), -kept);
        result[lane] = std::max(std::abs(over) - far, front - slack);
        if (result[lane] < limit) lanes |= 1U << static_cast<unsigned>(lane);
    }
    return lanes;
}
#endif

/// Bit mask of the lanes with value < limit.
inline unsigned lanes_below(const float (&value)[packet_size], float limit) {
#if defined(__AVX__)
    return static_cast<unsigned>(
        _mm256_movemask_ps(_mm256_cmp_ps(_mm256_loadu_ps(value), _mm256_set1_ps(limit), _CMP_LT_OQ)));
#else
    unsigned lanes = 0;
    for (int lane = 0; lane < packet_size; ++lane) {
        if (value[lane] < limit) lanes |= 1U << static_cast<unsigned>(lane);
    }
    return lanes;
#endif
}

/// Calls visit(lane) for each bit set, lowest first.
template <class Visit>
void for_each_lane(unsigned lanes, Visit&& visit) {
    for (; lanes != 0; lanes &= lanes - 1) visit(__builtin_ctz(lanes));
}

}  // namespace fulcrum
