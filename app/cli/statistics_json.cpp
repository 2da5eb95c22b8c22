// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/statistics_json.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "app/cli/commands.h"
#include "assessment/learning/agreement.h"

namespace fulcrum::app {
namespace {

nlohmann::json fit_json(const CurveFit& fit) {
    nlohmann::json parameters = {{"plateau", fit.plateau}, {"first", fit.first}};
    if (fit.model != CurveModel::inverse) parameters["rate"] = fit.rate;
    return {{"name", curve_model_name(fit.model)},
            {"parameters", parameters},
            {"rss", fit.rss},
            {"aicc", fit.aicc},
            {"plateau", fit.plateau},
            {"plateau_low", or_null(fit.plateau_low)},
            {"plateau_high", or_null(fit.plateau_high)}};
}

}  // namespace

nlohmann::json curves_json(const std::vector<CurveFit>& fits) {
    nlohmann::json models = nlohmann::json::array();
    for (const CurveFit& fit : fits) models.push_back(fit_json(fit));
    return {{"models", models}, {"best", curve_model_name(best_curve(fits).model)}};
}

nlohmann::json agreement_json(const std::vector<std::vector<double>>& ratings) {
    const IntraclassCorrelations icc = intraclass_correlations(ratings);
    const std::pair<const char*, Correlation> forms[] = {{"1,1", icc.one_1},   {"2,1", icc.two_1},
                                                         {"3,1", icc.three_1}, {"1,k", icc.one_k},
                                                         {"2,k", icc.two_k},   {"3,k", icc.three_k}};
    nlohmann::json named;
    for (const auto& [name, one] : forms)
        named[name] = {{"value", one.value}, {"low", one.low}, {"high", one.high}};
    return {{"icc", named}, {"cronbach_alpha", cronbach_alpha(ratings)}};
}

}  // namespace fulcrum::app
