// SPDX-License-Identifier: GPL-3.0-or-later
// The laboratory's commands that need the whole product: reference workloads with the attempt's own, the
// cost of each part of a scene, and how much metrics change with the fidelity.
#pragma once

#include <optional>
#include <string>

#include "sim_core/lab/result_page.h"
#include "sim_core/lab/tradeoff.h"

namespace fulcrum::app {

/// A page and its JSON document.
struct Measured {
    lab::ResultPage page;
    nlohmann::json document;
};

/// Reference workloads, all or the one named. Throws InputError for an unknown name.
Measured measure_workloads(const std::optional<std::string>& only);
/// Ticks and steps of B2 in real time, with a blade that cuts and one that does not; a minute or two.
Measured measure_cut_clock();
/// What each part of each task's scene costs while an expert operator performs.
Measured measure_costs();
/// Every metric of the same operator on the same task at each fidelity, against "fine".
std::vector<lab::ScoreSensitivity> measure_score_sensitivity();

}  // namespace fulcrum::app
