// SPDX-License-Identifier: Apache-2.0
// Statements in words: one table, one function for screens, reports and the command line.
#pragma once

#include <string>

#include "assessment/metrics/statement.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

/// Beyond this z the number says nothing more: "far outside".
inline constexpr double z_shown_up_to = 5;

/// `words`: English, with the parameters in braces. In addition to a statement's own parameters there are
/// {where} (hand and step), {of_hand}, {in_tissue}, {on_tissue}, {event}, {time}, and of a metric {metric},
/// {fault}, {excess}, {remedy}.
struct StatementRow {
    StatementId kind;
    const char* name;  ///< in stores and files; permanent
    const char* words;
};
extern const StatementRow statements[static_cast<std::size_t>(StatementId::not_scored) + 1];

/// "" for an empty statement. A parameter that is missing leaves its name in braces.
std::string words_of(const Statement& statement, Translate translate = in_english);

}  // namespace fulcrum
