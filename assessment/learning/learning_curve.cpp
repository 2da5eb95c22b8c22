// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/learning_curve.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr int starts = 20;
constexpr double quantile_95 = 3.841458820694124;  // chi squared, one degree of freedom
constexpr int furthest_attempt = 10000;

struct Range {
    double low = 1, high = 1;
};
Range rates_of(CurveModel model) {
    if (model == CurveModel::power) return {0.01, 3};
    if (model == CurveModel::exponential) return {0.005, 3};
    return {1, 1};
}

/// What is left to learn at attempt x, as a share of that at the first.
double left(CurveModel model, double rate, double x) {
    switch (model) {
        case CurveModel::inverse:
            return 1 / x;
        case CurveModel::power:
            return std::pow(x, -rate);
        case CurveModel::exponential:
            return std::exp(-rate * (x - 1));
    }
    return 0;
}

struct Line {
    double plateau = 0, first = 0, rss = 0;
};

/// Least squares for a given rate; with `plateau` only the first value is free.
Line solve(CurveModel model, double rate, const std::vector<double>& values, const double* plateau) {
    // y = plateau (1 - f) + first f
    double aa = 0, ab = 0, bb = 0, ay = 0, by = 0;
    // Powers and exponentials are most of the work: each once. The buffer outlives the call.
    static thread_local std::vector<double> shares;
    shares.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double f = shares[i] = left(model, rate, static_cast<double>(i + 1)), g = 1 - f;
        aa += g * g;
        ab += g * f;
        bb += f * f;
        ay += g * values[i];
        by += f * values[i];
    }
    Line line;
    const double determinant = aa * bb - ab * ab;
    if (plateau != nullptr) {
        line.plateau = *plateau;
        line.first = (by - ab * *plateau) / bb;
    } else {
        line.plateau = (bb * ay - ab * by) / determinant;
        line.first = (aa * by - ab * ay) / determinant;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double f = shares[i];
        const double e = values[i] - (line.plateau * (1 - f) + line.first * f);
        line.rss += e * e;
    }
    return line;
}

struct Best {
    Line line;
    double rate = 1;
    bool at_bound = false;
};

/// Over the rate: the best of fixed starts on a logarithmic scale, refined by golden section between its
/// neighbours.
Best search(CurveModel model, const std::vector<double>& values, const double* plateau) {
    const Range range = rates_of(model);
    Best best{solve(model, range.low, values, plateau), range.low, false};
    if (range.low == range.high) return best;
    const double low = std::log(range.low), high = std::log(range.high), step = (high - low) / (starts - 1);
    int chosen = 0;
    for (int i = 1; i < starts; ++i) {
        const double rate = std::exp(low + i * step);
        const Line line = solve(model, rate, values, plateau);
        if (line.rss < best.line.rss) {
            best = {line, rate, false};
            chosen = i;
        }
    }
    double a = low + std::max(0, chosen - 1) * step, b = low + std::min(starts - 1, chosen + 1) * step;
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    for (int i = 0; i < 60; ++i) {
        const double c = b - golden * (b - a), d = a + golden * (b - a);
        const bool lower =
            solve(model, std::exp(c), values, plateau).rss < solve(model, std::exp(d), values, plateau).rss;
        (lower ? b : a) = lower ? d : c;
    }
    const double rate = std::exp(0.5 * (a + b));
    const Line line = solve(model, rate, values, plateau);
    if (line.rss < best.line.rss) best = {line, rate, false};
    best.at_bound = best.rate < range.low * 1.001 || best.rate > range.high / 1.001;
    return best;
}

double floor_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value * value;
    return 1e-12 * std::max(sum, 1e-300);
}

/// How far the log-likelihood of a plateau lies below that of the fit, times 2.
double deviance(const std::vector<double>& values, const CurveFit& fit, double plateau, Best& profile) {
    profile = search(fit.model, values, &plateau);
    const double least = floor_of(values);
    return static_cast<double>(values.size()) *
           std::log(std::max(profile.line.rss, least) / std::max(fit.rss, least));
}

