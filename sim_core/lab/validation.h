// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab validate`: a model's figure held against a closed form or against a solution by another
// method. The tests assert the same cases that the command prints.
#pragma once

#include <string>
#include <vector>

#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

/// One figure beside its reference.
struct ValidationCase {
    std::string model;     ///< "rod", "skinning", "filter", "haptics", "membrane", "collision", "wall"
    std::string name;      ///< what is done, for example "cantilever, qL^3/EI = 10"
    std::string quantity;  ///< what is compared, with unit
    double value = 0;
    double reference = 0;
    std::string source;  ///< where the reference comes from; never the model itself
    double error = 0;    ///< as `error_unit` says
    std::string error_unit;
    double tolerance = 0;
    bool passed = false;
};

/// A case whose error is |value - reference| / |reference|.
ValidationCase relative_case(std::string model, std::string name, std::string quantity, double value,
                             double reference, std::string source, double tolerance);
/// A case whose error is |value - reference| / scale, scale 1 unless given.
ValidationCase absolute_case(std::string model, std::string name, std::string quantity, double value,
                             double reference, std::string source, double tolerance, double scale = 1,
                             std::string error_unit = "absolute");

/// Every case, a room a function (add a line in validation.cpp for a new one). Takes less than 30 s.
std::vector<ValidationCase> validation_cases();

/// {"cases": [...]} of docs/FORMATS.md.
nlohmann::json to_json(const std::vector<ValidationCase>& cases);
/// docs/ACCURACY.md with its JSON, CSV and chart.
ResultPage validation_page(const std::vector<ValidationCase>& cases);

}  // namespace fulcrum::lab
