// SPDX-License-Identifier: Apache-2.0
// Learning curves of one trainee in one task: three models fitted by least squares, the best by AICc, where
// it levels off, and after how many attempts it meets a limit. docs/METRICS.md, Learning curves.
#pragma once

#include <optional>
#include <vector>

namespace fulcrum {

inline constexpr int fewest_attempts_of_a_curve = 8;

enum class CurveModel { inverse, power, exponential };
/// "inverse", "power", "exponential".
const char* curve_model_name(CurveModel model);

struct CurveFit {
    CurveModel model = CurveModel::inverse;
    /// y(x) = plateau + (first - plateau) f(x), with f = 1/x; x^-rate, rate 0.01 to 3; exp(-rate (x - 1)),
    /// rate 0.005 to 3.
    double plateau = 0, first = 0, rate = 1;
    double rss = 0;   ///< residual sum of squares
    double aicc = 0;  ///< corrected Akaike criterion
    /// 95 % by profile likelihood; none: open, the plateau is not visible yet on that side.
    std::optional<double> plateau_low, plateau_high;

    double at(double x) const;
};

/// The three fits in the order of CurveModel; empty for fewer than fewest_attempts_of_a_curve values.
/// `values`: of attempts 1, 2, ...; finite. Deterministic.
/// Without intervals it takes a tenth of the time: plateau_end() adds those that are needed.
std::vector<CurveFit> fit_curves(const std::vector<double>& values, bool with_intervals = true);
enum class PlateauEnd { low, high };
/// Of the 95 % interval of the fit's plateau; none: it is open on this side.
std::optional<double> plateau_end(const std::vector<double>& values, const CurveFit& fit, PlateauEnd end);
/// The fit with the lowest AICc. Precondition: not empty.
const CurveFit& best_curve(const std::vector<CurveFit>& fits);

/// Attempts until the curve meets a limit, with the interval that the profile of the plateau gives. None:
/// never, or not within 10,000 attempts.
struct AttemptsToLimit {
    std::optional<int> attempts, low, high;
};
/// `lower_is_better`: met where y <= limit.
AttemptsToLimit attempts_to_limit(const std::vector<double>& values, const CurveFit& fit, double limit,
                                  bool lower_is_better);

}  // namespace fulcrum
