// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab stability`: maps of where a model stays bounded, with the theoretical boundary.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

enum class StabilityOutcome : std::uint8_t {
    stable,    ///< bounded and accurate as declared
    degraded,  ///< finite and bounded, but substepped, not converged or outside the promised accuracy, and
               ///< said so
    fault,     ///< the model gave up and said so, or (unannounced) left its bounds
};
const char* name_of(StabilityOutcome outcome);

/// One axis of a map; the values of the cells lie on it.
struct StabilityAxis {
    std::string name;  ///< key of the cell in the JSON, for example "time_step_s"
    std::string unit;
    std::vector<double> values;  ///< rising
    bool logarithmic = true;
};

/// One run.
struct StabilityCell {
    std::vector<double> at;  ///< one value an axis
    StabilityOutcome outcome = StabilityOutcome::stable;
    bool finite = true;  ///< nothing non-finite left the model
    double measure = 0;  ///< figure that `StabilityMap::measure` names; 0 when there is none
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
    std::vector<StabilityAxis> axes;     ///< two are drawn; a third, if any, gives one panel a value
    std::vector<StabilityCell> cells;    ///< any order
    std::vector<StabilityCurve> theory;  ///< empty: theory sets no bound here, `theory_note` says why
    std::string theory_note;
    std::string measure;  ///< what StabilityCell::measure is, with unit; empty: none
};

/// Every map of sim_core, a model a line in stability.cpp.
std::vector<StabilityMap> stability_maps();
/// {"maps": [...], "non_finite": n} of docs/FORMATS.md.
nlohmann::json to_json(const std::vector<StabilityMap>& maps);
ResultPage stability_page(const std::vector<StabilityMap>& maps);

}  // namespace fulcrum::lab
