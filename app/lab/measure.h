// SPDX-License-Identifier: GPL-3.0-or-later
// The laboratory's commands that need the whole product: reference workloads with the attempt's own, and the
// cost of each part of a scene.
#pragma once

#include <optional>
#include <string>

#include "sim_core/lab/result_page.h"

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

}  // namespace fulcrum::app
