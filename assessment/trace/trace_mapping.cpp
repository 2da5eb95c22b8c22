// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/trace_mapping.h"

#include <algorithm>
#include <fstream>
#include <istream>
#include <iterator>
#include <sstream>

#include "assessment/trace/trace_columns.h"
#include "assessment/trace/trace_csv.h"
#include "assessment/trace/transform_log.h"
#include "assessment/trace/utf8.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {

extern const char* const mapping_schema_text;  // assets/schemas/mapping.schema.json, embedded

namespace {

using nlohmann::json;

struct UnitRow {
    const char* name;
    const char* ours;  // unit of the rule that it belongs to
    double factor;     // from it to ours
};
constexpr double degree = 3.14159265358979323846 / 180;
constexpr UnitRow units[] = {
    {"s", "s", 1},          {"ms", "s", 1e-3}, {"us", "s", 1e-6},   {"ns", "s", 1e-9}, {"min", "s", 60},
    {"m", "m", 1},          {"cm", "m", 1e-2}, {"mm", "m", 1e-3},   {"um", "m", 1e-6}, {"rad", "rad", 1},
    {"deg", "rad", degree}, {"N", "N", 1},     {"mN", "N", 1e-3},   {"N m", "N m", 1}, {"N mm", "N m", 1e-3},
    {"mN m", "N m", 1e-3},  {"m2", "m2", 1},   {"mm2", "m2", 1e-6}, {"-", "-", 1},     {"1", "-", 1},
};

std::string units_of(const std::string& ours) {
    std::string names;
    for (const UnitRow& row : units)
        if (row.ours == ours) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

double factor_of(const JsonDocument& document, const std::string& place, const std::string& unit,
                 const std::string& ours) {
    for (const UnitRow& row : units)
        if (unit == row.name && ours == row.ours) return row.factor;
    document.fail(
        place + "/unit",
        {QT_TRANSLATE_NOOP("errors", "unit \"%1\" where one of %2 is needed"), unit, units_of(ours)},
        QT_TRANSLATE_NOOP("errors", "give the unit that the file has"));
}

void check_transform_column(const JsonDocument& document, const std::string& place, const std::string& name,
                            const json& source) {
    if (name == "t")
        document.fail(place, QT_TRANSLATE_NOOP("errors", "poses have a time already"),
                      QT_TRANSLATE_NOOP("errors", "remove it"));
    if (!source.is_string() || device_of_column(source.get<std::string>()).empty())
        document.fail(
            place + "/column", QT_TRANSLATE_NOOP("errors", "does not name a device and an entry of its pose"),
            QT_TRANSLATE_NOOP("errors", "write DEVICE.x, .y or .z, or for an axis DEVICE.z_axis.x"));
}

/// Reads how the rows of a table are written, which a recording of poses does not have.
void read_layout(const JsonDocument& document, TraceMapping& mapping) {
    const json& root = document.root();
    mapping.transforms = root.value("format", "table") == "transforms";
    for (const char* key : {"separator", "header_rows", "rate_hz", "missing"})
        if (mapping.transforms && root.contains(key))
            document.fail("/" + std::string(key),
                          QT_TRANSLATE_NOOP("errors", "has no meaning for a recording of poses"),
                          QT_TRANSLATE_NOOP("errors", "remove it"));
    const std::string separator = root.value("separator", "comma");
    mapping.separator = separator == "comma"       ? ','
                        : separator == "semicolon" ? ';'
                        : separator == "tab"       ? '\t'
                                                   : ' ';
    mapping.header_rows = root.value("header_rows", 1);
    if (root.contains("rate_hz")) mapping.rate = root.at("rate_hz").get<double>();
    if (root.contains("missing")) mapping.missing = root.at("missing").get<std::vector<std::string>>();
}

MappedColumn read_column(const JsonDocument& document, const ColumnMap& known, const std::string& name,
                         const json& node, const TraceMapping& mapping) {
    const std::string place = "/columns/" + name;
    const auto found = known.find(name);
    if (found == known.end())
        document.fail(place, QT_TRANSLATE_NOOP("errors", "is not a column of a trace"),
                      QT_TRANSLATE_NOOP("errors", "see the table of columns in docs/FORMATS.md"));
    MappedColumn column;
    column.name = name;
    const json& source = node.at("column");
    if (mapping.transforms) check_transform_column(document, place, name, source);
    if (source.is_string()) {
        column.column = source.get<std::string>();
        if (mapping.header_rows == 0)
            document.fail(
                place + "/column", QT_TRANSLATE_NOOP("errors", "is a name, but the file has no row of names"),
                QT_TRANSLATE_NOOP("errors", "give the number of the column, from 1, or raise header_rows"));
    } else {
        column.number = source.get<int>();
    }
    column.unit = node.at("unit").get<std::string>();
    column.factor = node.value("factor", 1.0) *
                    factor_of(document, place, column.unit, rule_of(found->second.quantity).unit);
    const Quantity quantity = found->second.quantity;
    if (column.factor != 1 &&
        (quantity == Quantity::flag || quantity == Quantity::label || quantity == Quantity::index))
        document.fail(place + "/factor", QT_TRANSLATE_NOOP("errors", "has no meaning for this column"),
                      QT_TRANSLATE_NOOP("errors", "remove it"));
    return column;
}

TraceMapping read_mapping(const JsonDocument& document) {
    document.check_schema(mapping_schema_text);
    const json& root = document.root();
    TraceMapping mapping;
    mapping.title = root.at("title").get<std::string>();
    read_layout(document, mapping);
    Trace names;
    const ColumnMap known = known_columns(names);
    for (const auto& [name, node] : root.at("columns").items())
        mapping.columns.push_back(read_column(document, known, name, node, mapping));
    const bool has_time = root.at("columns").contains("t");
    if (has_time && mapping.rate)
        document.fail("/rate_hz", QT_TRANSLATE_NOOP("errors", "the columns have a time already"),
                      QT_TRANSLATE_NOOP("errors", "remove rate_hz or the column t"));
    if (!has_time && !mapping.rate && !mapping.transforms)
        document.fail("/columns", QT_TRANSLATE_NOOP("errors", "there is no time"),
                      QT_TRANSLATE_NOOP("errors", "map the column t or give rate_hz"));
    return mapping;
}

/// Which column of a row each mapped column is.
class MappedReader {
  public:
    MappedReader(std::istream& in, const std::string& file, const TraceMapping& mapping, Trace& trace)
        : mapping_(mapping), trace_(trace), reader_(in, file, mapping.separator), labels_(trace.tissues) {
        const ColumnMap known = known_columns(trace);
        for (const MappedColumn& mapped : mapping.columns) {
            Column column = known.find(mapped.name)->second;
            column.factor = mapped.factor;
            columns_.push_back(column);
        }
    }
    /// The samples that were left out.
    std::size_t read() {
        read_header();
        std::size_t samples = 0, left_out = 0;
        while (reader_.next()) {
            const auto& cells = reader_.cells();
            if (cells.size() == 1 && cells[0].empty()) continue;
            if (cells.size() < needed_)
                reader_.fail(
                    "(row)",
                    {QT_TRANSLATE_NOOP("errors", "%1 cells, but column %2 is mapped"), cells.size(), needed_},
                    QT_TRANSLATE_NOOP("errors", "check separator and columns of the mapping"));
            if (samples == trace_csv_row_limit)
                reader_.fail("(row)",
                             {QT_TRANSLATE_NOOP("errors", "more than %1 samples"), trace_csv_row_limit},
                             QT_TRANSLATE_NOOP("errors", "split the trace"));
            if (is_missing()) {
                ++left_out;
            } else {
                store(samples);
            }
            ++samples;
        }
        if (trace_.t.empty())
            reader_.fail_at(static_cast<std::size_t>(mapping_.header_rows) + 1, "t",
                            QT_TRANSLATE_NOOP("errors", "the file has no sample"),
                            QT_TRANSLATE_NOOP("errors", "check header_rows and missing of the mapping"));
        return left_out;
    }

  private:
    void read_header() {
        for (int row = 0; row < mapping_.header_rows; ++row)
            if (!reader_.next())
                reader_.fail_at(static_cast<std::size_t>(row) + 1, "(header)",
                                QT_TRANSLATE_NOOP("errors", "the file ends in its header"),
                                QT_TRANSLATE_NOOP("errors", "check header_rows of the mapping"));
        std::vector<std::string_view> names =
            mapping_.header_rows > 0 ? reader_.cells() : std::vector<std::string_view>();
        if (!names.empty() && names[0].substr(0, 3) == "\xEF\xBB\xBF") names[0].remove_prefix(3);
        for (const MappedColumn& mapped : mapping_.columns) {
            std::size_t place = static_cast<std::size_t>(mapped.number) - 1;
            if (mapped.number == 0) {
                const auto found = std::find(names.begin(), names.end(), mapped.column);
                if (found == names.end())
                    reader_.fail(CsvReader::quoted(mapped.column),
                                 QT_TRANSLATE_NOOP("errors", "the column is not in the file"),
                                 QT_TRANSLATE_NOOP("errors", "correct its name in the mapping"));
                place = static_cast<std::size_t>(found - names.begin());
            }
            places_.push_back(place);
            needed_ = std::max(needed_, place + 1);
        }
        for (std::size_t i = 0; i < names.size(); ++i)
            if (std::find(places_.begin(), places_.end(), i) == places_.end() && !names[i].empty())
                trace_.ignored_columns.push_back(is_utf8(names[i]) ? std::string(names[i])
                                                                   : CsvReader::quoted(names[i]));
    }
    bool is_missing() const {
        return std::any_of(places_.begin(), places_.end(), [this](std::size_t place) {
            const std::string_view cell = reader_.cells()[place];
            return std::find(mapping_.missing.begin(), mapping_.missing.end(), cell) !=
                   mapping_.missing.end();
        });
    }
    void store(std::size_t sample) {
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            if (columns_[c].quantity == Quantity::time) {
                store_time(columns_[c], reader_.cells()[places_[c]]);
            } else {
                store_cell(reader_, columns_[c], reader_.cells()[places_[c]], labels_);
            }
        }
        if (mapping_.rate) trace_.t.push_back(static_cast<double>(sample) / *mapping_.rate);
        const std::size_t n = trace_.t.size();
        if (trace_.t.back() > trace_csv_time_limit)
            reader_.fail("t", QT_TRANSLATE_NOOP("errors", "more than 2 h after the first sample"),
                         QT_TRANSLATE_NOOP("errors", "split the trace"));
        if (n > 1 && !(trace_.t[n - 1] > trace_.t[n - 2]))
            reader_.fail("t", QT_TRANSLATE_NOOP("errors", "the time does not increase"),
                         QT_TRANSLATE_NOOP("errors", "sort the rows and remove duplicates"));
        check_unit_lengths(reader_, trace_);
    }
    /// Clocks of other programs may begin anywhere: the first sample is at 0.
    void store_time(const Column& column, std::string_view cell) {
        const double time = parse_time(reader_, column, cell);
        if (trace_.t.empty()) first_ = time;
        trace_.t.push_back((time - first_) * column.factor);
    }

    const TraceMapping& mapping_;
    Trace& trace_;
    CsvReader reader_;
    LabelTable labels_;
    std::vector<Column> columns_;
    std::vector<std::size_t> places_;  // of each of columns_ in a row, from 0
    std::size_t needed_ = 1;           // cells of a row
    double first_ = 0;                 // time of the first sample in the file's unit
};

}  // namespace

