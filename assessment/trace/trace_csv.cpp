// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/trace_csv.h"

#include <fstream>
#include <istream>
#include <set>
#include <string_view>

#include "assessment/trace/trace_columns.h"
#include "assessment/trace/utf8.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

namespace {

std::vector<Column> read_header(CsvReader& reader, const ColumnMap& known, Trace& trace) {
    if (!reader.next())
        reader.fail_at(1, "t", QT_TRANSLATE_NOOP("errors", "the file is empty"),
                       QT_TRANSLATE_NOOP("errors", "write a row of names, a row of units, then the samples"));
    std::vector<std::string_view> cells = reader.cells();
    if (!cells.empty() && cells[0].substr(0, 3) == "\xEF\xBB\xBF") cells[0].remove_prefix(3);
    if (cells.size() > trace_csv_column_limit)
        reader.fail("(header)", {QT_TRANSLATE_NOOP("errors", "%1 columns"), cells.size()},
                    {QT_TRANSLATE_NOOP("errors", "write at most %1"), trace_csv_column_limit});
    std::vector<Column> columns;
    std::set<std::string, std::less<>> seen;
    for (const std::string_view name : cells) {
        if (!seen.emplace(name).second)
            reader.fail(CsvReader::quoted(name), QT_TRANSLATE_NOOP("errors", "the column occurs twice"),
                        QT_TRANSLATE_NOOP("errors", "remove one"));
        const auto found = known.find(name);
        if (found != known.end()) {
            columns.push_back(found->second);
        } else {
            columns.push_back({});
            columns.back().name = CsvReader::quoted(name);
            if (!name.empty())
                trace.ignored_columns.push_back(is_utf8(name) ? std::string(name) : CsvReader::quoted(name));
        }
    }
    if (seen.count("t") == 0)
        reader.fail("t", QT_TRANSLATE_NOOP("errors", "the column is missing"),
                    QT_TRANSLATE_NOOP("errors", "add t, the time in seconds"));
    return columns;
}

void read_units(CsvReader& reader, const std::vector<Column>& columns) {
    if (!reader.next())
        reader.fail_at(2, "t", QT_TRANSLATE_NOOP("errors", "the row of units is missing"),
                       QT_TRANSLATE_NOOP("errors", "write the units in row 2 (s, m, N, rad, m2, -)"));
    if (reader.cells().size() != columns.size())
        reader.fail("(units)",
                    {QT_TRANSLATE_NOOP("errors", "%1 cells where the header has %2"), reader.cells().size(),
                     columns.size()},
                    QT_TRANSLATE_NOOP("errors", "give every column its unit"));
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (!columns[c].known) continue;
        const std::string_view unit = reader.cells()[c];
        const std::string expected = rule_of(columns[c].quantity).unit;
        const bool same =
            unit == expected || (expected == "-" && unit == "1") || (expected == "m2" && unit == "m²");
        if (!same)
            reader.fail(columns[c].name,
                        {QT_TRANSLATE_NOOP("errors", "unit %1 where '%2' is needed"), CsvReader::quoted(unit),
                         expected},
                        {QT_TRANSLATE_NOOP("errors", "convert the column to %1 and write the unit in row 2"),
                         expected});
    }
}

}  // namespace

Trace read_trace_csv(std::istream& in, const std::string& file) {
    Trace trace;
    const ColumnMap known = known_columns(trace);
    CsvReader reader(in, file);
    const std::vector<Column> columns = read_header(reader, known, trace);
    read_units(reader, columns);
    LabelTable labels(trace.tissues);
    bool blank = false;
    while (reader.next()) {
        const auto& cells = reader.cells();
        if (cells.size() == 1 && cells[0].empty() && columns.size() > 1) {
            blank = true;  // blank lines may only end the file
            continue;
        }
        if (blank || cells.size() != columns.size())
            reader.fail("(row)",
                        blank ? Sentence(QT_TRANSLATE_NOOP("errors", "there is a blank line before it"))
                              : Sentence(QT_TRANSLATE_NOOP("errors", "%1 cells where the header has %2"),
                                         cells.size(), columns.size()),
                        QT_TRANSLATE_NOOP("errors", "give every row one cell per column"));
        if (trace.t.size() == trace_csv_row_limit)
            reader.fail("(row)", {QT_TRANSLATE_NOOP("errors", "more than %1 samples"), trace_csv_row_limit},
                        QT_TRANSLATE_NOOP("errors", "split the trace"));
        for (std::size_t c = 0; c < columns.size(); ++c)
            if (columns[c].known) store_cell(reader, columns[c], cells[c], labels);
        const std::size_t n = trace.t.size();
        if (n > 1 && !(trace.t[n - 1] > trace.t[n - 2]))
            reader.fail("t", QT_TRANSLATE_NOOP("errors", "the time does not increase"),
                        QT_TRANSLATE_NOOP("errors", "sort the rows and remove duplicates"));
        check_unit_lengths(reader, trace);
    }
    if (trace.t.empty())
        reader.fail_at(3, "t", QT_TRANSLATE_NOOP("errors", "no sample follows the units"),
                       QT_TRANSLATE_NOOP("errors", "write one row per sample"));
    split_blocks(trace, {});
    return trace;
}

Trace read_trace_csv(const std::string& path) {
    require_regular_file(path);
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "the file cannot be opened"),
                         QT_TRANSLATE_NOOP("errors", "check the path and its permissions"));
    return read_trace_csv(in, path);
}

}  // namespace fulcrum
