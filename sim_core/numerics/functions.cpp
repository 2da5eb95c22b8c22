// SPDX-License-Identifier: Apache-2.0
// Arguments are reduced with constants split so that every product with the quotient is exact; the remainder
// is evaluated by a Taylor series whose truncation error is below a tenth of an ulp. Only +, -, *, /, sqrt
// and floor are used: IEEE 754 rounds each correctly and the build forbids contraction, so the result bits
// are the same on every machine.
#include "sim_core/numerics/functions.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace fulcrum::math {
namespace {

constexpr double pi_half = 0x1.921fb54442d18p+0, pi_half_low = 0x1.1a62633145c07p-54;
constexpr double pi_high = 0x1.921fb54442d18p+1, pi_low = 0x1.1a62633145c07p-53;
// pi/2 in three parts: 33, 33 and 53 bits; a quotient of up to 20 bits times one of the first two is exact.
constexpr double pio2_1 = 0x1.921fb54400000p+0, pio2_2 = 0x1.0b4611a600000p-34,
                 pio2_3 = 0x1.3198a2e037073p-69;
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
constexpr double ln2_high = 0x1.62e42fef00000p-1, ln2_low = 0x1.473de6af278edp-34,
                 one_over_ln2 = 0x1.71547652b82fep+0;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// atan(k/8), high and low part.
constexpr double atan_table[9][2] = {
    {0.0, 0.0},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

double power_of_two(int exponent) {  // -1022 .. 1023
    const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

// sin(high + low) and cos(high + low) for |high| <= pi/4.
double sine_kernel(double high, double low) {
    const double z = high * high;
    double p = 1.0 / 355687428096000.0;
    p = p * z - 1.0 / 1307674368000.0;
    p = p * z + 1.0 / 6227020800.0;
    p = p * z - 1.0 / 39916800.0;
    p = p * z + 1.0 / 362880.0;
    p = p * z - 1.0 / 5040.0;
    p = p * z + 1.0 / 120.0;
    p = p * z - 1.0 / 6.0;
    return high + (high * z * p + low * (1.0 - 0.5 * z));
}

double cosine_kernel(double high, double low) {
    const double z = high * high;
    double p = -1.0 / 6402373705728000.0;
    p = p * z + 1.0 / 20922789888000.0;
    p = p * z - 1.0 / 87178291200.0;
    p = p * z + 1.0 / 479001600.0;
    p = p * z - 1.0 / 3628800.0;
    p = p * z + 1.0 / 40320.0;
    p = p * z - 1.0 / 720.0;
    p = p * z + 1.0 / 24.0;
    const double half = 0.5 * z, top = 1.0 - half;
    return top + (((1.0 - top) - half) + (z * z * p - high * low));
}

// atan(y / x) for 0 <= y, 0 < x, both finite.
double atan_quotient(double y, double x) {
    const bool inverted = y > x;
    const double p = inverted ? x : y, q = inverted ? y : x;
    const double t = p / q;  // 0 .. 1
    const int k = static_cast<int>(8.0 * t + 0.5);
    const double c = 0.125 * k;
    // The difference is exact up to rounding of p alone: c has four bits.
    const double u = (p - c * q) / (q + c * p);
    const double z = u * u;
    double s = 1.0 / 15.0;
    s = s * z - 1.0 / 13.0;
    s = s * z + 1.0 / 11.0;
    s = s * z - 1.0 / 9.0;
    s = s * z + 1.0 / 7.0;
    s = s * z - 1.0 / 5.0;
    s = s * z + 1.0 / 3.0;
    const double tail = atan_table[k][1] - u * z * s;
    if (!inverted) return atan_table[k][0] + (u + tail);
    const double top = pi_half - atan_table[k][0];
    const double lost = (pi_half - top) - atan_table[k][0];
    return top - (u + (tail - lost - pi_half_low));
}

}  // namespace

void sin_cos(double x, double& sine, double& cosine) {
    if (!(x >= -1e6 && x <= 1e6)) {
        if (!std::isfinite(x)) {
            sine = cosine = not_a_number;
            return;
        }
        x = std::fmod(x,
                      pi_high + pi_high);  // exact remainder; the modulus is rounded, hence the stated range
    }
    const double quotient = std::floor(x * two_over_pi + 0.5);
    const double first = x - quotient * pio2_1, second = quotient * pio2_2;
    const double high = first - second;
    const double low = ((first - high) - second) - quotient * pio2_3;
    const double sum = high + low;
    const double rest = (high - sum) + low;
    const double s = sine_kernel(sum, rest), c = cosine_kernel(sum, rest);
    switch (static_cast<std::int64_t>(quotient) & 3) {
        case 0:
            sine = s;
            cosine = c;
            break;
        case 1:
            sine = c;
            cosine = -s;
            break;
        case 2:
            sine = -s;
            cosine = -c;
            break;
        default:
            sine = -c;
            cosine = s;
            break;
    }
    if (x == 0.0) sine = x;  // keeps the sign of zero
}

double sin(double x) {
    double s, c;
    sin_cos(x, s, c);
    return s;
}

double cos(double x) {
    double s, c;
    sin_cos(x, s, c);
    return c;
}

double tan(double x) {
    double s, c;
    sin_cos(x, s, c);
    return s / c;
}

double exp(double x) {
    if (x != x) return x;
    if (x > 709.782712893384) return infinity;
    if (x < -745.14) return 0.0;
    const double quotient = std::floor(x * one_over_ln2 + 0.5);
    const double high = x - quotient * ln2_high, low = quotient * ln2_low;
    const double r = high - low;
    const double lost = (high - r) - low;
    double p = 1.0 / 6227020800.0;
    p = p * r + 1.0 / 479001600.0;
    p = p * r + 1.0 / 39916800.0;
    p = p * r + 1.0 / 3628800.0;
    p = p * r + 1.0 / 362880.0;
    p = p * r + 1.0 / 40320.0;
    p = p * r + 1.0 / 5040.0;
    p = p * r + 1.0 / 720.0;
    p = p * r + 1.0 / 120.0;
    p = p * r + 1.0 / 24.0;
    p = p * r + 1.0 / 6.0;
    p = p * r + 0.5;
    const double value = 1.0 + (r + (r * r * p + lost * (1.0 + r)));
    const int exponent = static_cast<int>(quotient);
    const int half = exponent / 2;  // two steps: handles subnormal results and 2^1024 times 0.5
    return value * power_of_two(half) * power_of_two(exponent - half);
}

double log(double x) {
    if (x != x || x < 0.0) return not_a_number;
    if (x == 0.0) return -infinity;
    if (x == infinity) return x;
    int exponent;
    double m = std::frexp(x, &exponent);  // 0.5 .. 1
    if (m < 0.70710678118654752440) {
        m *= 2.0;
        --exponent;
    }
    const double f = m - 1.0, s = f / (2.0 + f), z = s * s, half = 0.5 * f * f;
    double r = 2.0 / 25.0;
    r = r * z + 2.0 / 23.0;
    r = r * z + 2.0 / 21.0;
    r = r * z + 2.0 / 19.0;
    r = r * z + 2.0 / 17.0;
    r = r * z + 2.0 / 15.0;
    r = r * z + 2.0 / 13.0;
    r = r * z + 2.0 / 11.0;
    r = r * z + 2.0 / 9.0;
    r = r * z + 2.0 / 7.0;
    r = r * z + 2.0 / 5.0;
    r = r * z + 2.0 / 3.0;
    r *= z;
    const double k = exponent;
    return k * ln2_high - ((half - (s * (half + r) + k * ln2_low)) - f);
}

double atan2(double y, double x) {
    if (x != x || y != y) return not_a_number;
    const bool negative = std::signbit(y), left = std::signbit(x);
    double ay = std::fabs(y), ax = std::fabs(x), angle;
    if (ay == 0.0) {
        angle = 0.0;
    } else if (ax == 0.0) {
        return negative ? -pi_half : pi_half;
    } else {
        if (ay == infinity || ax == infinity) {
            const bool both = ay == ax;
            const double finite_y = ay == infinity ? 1.0 : 0.0,
                         finite_x = both ? 1.0 : (ax == infinity ? 1.0 : 0.0);
            ay = finite_y;
            ax = finite_x;
        }
        const double largest = ay > ax ? ay : ax;
        if (largest > 0x1p+1000) {
            ay *= 0x1p-100;
            ax *= 0x1p-100;
        } else if (largest < 0x1p-900) {
            ay *= 0x1p+120;
            ax *= 0x1p+120;
        }
        if (ay == 0.0) {
            angle = 0.0;
        } else if (ax == 0.0) {
            angle = pi_half;
        } else {
            angle = atan_quotient(ay, ax);
        }
    }
    if (left) angle = pi_high - (angle - pi_low);
    return negative ? -angle : angle;
}

double acos(double x) {
    if (x != x) return x;
    if (x >= 1.0) return 0.0;
    if (x <= -1.0) return pi_high;
    return atan2(std::sqrt((1.0 - x) * (1.0 + x)), x);
}

double asin(double x) {
    if (x != x) return x;
    if (x >= 1.0) return pi_half;
    if (x <= -1.0) return -pi_half;
    return atan2(x, std::sqrt((1.0 - x) * (1.0 + x)));
}

double hypot3(double x, double y, double z) {
    const double ax = std::fabs(x), ay = std::fabs(y), az = std::fabs(z);
    const double largest = ax > ay ? (ax > az ? ax : az) : (ay > az ? ay : az);
    if (largest != largest || ax != ax || ay != ay || az != az) return not_a_number;
    if (largest == 0.0 || largest == infinity) return largest;
    if (largest > 1e140 || largest < 1e-140) {
        const double a = ax / largest, b = ay / largest, c = az / largest;
        return largest * std::sqrt(a * a + b * b + c * c);
    }
    return std::sqrt(ax * ax + ay * ay + az * az);
}

}  // namespace fulcrum::math
