// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/studies.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim_core/lab/cut_study.h"
#include "sim_core/lab/filter_study.h"
#include "sim_core/lab/hand_study.h"
#include "sim_core/lab/membrane_study.h"
#include "sim_core/lab/rod_study.h"
#include "sim_core/lab/skin_study.h"
#include "sim_core/lab/study_input.h"

namespace fulcrum::lab {
namespace {

nlohmann::json run_rod(const JsonDocument& study) {
    return run_rod_study(study.root(), study.file());
}

/// All models that can be run separately.
const std::vector<Study>& studies() {
    static const std::vector<Study> all = {
        {"cut", run_cut_study, {"mesh", "width_m", "strokes", "fixed", "ends"}},
        {"filter",
         run_filter_study,
         {"mesh", "vertex", "force_n", "sigma_m", "grade", "tip_box_m", "tip_rotation"}},
        {"hand", run_hand_study, {"trocar", "cases"}},
        {"membrane",
         run_membrane_study,
         {"mesh", "fixed", "stiffness_n_m", "shear_stiffness_n_m", "bend_stiffness_n_m", "damping", "mass_kg",
          "pre_strain", "gravity", "integrator", "iterations", "dt_s", "steps"}},
        {"rod",
         run_rod,
         {"length_m", "segments", "outer_radius_m", "inner_radius_m", "young_pa", "exponent", "poisson",
          "linear_density_kg_m", "law", "layers", "level", "iterations", "ends", "intrinsic_curvature_per_m",
          "end_twist_rad", "end_displacement_m", "point_loads", "gravity"}},
        {"skin", run_skin_study, {"cage", "rest", "deformed_cage", "scope"}},
    };
    return all;
}

/// A misspelt key must not be ignored silently: the result would be that of another study.
void refuse_unknown_keys(const JsonDocument& document, const Study& study) {
    std::string known = "model";
    for (const char* key : study.keys) known += std::string(", ") + key;
    for (const auto& [key, value] : document.root().items()) {
        static_cast<void>(value);
        const bool comment = !key.empty() && key.front() == '$';
        if (comment || key == "model" ||
            std::find(study.keys.begin(), study.keys.end(), key) != study.keys.end())
            continue;
        document.fail("/" + key, "unknown key \"" + key.substr(0, 40) + "\"",
                      "remove it; the keys of a study of this model are " + known);
    }
}

}  // namespace

nlohmann::json run_study(const std::string& path, const std::vector<Study>& more) {
    const JsonDocument document = JsonDocument::load(path);
    const std::string model = text_of(document, "model");
    std::string known;
    std::vector<Study> all = studies();
    all.insert(all.end(), more.begin(), more.end());
    for (const Study& study : all) {
        if (model == study.model) {
            refuse_unknown_keys(document, study);
            return study.run(document);
        }
        known += std::string(known.empty() ? "" : ", ") + study.model;
    }
    document.fail("/model", "unknown model \"" + model.substr(0, 40) + "\"", "use one of: " + known);
}

}  // namespace fulcrum::lab