TraceMapping parse_trace_mapping(const std::string& text, const std::string& file) {
    return read_mapping(JsonDocument::parse(text, file));
}

TraceMapping load_trace_mapping(const std::string& path) {
    return read_mapping(JsonDocument::load(path));
}

namespace {

/// By way of the table that the poses make.
MappedTrace read_transforms(std::istream& in, const std::string& file, const TraceMapping& mapping) {
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    std::vector<std::string> wanted;
    TraceMapping of_table;
    of_table.columns.push_back({"t", {}, 1, 1});
    for (const MappedColumn& column : mapping.columns) {
        wanted.push_back(column.column);
        of_table.columns.push_back(
            {column.name, {}, static_cast<int>(of_table.columns.size()) + 1, column.factor});
    }
    const TransformTable table = transform_table(text, file, wanted);
    std::istringstream rows(table.text);
    MappedTrace mapped = read_mapped_trace(rows, file, of_table);
    mapped.left_out += table.left_out;
    mapped.trace.ignored_columns = table.ignored;
    return mapped;
}

}  // namespace

MappedTrace read_mapped_trace(std::istream& in, const std::string& file, const TraceMapping& mapping) {
    if (mapping.transforms) return read_transforms(in, file, mapping);
    MappedTrace mapped;
    mapped.left_out = MappedReader(in, file, mapping, mapped.trace).read();
    split_blocks(mapped.trace, {});
    return mapped;
}

MappedTrace read_mapped_trace(const std::string& path, const TraceMapping& mapping) {
    require_regular_file(path);
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "the file cannot be opened"),
                         QT_TRANSLATE_NOOP("errors", "check the path and its permissions"));
    return read_mapped_trace(in, path, mapping);
}

}  // namespace fulcrum
