// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab validate`: values of the models compared with a closed form or with a solution by another
// method. The tests assert the same cases that the command prints.
#pragma once

#include <string>
#include <vector>

#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

/// One value and its reference.
struct ValidationCase {
    std::string model;     ///< "rod", "skinning", "filter", "haptics", "membrane", "collision", "wall"
    std::string name;      ///< for example "cantilever, qL^3/EI = 10"
    std::string quantity;  ///< compared quantity, with unit
    double value = 0;
    double reference = 0;
    std::string source;  ///< source of the reference; never the model itself
    double error = 0;    ///< in the sense of `error_unit`
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

/// All cases, one function per room (for a new one add a line in validation.cpp). Takes less than 30 s.
std::vector<ValidationCase> validation_cases();

/// {"cases": [...]} of docs/FORMATS.md.
nlohmann::json to_json(const std::vector<ValidationCase>& cases);
/// docs/ACCURACY.md with its JSON, CSV and chart.
ResultPage validation_page(const std::vector<ValidationCase>& cases);

}  // namespace fulcrum::lab
