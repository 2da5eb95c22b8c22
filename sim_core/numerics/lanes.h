// SPDX-License-Identifier: Apache-2.0
// Vector of four doubles, used by kernels of rod, membranes and rigid bodies. Every operation is the IEEE
// operation on each lane.
#pragma once

#include <cmath>
#include <cstring>
#if defined(__AVX__)
#include <immintrin.h>
#endif

#include "sim_core/numerics/types.h"

namespace fulcrum {

using Lanes = double __attribute__((vector_size(32)));

inline Lanes load_lanes(const double* from) {
    Lanes value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

inline void store_lanes(double* to, const Lanes& value) {
    std::memcpy(to, &value, sizeof value);
}

inline Lanes all_lanes(double value) {
    return Lanes{value, value, value, value};
}

inline Lanes sqrt_lanes(const Lanes& value) {
#if defined(__AVX__)
    return _mm256_sqrt_pd(value);
#else
    return Lanes{std::sqrt(value[0]), std::sqrt(value[1]), std::sqrt(value[2]), std::sqrt(value[3])};
#endif
}

/// a * b + c, rounded once where the processor can, as Eigen's pmadd.
inline Lanes multiply_add_lanes(const Lanes& a, const Lanes& b, const Lanes& c) {
#if defined(__FMA__)
    return _mm256_fmadd_pd(a, b, c);
#else
    return a * b + c;
#endif
}

/// The first two lanes of a, the last two of b.
inline Lanes first_two_lanes(const Lanes& a, const Lanes& b) {
#if defined(__AVX__)
    return _mm256_blend_pd(a, b, 12);
#else
    return Lanes{a[0], a[1], b[2], b[3]};
#endif
}

/// The lanes i, j, k, l of a value.
template <int i, int j, int k, int l>
inline Lanes turned_lanes(const Lanes& v) {
#if defined(__AVX2__)
    return _mm256_permute4x64_pd(v, i + 4 * j + 16 * k + 64 * l);
#else
    return Lanes{v[i], v[j], v[k], v[l]};
#endif
}

/// Transposes the 4 x 4 matrix whose rows are a, b, c, d.
inline void transpose_lanes(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
#if defined(__AVX__)
    const __m256d ab_low = _mm256_unpacklo_pd(a, b), ab_high = _mm256_unpackhi_pd(a, b);
    const __m256d cd_low = _mm256_unpacklo_pd(c, d), cd_high = _mm256_unpackhi_pd(c, d);
    a = _mm256_permute2f128_pd(ab_low, cd_low, 0x20);
    b = _mm256_permute2f128_pd(ab_high, cd_high, 0x20);
    c = _mm256_permute2f128_pd(ab_low, cd_low, 0x31);
    d = _mm256_permute2f128_pd(ab_high, cd_high, 0x31);
#else
    const Lanes p = a, q = b, r = c, s = d;
    a = Lanes{p[0], q[0], r[0], s[0]};
    b = Lanes{p[1], q[1], r[1], s[1]};
    c = Lanes{p[2], q[2], r[2], s[2]};
    d = Lanes{p[3], q[3], r[3], s[3]};
#endif
}

/// A vector in the first three lanes, 0 in the last.
inline Lanes lanes_of(const Vector3& v) {
    return Lanes{v.x(), v.y(), v.z(), 0.0};
}
inline Vector3 vector_of(const Lanes& v) {
    return Vector3(v[0], v[1], v[2]);
}

/// Sum of the four lanes, in a fixed order.
inline double sum_lanes(const Lanes& v) {
    return (v[0] + v[1]) + (v[2] + v[3]);
}

}  // namespace fulcrum
