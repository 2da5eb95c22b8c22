// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/csv_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace fulcrum::database {
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

std::string guarded_cell(const std::string& cell) {
    return cell == "-" || cell == "%" ? cell : guarded_text(cell);
}

}  // namespace

std::string tsv_text(const std::string& cell) {
    std::string guarded = guarded_cell(cell);
    for (char& c : guarded)
        if (c == '\t' || c == '\r' || c == '\n') c = ' ';
    return guarded;
}

std::string csv_text(const std::string& cell) {
    const std::string guarded = guarded_cell(cell);
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

}  // namespace fulcrum::database
