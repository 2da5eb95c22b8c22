// SPDX-License-Identifier: GPL-3.0-or-later
// CSV: UTF-8, a header row, a units row, ISO 8601 UTC, raw beside scaled columns, formula-injection guard.
#include <array>
#include <charconv>
#include <cmath>

#include "ui/reports/report_sheet.h"

namespace fulcrum::ui {
namespace {

/// Whether a spreadsheet takes a cell that begins here for a formula: also after blanks, and with the
/// full-width forms that some of them read as the plain ones.
bool begins_formula(const std::string& cell, std::size_t at) {
    at = cell.find_first_not_of(' ', at);
    if (at == std::string::npos) return false;
    if (std::string("=+-@\t\r\n|%").find(cell[at]) != std::string::npos) return true;
    for (const char* wide : {"\xEF\xBC\x9D", "\xEF\xBC\x8B", "\xEF\xBC\x8D", "\xEF\xBC\xA0", "\xE2\x88\x92"})
        if (cell.compare(at, 3, wide) == 0) return true;
    return false;
}

/// An apostrophe before every place where a formula could begin: the cell itself, and what follows a
/// character at which a spreadsheet of another country splits the row.
std::string guarded_text(const std::string& cell) {
    std::string guarded = begins_formula(cell, 0) ? "'" : "";
    for (std::size_t i = 0; i < cell.size(); ++i) {
        guarded += cell[i];
        const bool splits = std::string(";\t\r\n|").find(cell[i]) != std::string::npos;
        if (splits && begins_formula(cell, i + 1)) guarded += '\'';
    }
    return guarded;
}

}  // namespace

std::string csv_text(const std::string& cell) {
    const std::string guarded = cell == "-" || cell == "%" ? cell : guarded_text(cell);
    if (guarded.find_first_of(",;\"\r\n") == std::string::npos) return guarded;
    std::string quoted = "\"";
    for (const char c : guarded) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

std::string csv_number(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return {};
    std::array<char, 40> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), *value);
    return {buffer.data(), end.ptr};
}

namespace {

std::string cell_text(const SheetCell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return csv_text(*text);
    if (const auto* number = std::get_if<double>(&cell)) return csv_number(*number);
    if (const auto* count = std::get_if<long long>(&cell)) return std::to_string(*count);
    if (const auto* flag = std::get_if<bool>(&cell)) return *flag ? "1" : "0";
    return {};
}

void add_row(std::string& csv, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) csv += (i == 0 ? "" : ",") + cells[i];
    csv += "\r\n";
}

}  // namespace

std::string sheet_csv(const DataSheet& sheet) {
    std::string csv;
    std::vector<std::string> names, units;
    for (const SheetColumn& column : sheet.columns) {
        names.push_back(csv_text(column.name));
        units.push_back(csv_text(column.unit));
    }
    add_row(csv, names);
    add_row(csv, units);
    for (const std::vector<SheetCell>& row : sheet.rows) {
        std::vector<std::string> cells;
        for (const SheetCell& cell : row) cells.push_back(cell_text(cell));
        add_row(csv, cells);
    }
    return csv;
}

std::string dictionary_csv(const DataSheet& sheet) {
    std::string csv;
    add_row(csv, {"column", "unit", "meaning"});
    for (const SheetColumn& column : sheet.columns)
        add_row(csv, {csv_text(column.name), csv_text(column.unit), csv_text(column.meaning)});
    return csv;
}

}  // namespace fulcrum::ui
