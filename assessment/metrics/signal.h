// SPDX-License-Identifier: Apache-2.0
// Functions of sampled signals, used by the metrics. They agree with closed forms to 1e-6.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace fulcrum {

/// How long a signal is held at its first and last sample before it is filtered, s.
inline constexpr double filter_hold_s = 0.3;

/// Second-order Butterworth run forward and backward, each pass -3 dB at `cutoff_hz`; ends held for
/// filter_hold_s. Returns as many samples as it was given. Precondition: 0 < cutoff_hz < rate_hz / 2.
std::vector<double> low_pass(const std::vector<double>& signal, double cutoff_hz, double rate_hz);
/// The same with the held ends kept: hold_samples(rate_hz) more at each side.
std::vector<double> low_pass_held(const std::vector<double>& signal, double cutoff_hz, double rate_hz);
std::size_t hold_samples(double rate_hz);

/// Replaces each sample of [first, last) that differs from the median of itself and its two neighbours on
/// each side by more than 10 times their spread (median absolute deviation, at least `step`) by this median
/// (Hampel's filter); returns how many. Fewer than 5 samples stay as they are.
std::size_t despike(std::vector<double>& samples, std::size_t first, std::size_t last, double step);

/// Spectral arc length of a speed profile (Balasubramanian 2015), frequency axis up to 10 Hz, threshold 0.05,
/// padding 2^4. At most 0; nearer to 0 is smoother. `rate` in Hz. Returns NaN for fewer than 2 samples or no
/// speed at all.
double sparc(const std::vector<double>& speed, double rate);
/// Minus the logarithm of the dimensionless jerk of a speed profile; NaN for fewer than 3 samples or no speed
/// or no jerk.
double ldlj(const std::vector<double>& speed, double rate);
/// T^3 / v_peak^2 * sum((second difference / dt^2)^2) dt, T = N dt. NaN for fewer than 3 samples or no speed.
double dimensionless_jerk(const std::vector<double>& speed, double rate);

/// Local maxima (the middle of a plateau), prominence at least `prominence`, at least `distance` samples
/// apart: of two that are closer the lower is dropped. Of equal maxima without a dip of `prominence` between
/// them the first counts. Rising indices.
std::vector<std::size_t> find_peaks(const std::vector<double>& signal, double prominence,
                                    std::size_t distance);

/// Sum of distances between successive points (columns).
double path_length(const Eigen::Matrix3Xd& points);
/// Sum of the angles (rad) between successive unit vectors (columns).
double angular_path(const Eigen::Matrix3Xd& axes);
/// Angle between two vectors, rad, exact for small angles too.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b);
/// 4/3 pi radius_squared^(3/2) sqrt(det cov), population covariance about the mean. 0 for no points.
double ellipsoid_volume(const Eigen::Matrix3Xd& points, double radius_squared);
/// Pearson's r; NaN where one of them does not vary. Precondition: equal sizes.
double pearson(const std::vector<double>& a, const std::vector<double>& b);
/// Trapezoid rule.
double integral(const std::vector<double>& signal, double step);

/// Power in the bins of 0.5 Hz (k = 0 ... 1000/2/0.5) of one window of `signal` from `first`: Hann, 2 s, mean
/// removed; unscaled. Precondition: first + 2 rate <= size.
std::vector<double> window_power(const std::vector<double>& signal, std::size_t first, double rate);

}  // namespace fulcrum