/// The end of the interval in the direction of `sign`; none: open.
std::optional<double> end_of(const std::vector<double>& values, const CurveFit& fit, double sign) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double range = std::max(*most - *least, 1e-9 * std::max(1.0, std::fabs(*most)));
    Best profile;
    double inside = 0, outside = 1e-4 * range;
    while (deviance(values, fit, fit.plateau + sign * outside, profile) < quantile_95) {
        inside = outside;
        outside *= 2;
        if (outside > 100 * range) return std::nullopt;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (inside + outside);
        const bool in = deviance(values, fit, fit.plateau + sign * middle, profile) < quantile_95;
        (in ? inside : outside) = middle;
    }
    const double end = fit.plateau + sign * inside;
    deviance(values, fit, end, profile);
    if (fit.model != CurveModel::inverse && profile.at_bound) return std::nullopt;
    return end;
}

std::optional<int> first_met(const CurveFit& fit, double limit, bool lower_is_better) {
    const auto met = [&](int x) {
        const double y = fit.at(x);
        return lower_is_better ? y <= limit : y >= limit;
    };
    if (met(1)) return 1;
    if (!met(furthest_attempt)) return std::nullopt;
    int before = 1, after = furthest_attempt;  // monotone
    while (after - before > 1) {
        const int middle = (before + after) / 2;
        (met(middle) ? after : before) = middle;
    }
    return after;
}

}  // namespace

const char* curve_model_name(CurveModel model) {
    switch (model) {
        case CurveModel::inverse:
            return "inverse";
        case CurveModel::power:
            return "power";
        case CurveModel::exponential:
            return "exponential";
    }
    return "";
}

double CurveFit::at(double x) const {
    return plateau + (first - plateau) * left(model, rate, x);
}

std::optional<double> plateau_end(const std::vector<double>& values, const CurveFit& fit, PlateauEnd end) {
    return end_of(values, fit, end == PlateauEnd::low ? -1 : 1);
}

std::vector<CurveFit> fit_curves(const std::vector<double>& values, bool with_intervals) {
    std::vector<CurveFit> fits;
    if (static_cast<int>(values.size()) < fewest_attempts_of_a_curve) return fits;
    const auto n = static_cast<double>(values.size());
    for (const CurveModel model : {CurveModel::inverse, CurveModel::power, CurveModel::exponential}) {
        const Best best = search(model, values, nullptr);
        CurveFit fit;
        fit.model = model;
        fit.plateau = best.line.plateau;
        fit.first = best.line.first;
        fit.rate = best.rate;
        fit.rss = best.line.rss;
        const double k = model == CurveModel::inverse ? 3 : 4;  // and the variance
        fit.aicc =
            n * std::log(std::max(fit.rss, floor_of(values)) / n) + 2 * k + 2 * k * (k + 1) / (n - k - 1);
        if (with_intervals) {
            fit.plateau_low = plateau_end(values, fit, PlateauEnd::low);
            fit.plateau_high = plateau_end(values, fit, PlateauEnd::high);
        }
        fits.push_back(fit);
    }
    return fits;
}

const CurveFit& best_curve(const std::vector<CurveFit>& fits) {
    return *std::min_element(fits.begin(), fits.end(),
                             [](const CurveFit& a, const CurveFit& b) { return a.aicc < b.aicc; });
}

AttemptsToLimit attempts_to_limit(const std::vector<double>& values, const CurveFit& fit, double limit,
                                  bool lower_is_better) {
    AttemptsToLimit result;
    result.attempts = result.low = result.high = first_met(fit, limit, lower_is_better);
    bool never = !result.attempts;
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double range = *most - *least;
    const double from = fit.plateau_low.value_or(fit.plateau - range);
    const double to = fit.plateau_high.value_or(fit.plateau + range);
    constexpr int samples = 41;
    for (int i = 0; i < samples; ++i) {
        Best profile;
        const double plateau = from + (to - from) * i / (samples - 1);
        if (deviance(values, fit, plateau, profile) > quantile_95 * (1 + 1e-6)) continue;
        CurveFit other = fit;
        other.plateau = plateau;
        other.first = profile.line.first;
        other.rate = profile.rate;
        const std::optional<int> met = first_met(other, limit, lower_is_better);
        if (!met) {
            never = true;
            continue;
        }
        if (!result.low || *met < *result.low) result.low = met;
        if (!result.high || *met > *result.high) result.high = met;
    }
    if (never) result.high = std::nullopt;
    return result;
}

}  // namespace fulcrum
