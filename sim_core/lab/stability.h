// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab stability`: maps of the stability range of each model, with the theoretical boundary.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

enum class StabilityOutcome : std::uint8_t {
    stable,    ///< bounded and within the stated accuracy
    degraded,  ///< finite and bounded, but substepped, not converged or outside the stated accuracy, and
               ///< reported as such
    fault,     ///< the model gave up with a report, or (unreported) left its bounds
};
const char* name_of(StabilityOutcome outcome);

/// One axis of a map; the cells' values are on it.
struct StabilityAxis {
    std::string name;  ///< key of the cell in the JSON, for example "time_step_s"
    std::string unit;
    std::vector<double> values;  ///< ascending
    bool logarithmic = true;
};

/// One run.
struct StabilityCell {
    std::vector<double> at;  ///< one value per axis
    StabilityOutcome outcome = StabilityOutcome::stable;
    bool finite = true;  ///< no output was non-finite
    double measure = 0;  ///< value described by `StabilityMap::measure`; 0 if there is none
};

/// A curve in the plane of the first two axes.
struct StabilityCurve {
    std::string name;     ///< for the legend, for example "K (T/2 + t_d) = b + B"
    std::string formula;  ///< its source in words or symbols
    std::vector<double> x, y;
};

struct StabilityMap {
    std::string model;  ///< "rod", "skin", "membrane", "haptics" ...
    std::string title;
    std::vector<StabilityAxis> axes;     ///< two are drawn; a third, if any, gives one panel per value
    std::vector<StabilityCell> cells;    ///< any order
    std::vector<StabilityCurve> theory;  ///< empty: theory sets no bound here, `theory_note` says why
    std::string theory_note;
    std::string measure;  ///< meaning of StabilityCell::measure, with unit; empty: none
};

/// All maps of sim_core, one model per line in stability.cpp.
std::vector<StabilityMap> stability_maps();
/// {"maps": [...], "non_finite": n} of docs/FORMATS.md.
nlohmann::json to_json(const std::vector<StabilityMap>& maps);
ResultPage stability_page(const std::vector<StabilityMap>& maps);

}  // namespace fulcrum::lab
