// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/validation.h"

#include <cmath>
#include <utility>

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
    return {};
}

}  // namespace fulcrum::lab
