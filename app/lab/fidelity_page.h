// SPDX-License-Identifier: GPL-3.0-or-later
// The page of fidelity and score: the answer for each task, its chart, and every metric.
#pragma once

#include "app/lab/fidelity_answer.h"
#include "sim_core/lab/result_page.h"

namespace fulcrum::app {

/// A panel for each task: the largest shift of a gated metric at each fidelity with the 2 % line and the
/// verdicts that change, above the processor time. SVG text.
std::string fidelity_chart(const std::vector<TaskAnswer>& answers);
lab::ResultPage fidelity_page(const FidelityStudy& study, const std::vector<TaskAnswer>& answers);

}  // namespace fulcrum::app
