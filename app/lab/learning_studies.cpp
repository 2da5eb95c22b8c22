// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/learning_studies.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/cli/commands.h"
#include "app/cli/statistics_json.h"
#include "assessment/learning/pass_rule.h"
#include "assessment/learning/relapse_cusum.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::app {
namespace {

using nlohmann::json;

constexpr std::size_t most_values = 10000;

double number_at(const JsonDocument& study, const std::string& pointer, double least, double most) {
    const json::json_pointer at(pointer);
    if (!study.root().contains(at) || !study.root()[at].is_number())
        study.fail(pointer, "is missing or not a number", "give a number");
    const double value = study.root()[at].get<double>();
    if (!(value >= least && value <= most))
        study.fail(pointer, "is out of range",
                   "give a number from " + json(least).dump() + " to " + json(most).dump());
    return value;
}

std::string text_number(const JsonDocument& study, const std::string& key) {
    return json(number_at(study, "/rule/" + key, 0, 1000)).dump();
}
std::string text_count(const JsonDocument& study, const std::string& key) {
    return std::to_string(static_cast<int>(number_at(study, "/rule/" + key, 1, 1000)));
}

PassRule rule_of(const JsonDocument& study) {
    const json& root = study.root();
    const std::string kind =
        root.contains(json::json_pointer("/rule/kind")) && root["rule"]["kind"].is_string()
            ? root["rule"]["kind"].get<std::string>()
            : std::string();
    std::string text;
    if (kind == "in_a_row") {
        text = "row:" + text_count(study, "k");
    } else if (kind == "k_of_n") {
        text = "of:" + text_count(study, "k") + "," + text_count(study, "n");
    } else if (kind == "lc_cusum") {
        text = "lc-cusum:" + text_number(study, "p0") + "," + text_number(study, "p1") + "," +
               text_number(study, "h");
    } else {
        study.fail("/rule/kind", "is not a kind of rule", "give in_a_row, k_of_n or lc_cusum");
    }
    try {
        return parse_pass_rule(text);
    } catch (const InputError& error) {
        study.fail("/rule", error.problem(), error.hint());
    }
}

/// The array at a top-level key.
const json& list_at(const JsonDocument& study, const char* key) {
    const json& root = study.root();
    if (!root.contains(key) || !root[key].is_array() || root[key].empty() || root[key].size() > most_values)
        study.fail(std::string("/") + key, "is not a list of values",
                   "give 1 to " + std::to_string(most_values) + " values");
    return root[key];
}

std::vector<double> numbers_at(const JsonDocument& study, const char* key) {
    std::vector<double> values;
    for (const json& value : list_at(study, key)) {
        if (!value.is_number())
            study.fail(std::string("/") + key + "/" + std::to_string(values.size()), "is not a number",
                       "give a number");
        values.push_back(value.get<double>());
    }
    return values;
}

json run_rule(const JsonDocument& study) {
    const PassRule rule = rule_of(study);
    const auto attempts = static_cast<int>(number_at(study, "/attempts", 1, 1000));
    json declared = json::array(), mean = json::array(), median = json::array();
    std::size_t number = 0;
    for (const double q : numbers_at(study, "q")) {
        if (q < 0 || q > 1)
            study.fail("/q/" + std::to_string(number), "is not a chance", "give a number from 0 to 1");
        const OperatingPoint point = operating_point(rule, q, attempts);
        declared.push_back(point.declared);
        mean.push_back(or_null(point.mean_attempts_if_declared));
        median.push_back(or_null(point.median_attempts));
        ++number;
    }
    return {{"declared", declared}, {"mean_attempts_if_declared", mean}, {"median_attempts", median}};
}

json run_curve(const JsonDocument& study) {
    const std::vector<CurveFit> fits = fit_curves(numbers_at(study, "values"));
    if (fits.empty())
        study.fail("/values", "has too few attempts for a curve",
                   "give at least " + std::to_string(fewest_attempts_of_a_curve));
    return curves_json(fits);
}

json run_cusum(const JsonDocument& study) {
    PassRule rule;
    rule.kind = PassRuleKind::lc_cusum;
    rule.p0 = number_at(study, "/p0", 1e-6, 1 - 1e-6);
    rule.p1 = number_at(study, "/p1", rule.p0, 1 - 1e-6);
    rule.h = number_at(study, "/h", 1e-6, 100);
    json sums = json::array(), relapse = json::array(), alarms = json::array(), declared;
    double sum = 0;
    RelapseCusum cusum;
    int number = 0;
    for (const json& outcome : list_at(study, "outcomes")) {
        if (!outcome.is_boolean())
            study.fail("/outcomes/" + std::to_string(number), "is not true or false",
                       "give true for a pass, false for a failure");
        ++number;
        sum = std::max(0.0, sum + lc_cusum_step(rule, outcome.get<bool>()));
        sums.push_back(sum);
        if (declared.is_null() && sum >= rule.h) declared = number;
        if (cusum.step(outcome.get<bool>())) alarms.push_back(number);
        relapse.push_back(cusum.sum());
    }
    return {{"sum", sums}, {"declared_at", declared}, {"relapse_sum", relapse}, {"relapse_alarms", alarms}};
}

json run_agreement(const JsonDocument& study) {
    std::vector<std::vector<double>> ratings;
    for (const json& row : list_at(study, "ratings")) {
        const std::string place = "/ratings/" + std::to_string(ratings.size());
        if (!row.is_array() || row.size() > most_values)
            study.fail(place, "is not a list", "give a row of numbers");
        ratings.emplace_back();
        for (const json& value : row) {
            if (!value.is_number()) study.fail(place, "holds something that is not a number", "give numbers");
            ratings.back().push_back(value.get<double>());
        }
    }
    try {
        return agreement_json(ratings);
    } catch (const std::invalid_argument& error) {
        study.fail("/ratings", error.what(), "give scores of two or more raters on two or more targets");
    }
}

}  // namespace

std::vector<lab::Study> learning_studies() {
    return {{"rule", run_rule, {"rule", "q", "attempts"}},
            {"curve", run_curve, {"values"}},
            {"cusum", run_cusum, {"outcomes", "p0", "p1", "h"}},
            {"agreement", run_agreement, {"ratings"}}};
}

}  // namespace fulcrum::app
