// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of the CSV files that the program writes, and of the tables that it copies.
#pragma once

#include <optional>
#include <string>

namespace fulcrum::database {

/// A text cell that no spreadsheet takes for a formula, quoted where CSV needs it.
std::string csv_text(const std::string& cell);
/// The same for text whose cells are separated by tabs: never quoted; a tab or a new line becomes a blank.
std::string tsv_text(const std::string& cell);
/// Shortest decimal that reads back as the same number; empty for none.
std::string csv_number(const std::optional<double>& value);

}  // namespace fulcrum::database
