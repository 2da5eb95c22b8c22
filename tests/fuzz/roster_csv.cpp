// SPDX-License-Identifier: GPL-3.0-or-later
// For any bytes read as a table of people: either an InputError with file and hint, or rows whose cells are
// the same after they were written in quotes and read again.
#include <cstdlib>

#include "database/roster/csv_rows.h"
#include "sim_core/numerics/input_error.h"

namespace {

constexpr const char* columns[] = {"login", "name", "role", "cohort", "sourcedId", "status"};

std::string quoted(const std::string& cell) {
    std::string text = "\"";
    for (const char c : cell) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + '"';
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fulcrum;
    using database::CsvRows;
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const CsvRows rows = CsvRows::parse(text, "fuzz.csv");
        std::string again = "login,name,role,cohort,sourcedId,status\n";
        for (std::size_t row = 0; row < rows.size(); ++row) {
            if (rows.line(row) < 1 || rows.place(row).empty()) std::abort();
            for (const char* column : columns)
                again += quoted(rows.cell(row, column)) + (column == columns[5] ? "\n" : ",");
        }
        const CsvRows read = CsvRows::parse(again, "again.csv");
        if (read.size() != rows.size()) std::abort();
        for (std::size_t row = 0; row < rows.size(); ++row)
            for (const char* column : columns)
                if (read.cell(row, column) != rows.cell(row, column)) std::abort();
        rows.require({"login"});
    } catch (const InputError& error) {
        if (error.file().empty() || error.hint().empty()) std::abort();
    }
    return 0;
}
