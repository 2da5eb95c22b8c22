// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a report as cells with a type: CSV and workbook write the same one.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "ui/reports/report.h"

namespace fulcrum::ui {

struct SheetColumn {
    std::string name, unit, meaning;  ///< unit "-": words, "1": a number without unit
};

/// Empty, words, a finite number, a count, or yes and no (written as 1 and 0).
using SheetCell = std::variant<std::monostate, std::string, double, long long, bool>;

struct DataSheet {
    std::string name;  ///< of the sheet in a workbook, at most 31 characters
    std::vector<SheetColumn> columns;
    std::vector<std::vector<SheetCell>> rows;  ///< a cell for each column
};

/// A row for each person, task and device class.
DataSheet cohort_sheet(const CohortReport& report);
/// A row for each attempt, with a column for each metric that occurs.
DataSheet person_sheet(const PersonReport& report);

/// UTF-8, a row of names, a row of units, formula-injection guard.
std::string sheet_csv(const DataSheet& sheet);
/// A row for each column: name, unit, meaning.
std::string dictionary_csv(const DataSheet& sheet);

/// The bytes of an XLSX workbook: the sheet, whose rows of names and units stay in view; its dictionary;
/// where the figures are from. Words are written as words, so no cell is a formula. Throws StoreError
/// (failed) when it cannot be made.
std::string workbook(const DataSheet& sheet, const ReportProvenance& provenance);

}  // namespace fulcrum::ui
