// SPDX-License-Identifier: Apache-2.0
// One function per kind of experiment; experiment.cpp lists them.
#pragma once

#include "sim_core/lab/experiment.h"
#include "sim_core/lab/study_input.h"

namespace fulcrum::lab {

void run_filter_experiment(const JsonDocument& file, ExperimentResult& result);
void run_law_experiment(const JsonDocument& file, ExperimentResult& result);
void run_bend_experiment(const JsonDocument& file, ExperimentResult& result);
void run_fall_experiment(const JsonDocument& file, ExperimentResult& result);
void run_subdivision_experiment(const JsonDocument& file, ExperimentResult& result);
void run_cut_bowel_experiment(const JsonDocument& file, ExperimentResult& result);

}  // namespace fulcrum::lab
