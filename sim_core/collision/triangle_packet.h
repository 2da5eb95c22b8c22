// SPDX-License-Identifier: Apache-2.0
// Eight triangles side by side, in single precision: what tells most triangles around a point off, so that
// one instruction serves eight. Any thread; no allocation.
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

/// A point in single precision: the test's own rounding covers it.
struct FloatPoint {
    explicit FloatPoint(const Vector3& point)
        : x(static_cast<float>(point.x())),
          y(static_cast<float>(point.y())),
          z(static_cast<float>(point.z())) {}
    float x, y, z;
};

/// Of each triangle four planes: its own, and one through each edge, outward and upright on it. A lane
/// without a triangle (triangle -1) has planes that nothing is near.
struct alignas(32) TrianglePacket {
    float x[4][packet_size], y[4][packet_size], z[4][packet_size], offset[4][packet_size];
    /// Of each edge that keeps feet on it: the sine of the ridge's angle, so that the wedge in which feet
    /// fall on it is at most distance times it wide (a rim: 1e9); -1e9 where the triangle beyond has such
    /// feet.
    float wedge[3][packet_size];
    std::int32_t triangle[packet_size];

    static constexpr float slack = 2e-6F;  ///< m, rounding of a plane's height for coordinates below 1 m

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

    /// Whether a point must be held against each triangle: those with concern < 0. A triangle is left out
    /// only where its foot of the point is further than reach, or is the foot of a neighbour that is at least
    /// as near: across an edge that is flat or a valley as seen from the free side the triangle beyond is
    /// nearer; on a ridge the lower number answers for both. Points behind a triangle's plane always concern
    /// it. Changes by at most the point's motion. Returns the lanes with concern < limit, a bit each.
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
    // Somebody else's: in front, beyond an edge, and in no wedge that this triangle keeps.
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

/// The lanes with value < limit, a bit each.
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
