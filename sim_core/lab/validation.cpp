// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/validation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/validation_rooms.h"

namespace fulcrum::lab {
namespace {

ValidationCase make(std::string model, std::string name, std::string quantity, double value, double reference,
                    std::string source, double error, std::string unit, double tolerance) {
    ValidationCase result;
    result.model = std::move(model);
    result.name = std::move(name);
    result.quantity = std::move(quantity);
    result.value = value;
    result.reference = reference;
    result.source = std::move(source);
    result.error = error;
    result.error_unit = std::move(unit);
    result.tolerance = tolerance;
    result.passed = error <= tolerance;  // false for NaN
    return result;
}

}  // namespace

ValidationCase relative_case(std::string model, std::string name, std::string quantity, double value,
                             double reference, std::string source, double tolerance) {
    const double error = std::fabs(value - reference) / std::fabs(reference);
    return make(std::move(model), std::move(name), std::move(quantity), value, reference, std::move(source),
                error, "relative", tolerance);
}

ValidationCase absolute_case(std::string model, std::string name, std::string quantity, double value,
                             double reference, std::string source, double tolerance, double scale,
                             std::string error_unit) {
    const double error = std::fabs(value - reference) / scale;
    return make(std::move(model), std::move(name), std::move(quantity), value, reference, std::move(source),
                error, std::move(error_unit), tolerance);
}

std::vector<ValidationCase> validation_cases() {
    std::vector<ValidationCase> cases;
    for (const auto room :
         {rod_validation, rod_constraint_validation, buckling_validation, material_validation,
          skinning_validation, filter_validation, haptic_validation, membrane_validation}) {
        std::vector<ValidationCase> more = room();
        cases.insert(cases.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return cases;
}

nlohmann::json to_json(const std::vector<ValidationCase>& cases) {
    nlohmann::json rows = nlohmann::json::array();
    for (const ValidationCase& c : cases) {
        rows.push_back({{"model", c.model},
                        {"name", c.name},
                        {"quantity", c.quantity},
                        {"value", c.value},
                        {"reference", c.reference},
                        {"source", c.source},
                        {"error", c.error},
                        {"error_unit", c.error_unit},
                        {"tolerance", c.tolerance},
                        {"passed", c.passed}});
    }
    return {{"cases", rows}};
}

ResultPage validation_page(const std::vector<ValidationCase>& cases) {
    ResultPage page("ACCURACY", "Accuracy", "fulcrum lab validate --output docs");
    const auto failed =
        std::count_if(cases.begin(), cases.end(), [](const ValidationCase& c) { return !c.passed; });
    page.paragraph(
        "Every model is compared with closed forms and with solutions by another method. No reference uses "
        "the model that it judges. " +
        std::to_string(cases.size()) + " cases, " + std::to_string(failed) +
        " outside their tolerance. The tests in tests/sim_core/lab assert the same cases. Each error is "
        "marked as relative to the reference or absolute in the unit of the quantity.");
    ResultTable table;
    table.name = "ACCURACY";
    table.columns = {"model",     "case",      "quantity",
                     "value",     "reference", "error",
                     "tolerance", "passed",    "source of the reference"};
    BarChart chart;
    chart.title = "Error of each case, as a share of its tolerance";
    chart.label = "error / tolerance (cases without any error are not drawn)";
    chart.limit_name = "tolerance";
    for (const ValidationCase& c : cases) {
        table.rows.push_back({c.model, c.name, c.quantity, short_number(c.value, 8),
                              short_number(c.reference, 8), short_number(c.error) + " " + c.error_unit,
                              short_number(c.tolerance), c.passed ? "yes" : "**no**", c.source});
        if (c.error > 0 && c.tolerance > 0)
            chart.rows.push_back({c.model + ": " + c.name, c.error / c.tolerance, 1});
    }
    page.table(table);
    page.chart("ACCURACY", "error over tolerance of each case", svg_bars(chart));
    page.document(to_json(cases));
    return page;
}

}  // namespace fulcrum::lab
