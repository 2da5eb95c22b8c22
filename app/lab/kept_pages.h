// SPDX-License-Identifier: GPL-3.0-or-later
// The results of the laboratory are kept as pages; this reads their tables again.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fulcrum::app {

/// Cells of the page of `lab operators` that are read again: whether a metric separates experts from novices
/// (or is no quality at all), whether a gate fails novices. Another text in the last column of a gate is the
/// reason why it is kept.
inline constexpr const char *cell_yes = "yes", *cell_context = "context",
                            *cell_no_reason = "no, and no reason is given";

/// The page that `lab operators` wrote, in the form of its JSON: metrics (metric, hand, auc, retest,
/// separates, values, version; the last two null on pages from before they were printed), gates (metric,
/// hand, failed, safety), seeds, passed. Values are as exact as the page prints them. `path` is for messages.
/// Throws InputError for a page of another form.
nlohmann::json read_operators_page(const std::string& text, const std::string& path);
/// The page that `lab invariance` wrote: metrics by name with half_rate and noise, relative changes, and
/// version, null on pages from before it was printed.
nlohmann::json read_invariance_page(const std::string& text, const std::string& path);

}  // namespace fulcrum::app
