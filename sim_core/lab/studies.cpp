// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/studies.h"

#include "sim_core/lab/cut_study.h"
#include "sim_core/lab/filter_study.h"
#include "sim_core/lab/membrane_study.h"
#include "sim_core/lab/rod_study.h"
#include "sim_core/lab/skin_study.h"
#include "sim_core/lab/study_input.h"

namespace fulcrum::lab {
namespace {

struct Study {
    const char* model;
    nlohmann::json (*run)(const JsonDocument& study);
};

nlohmann::json run_rod(const JsonDocument& study) { return run_rod_study(study.root(), study.file()); }

// Every model that can be run alone; one line each.
constexpr Study studies[] = {
    {"cut", run_cut_study},
    {"filter", run_filter_study},
    {"membrane", run_membrane_study},
    {"rod", run_rod},
    {"skin", run_skin_study},
};

}  // namespace

nlohmann::json run_study(const std::string& path) {
    const JsonDocument document = JsonDocument::load(path);
    const std::string model = text_of(document, "model");
    std::string known;
    for (const auto& study : studies) {
        if (model == study.model) return study.run(document);
        known += std::string(known.empty() ? "" : ", ") + study.model;
    }
    document.fail("/model", "no model \"" + model.substr(0, 40) + "\" can be run alone",
                  "give one of: " + known);
}

}  // namespace fulcrum::lab
