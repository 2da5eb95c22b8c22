// SPDX-License-Identifier: Apache-2.0
#include "assessment/metrics/signal.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <unsupported/Eigen/FFT>

namespace fulcrum {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Second-order Butterworth by the bilinear transform, pre-warped so that the cutoff is exact.
struct Butterworth {
    double b0, b1, b2, a1, a2;

    Butterworth(double cutoff_hz, double rate_hz) {
        const double k = std::tan(pi * cutoff_hz / rate_hz);
        const double norm = 1.0 / (1.0 + std::sqrt(2.0) * k + k * k);
        b0 = k * k * norm;
        b1 = 2.0 * b0;
        b2 = b0;
        a1 = 2.0 * (k * k - 1.0) * norm;
        a2 = (1.0 - std::sqrt(2.0) * k + k * k) * norm;
    }

    /// One pass over [begin, end) in place, with the steady state of the first value as initial state.
    template <typename Iterator>
    void run(Iterator begin, Iterator end) const {
        if (begin == end) return;
        double s1 = (1.0 - b0) * *begin, s2 = (b2 - a2) * *begin;
        for (; begin != end; ++begin) {
            const double x = *begin;
            const double y = b0 * x + s1;
            s1 = b1 * x - a1 * y + s2;
            s2 = b2 * x - a2 * y;
            *begin = y;
        }
    }
};

std::vector<double> magnitude_spectrum(const std::vector<double>& signal, std::size_t length) {
    std::vector<double> padded(signal);
    padded.resize(length, 0.0);
    // Keeps the twiddle factors of the lengths it has seen: making them costs more than a transform.
    thread_local Eigen::FFT<double> fft(Eigen::FFT<double>::impl_type(), Eigen::FFT<double>::HalfSpectrum);
    std::vector<std::complex<double>> spectrum;
    fft.fwd(spectrum, padded);
    std::vector<double> magnitude(spectrum.size());
    std::transform(spectrum.begin(), spectrum.end(), magnitude.begin(),
                   [](const std::complex<double>& bin) { return std::abs(bin); });
    return magnitude;
}

/// True where the signal falls by `prominence` on both sides before it meets a value as high (left) or higher
/// (right).
bool is_prominent(const std::vector<double>& signal, std::size_t first, std::size_t last, double prominence) {
    const double top = signal[first], base = top - prominence;
    std::size_t left = first, right = last;
    bool left_done = false, right_done = false;
    while (!left_done || !right_done) {
        if (!left_done) {
            if (left == 0) return false;
            --left;
            if (signal[left] >= top) return false;
            left_done = signal[left] <= base;
        }
        if (!right_done) {
            if (right + 1 == signal.size()) return false;
            ++right;
            if (signal[right] > top) return false;
            right_done = signal[right] <= base;
        }
    }
    return true;
}

}  // namespace

std::size_t despike(std::vector<double>& samples, std::size_t first, std::size_t last, double step) {
    constexpr std::size_t width = 5, half = 2;
    constexpr double factor = 10.0;
    last = std::min(last, samples.size());
    if (last < first + width) return 0;
    const std::vector<double> given(samples.begin() + static_cast<std::ptrdiff_t>(first),
                                    samples.begin() + static_cast<std::ptrdiff_t>(last));
    std::size_t replaced = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const std::size_t from = std::min(i - std::min(i, half), given.size() - width);
        // The median is far away only if most of the neighbours are.
        int near = 0;
        for (std::size_t k = from; k < from + width; ++k)
            near += std::abs(given[k] - given[i]) <= factor * step;
        if (near >= 3) continue;
        std::array<double, width> window;
        std::copy_n(given.begin() + static_cast<std::ptrdiff_t>(from), width, window.begin());
        std::nth_element(window.begin(), window.begin() + half, window.end());
        const double median = window[half];
        for (double& value : window) value = std::abs(value - median);
        std::nth_element(window.begin(), window.begin() + half, window.end());
        if (std::abs(given[i] - median) <= factor * std::max(window[half], step)) continue;
        samples[first + i] = median;
        ++replaced;
    }
    return replaced;
}

