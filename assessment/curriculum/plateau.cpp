// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/plateau.h"

#include "assessment/learning/learning_curve.h"

namespace fulcrum {

std::optional<Plateau> plateau_below(const std::vector<double>& points, double pass_mark) {
    const std::vector<CurveFit> fits = fit_curves(points, false);
    if (fits.empty()) return {};
    const CurveFit& fit = best_curve(fits);
    if (fit.plateau >= pass_mark) return {};
    // A cohort's grid asks this of every person and task: the ends of the interval only where they decide.
    const std::optional<double> high = plateau_end(points, fit, PlateauEnd::high);
    if (!high || *high >= pass_mark) return {};
    const std::optional<double> low = plateau_end(points, fit, PlateauEnd::low);
    if (!low) return {};
    return Plateau{fit.plateau, *low, *high};
}

}  // namespace fulcrum