std::size_t hold_samples(double rate_hz) {
    return static_cast<std::size_t>(std::lround(filter_hold_s * rate_hz));
}

std::vector<double> low_pass_held(const std::vector<double>& signal, double cutoff_hz, double rate_hz) {
    assert(cutoff_hz > 0 && cutoff_hz < rate_hz / 2);
    if (signal.empty()) return {};
    const std::size_t hold = hold_samples(rate_hz);
    std::vector<double> out;
    out.reserve(signal.size() + 2 * hold);
    out.insert(out.end(), hold, signal.front());
    out.insert(out.end(), signal.begin(), signal.end());
    out.insert(out.end(), hold, signal.back());
    const Butterworth filter(cutoff_hz, rate_hz);
    filter.run(out.begin(), out.end());
    filter.run(out.rbegin(), out.rend());
    return out;
}

std::vector<double> low_pass(const std::vector<double>& signal, double cutoff_hz, double rate_hz) {
    const std::vector<double> held = low_pass_held(signal, cutoff_hz, rate_hz);
    if (held.empty()) return {};
    const auto hold = static_cast<std::ptrdiff_t>(hold_samples(rate_hz));
    return {held.begin() + hold, held.end() - hold};
}

double sparc(const std::vector<double>& speed, double rate) {
    constexpr double highest_hz = 10.0, threshold = 0.05;
    if (speed.size() < 2) return not_a_number;
    std::size_t length = 1;
    while (length < speed.size()) length *= 2;
    length *= 16;
    std::vector<double> magnitude = magnitude_spectrum(speed, length);
    const double largest = *std::max_element(magnitude.begin(), magnitude.end());
    if (!(largest > 0)) return not_a_number;
    const double bin_hz = rate / static_cast<double>(length);
    std::size_t last = 0;
    for (std::size_t k = 0; k < magnitude.size() && static_cast<double>(k) * bin_hz <= highest_hz; ++k) {
        magnitude[k] /= largest;
        if (magnitude[k] >= threshold) last = k;
    }
    if (last == 0) return not_a_number;
    const double step = 1.0 / static_cast<double>(last);
    double arc = 0;
    for (std::size_t k = 1; k <= last; ++k) arc += std::hypot(step, magnitude[k] - magnitude[k - 1]);
    return -arc;
}

double dimensionless_jerk(const std::vector<double>& speed, double rate) {
    if (speed.size() < 3) return not_a_number;
    const double peak = *std::max_element(speed.begin(), speed.end());
    if (!(peak > 0)) return not_a_number;
    const double dt = 1.0 / rate, duration = static_cast<double>(speed.size()) * dt;
    double sum = 0;
    for (std::size_t i = 1; i + 1 < speed.size(); ++i) {
        const double jerk = (speed[i + 1] - 2.0 * speed[i] + speed[i - 1]) / (dt * dt);
        sum += jerk * jerk * dt;
    }
    return duration * duration * duration / (peak * peak) * sum;
}

double ldlj(const std::vector<double>& speed, double rate) {
    const double jerk = dimensionless_jerk(speed, rate);
    return jerk > 0 ? -std::log(jerk) : not_a_number;
}

std::vector<std::size_t> find_peaks(const std::vector<double>& signal, double prominence,
                                    std::size_t distance) {
    std::vector<std::size_t> peaks;
    for (std::size_t i = 1; i + 1 < signal.size();) {
        std::size_t end = i;
        while (end + 1 < signal.size() && signal[end + 1] == signal[i]) ++end;
        const bool top = signal[i - 1] < signal[i] && end + 1 < signal.size() && signal[end + 1] < signal[i];
        if (top && is_prominent(signal, i, end, prominence)) peaks.push_back((i + end) / 2);
        i = end + 1;
    }
    // The highest first; each accepted peak removes the lower ones near it.
    std::vector<std::size_t> order(peaks.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return signal[peaks[a]] > signal[peaks[b]]; });
    std::vector<bool> dropped(peaks.size(), false);
    for (const std::size_t best : order) {
        if (dropped[best]) continue;
        for (std::size_t k = best; k > 0 && peaks[best] - peaks[k - 1] < distance; --k) dropped[k - 1] = true;
        for (std::size_t k = best + 1; k < peaks.size() && peaks[k] - peaks[best] < distance; ++k)
            dropped[k] = true;
    }
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < peaks.size(); ++i)
        if (!dropped[i]) kept.push_back(peaks[i]);
    return kept;
}

double path_length(const Eigen::Matrix3Xd& points) {
    double sum = 0;
    for (Eigen::Index i = 1; i < points.cols(); ++i) sum += (points.col(i) - points.col(i - 1)).norm();
    return sum;
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double angular_path(const Eigen::Matrix3Xd& axes) {
    double sum = 0;
    for (Eigen::Index i = 1; i < axes.cols(); ++i) sum += angle_between(axes.col(i - 1), axes.col(i));
    return sum;
}

double ellipsoid_volume(const Eigen::Matrix3Xd& points, double radius_squared) {
    if (points.cols() == 0) return 0;
    const Eigen::Vector3d mean = points.rowwise().mean();
    const Eigen::Matrix3Xd centred = points.colwise() - mean;
    const Eigen::Matrix3d covariance = centred * centred.transpose() / static_cast<double>(points.cols());
    const Eigen::Vector3d scale = covariance.diagonal().cwiseSqrt();
    if (!(scale.minCoeff() > 0)) return 0;
    // The determinant of the correlation matrix is near 1, that of the covariance underflows for small
    // tremors.
    const Eigen::Matrix3d correlation =
        scale.cwiseInverse().asDiagonal() * covariance * scale.cwiseInverse().asDiagonal();
    const double determinant = std::max(0.0, correlation.determinant());
    return 4.0 / 3.0 * pi * std::pow(radius_squared, 1.5) * scale.prod() * std::sqrt(determinant);
}

double pearson(const std::vector<double>& a, const std::vector<double>& b) {
    assert(a.size() == b.size());
    if (a.empty()) return not_a_number;
    // Plain loops: Eigen's sums over a std::vector's memory depend on its alignment, and a metric must be
    // bit-identical each time.
    const auto n = static_cast<double>(a.size());
    double mean_a = 0, mean_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        mean_a += a[i] / n;
        mean_b += b[i] / n;
    }
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double da = a[i] - mean_a, db = b[i] - mean_b;
        aa += da * da;
        bb += db * db;
        ab += da * db;
    }
    const double product = aa * bb;
    return product > 0 ? ab / std::sqrt(product) : not_a_number;
}

double integral(const std::vector<double>& signal, double step) {
    double sum = 0;
    for (std::size_t i = 1; i < signal.size(); ++i) sum += 0.5 * (signal[i - 1] + signal[i]) * step;
    return sum;
}

std::vector<double> window_power(const std::vector<double>& signal, std::size_t first, double rate) {
    const auto length = static_cast<std::size_t>(std::lround(2.0 * rate));
    assert(first + length <= signal.size());
    const auto begin = signal.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<double> window(begin, begin + static_cast<std::ptrdiff_t>(length));
    double mean = 0;
    for (const double value : window) mean += value / static_cast<double>(length);
    thread_local std::vector<double> hann;
    if (hann.size() != length) {
        hann.resize(length);
        for (std::size_t i = 0; i < length; ++i)
            hann[i] = 0.5 - 0.5 * std::cos(2.0 * pi * static_cast<double>(i) / static_cast<double>(length));
    }
    for (std::size_t i = 0; i < length; ++i) window[i] = (window[i] - mean) * hann[i];
    std::vector<double> power = magnitude_spectrum(window, length);
    for (double& value : power) value *= value;
    return power;
}

}  // namespace fulcrum
