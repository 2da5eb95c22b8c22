// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/trace_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <functional>
#include <istream>
#include <limits>
#include <map>
#include <set>
#include <string_view>

#include "assessment/trace/csv_reader.h"
#include "assessment/trace/utf8.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

namespace {

constexpr std::size_t label_limit = 64;  // bytes

/// What a column holds: decides unit, range and how a cell is stored.
enum class Quantity { time, length, unitless, angle, force, torque, area, flag, label, index };

struct ColumnRule {
    Quantity quantity;
    const char* unit;
    double low, high;
    const char* hint;
};

const ColumnRule& rule_of(Quantity quantity) {
    static const ColumnRule rules[] = {
        {Quantity::time, "s", -1.0, trace_csv_time_limit,
         "give t in seconds since the attempt began, at most 2 h"},
        {Quantity::length, "m", -10.0, 10.0, "give positions in metres"},
        {Quantity::unitless, "-", -1.001, 1.001, "give components of a unit vector or quaternion"},
        {Quantity::angle, "rad", -1e4, 1e4, "give angles in radians"},
        {Quantity::force, "N", -1e4, 1e4, "give forces in newtons"},
        {Quantity::torque, "N m", -1e4, 1e4, "give torques in newton metres"},
        {Quantity::area, "m2", 0.0, 1.0, "give areas in square metres"},
        {Quantity::flag, "-", 0.0, 1.0, "write 1 or 0"},
        {Quantity::label, "-", 0.0, 0.0, "write a label or leave the cell empty"},
        {Quantity::index, "-", -1.0, 32767.0, "write a whole number from -1 to 32767"},
    };
    return rules[static_cast<std::size_t>(quantity)];
}

struct Column {
    std::string name;
    bool known = false;
    Quantity quantity = Quantity::time;
    std::vector<double>* numbers = nullptr;
    std::vector<std::int16_t>* indices = nullptr;
    std::vector<std::uint8_t>* flags = nullptr;
};

using ColumnMap = std::map<std::string, Column, std::less<>>;

/// Every column of the format and where it goes.
ColumnMap known_columns(Trace& trace) {
    ColumnMap map;
    const auto number = [&](const std::string& name, Quantity quantity, std::vector<double>& target) {
        map[name] = {name, true, quantity, &target, nullptr, nullptr};
    };
    number("t", Quantity::time, trace.t);
    for (std::size_t h = 0; h < trace.hand.size(); ++h) {
        const std::string prefix = std::string(hand_name(static_cast<Hand>(h))) + ".";
        HandTrace& hand = trace.hand[h];
        number(prefix + "px", Quantity::length, hand.px);
        number(prefix + "py", Quantity::length, hand.py);
        number(prefix + "pz", Quantity::length, hand.pz);
        number(prefix + "ax", Quantity::unitless, hand.ax);
        number(prefix + "ay", Quantity::unitless, hand.ay);
        number(prefix + "az", Quantity::unitless, hand.az);
        number(prefix + "roll", Quantity::angle, hand.roll);
        number(prefix + "fx", Quantity::force, hand.fx);
        number(prefix + "fy", Quantity::force, hand.fy);
        number(prefix + "fz", Quantity::force, hand.fz);
        number(prefix + "tx", Quantity::torque, hand.tx);
        number(prefix + "ty", Quantity::torque, hand.ty);
        number(prefix + "tz", Quantity::torque, hand.tz);
        number(prefix + "jaw", Quantity::force, hand.jaw_force);
        number(prefix + "jaw_area", Quantity::area, hand.jaw_area);
        const auto small = [&](const char* name, Quantity quantity, std::vector<std::int16_t>& target) {
            map[prefix + name] = {prefix + name, true, quantity, nullptr, &target, nullptr};
        };
        small("tissue", Quantity::label, hand.tissue);
        small("patch", Quantity::index, hand.patch);
        const auto flag = [&](const char* name, std::vector<std::uint8_t>& target) {
            map[prefix + name] = {prefix + name, true, Quantity::flag, nullptr, nullptr, &target};
        };
        flag("inside", hand.inside);
        flag("in_view", hand.in_view);
        flag("energy", hand.energy);
        flag("cutting", hand.cutting);
    }
    CameraTrace& camera = trace.camera;
    number("camera.px", Quantity::length, camera.px);
    number("camera.py", Quantity::length, camera.py);
    number("camera.pz", Quantity::length, camera.pz);
    number("camera.qw", Quantity::unitless, camera.qw);
    number("camera.qx", Quantity::unitless, camera.qx);
    number("camera.qy", Quantity::unitless, camera.qy);
    number("camera.qz", Quantity::unitless, camera.qz);
    return map;
}

std::vector<Column> read_header(CsvReader& reader, const ColumnMap& known, Trace& trace) {
    if (!reader.next())
        reader.fail_at(1, "t", "the file is empty", "write a row of names, a row of units, then the samples");
    std::vector<std::string_view> cells = reader.cells();
    if (!cells.empty() && cells[0].substr(0, 3) == "\xEF\xBB\xBF") cells[0].remove_prefix(3);
    if (cells.size() > trace_csv_column_limit)
        reader.fail("(header)", std::to_string(cells.size()) + " columns",
                    "write at most " + std::to_string(trace_csv_column_limit));
    std::vector<Column> columns;
    std::set<std::string, std::less<>> seen;
    for (const std::string_view name : cells) {
        if (!seen.emplace(name).second)
            reader.fail(CsvReader::quoted(name), "the column is there twice", "remove one");
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
    if (seen.count("t") == 0) reader.fail("t", "the column is missing", "add t, the time in seconds");
    return columns;
}

void read_units(CsvReader& reader, const std::vector<Column>& columns) {
    if (!reader.next())
        reader.fail_at(2, "t", "the row of units is missing",
                       "write the units in row 2 (s, m, N, rad, m2, -)");
    if (reader.cells().size() != columns.size())
        reader.fail("(units)",
                    std::to_string(reader.cells().size()) + " cells where the header has " +
                        std::to_string(columns.size()),
                    "give every column its unit");
    for (std::size_t c = 0; c < columns.size(); ++c) {
        if (!columns[c].known) continue;
        const std::string_view unit = reader.cells()[c];
        const std::string expected = rule_of(columns[c].quantity).unit;
        const bool same =
            unit == expected || (expected == "-" && unit == "1") || (expected == "m2" && unit == "m²");
        if (!same)
            reader.fail(columns[c].name,
                        "unit " + CsvReader::quoted(unit) + " where '" + expected + "' is needed",
                        "convert the column to " + expected + " and write the unit in row 2");
    }
}

double parse_number(const CsvReader& reader, const Column& column, std::string_view cell) {
    const ColumnRule& rule = rule_of(column.quantity);
    if (cell.empty()) reader.fail(column.name, "the cell is empty", rule.hint);
    if (cell.front() == '+') cell.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error == std::errc::result_out_of_range)
        reader.fail(column.name, CsvReader::quoted(cell) + " is out of range", rule.hint);
    if (error != std::errc() || end != cell.data() + cell.size())
        reader.fail(column.name, CsvReader::quoted(cell) + " is not a number", rule.hint);
    if (!std::isfinite(value))
        reader.fail(column.name, CsvReader::quoted(cell) + " is not a finite number",
                    "leave the sample out or give the value");
    if (value < rule.low || value > rule.high)
        reader.fail(column.name, CsvReader::quoted(cell) + " is out of range", rule.hint);
    return value;
}

/// Labels become indices into Trace::tissues, in the order in which they appear.
class LabelTable {
  public:
    explicit LabelTable(std::vector<std::string>& labels) : labels_(labels) {}
    std::int16_t index(const CsvReader& reader, const Column& column, std::string_view label) {
        if (label.empty()) return -1;
        if (last_ >= 0 && labels_[static_cast<std::size_t>(last_)] == label) return last_;
        const auto found = std::find(labels_.begin(), labels_.end(), label);
        if (found == labels_.end()) {
            if (label.size() > label_limit || !is_utf8(label))
                reader.fail(column.name, CsvReader::quoted(label) + " is not a tissue label",
                            "use UTF-8 text of at most " + std::to_string(label_limit) + " bytes");
            if (labels_.size() == trace_csv_tissue_limit)
                reader.fail(column.name,
                            "more than " + std::to_string(trace_csv_tissue_limit) + " different labels",
                            "use one label a tissue");
            labels_.emplace_back(label);
            last_ = static_cast<std::int16_t>(labels_.size() - 1);
        } else {
            last_ = static_cast<std::int16_t>(found - labels_.begin());
        }
        return last_;
    }

  private:
    std::vector<std::string>& labels_;
    std::int16_t last_ = -1;
};

void store_cell(const CsvReader& reader, const Column& column, std::string_view cell, LabelTable& labels) {
    if (column.quantity == Quantity::label) {
        column.indices->push_back(labels.index(reader, column, cell));
        return;
    }
    const double value = parse_number(reader, column, cell);
    if (column.numbers != nullptr) {
        column.numbers->push_back(value);
    } else {
        if (value != std::floor(value))
            reader.fail(column.name, CsvReader::quoted(cell) + " is not a whole number",
                        rule_of(column.quantity).hint);
        if (column.flags != nullptr) column.flags->push_back(value > 0 ? 1 : 0);
        if (column.indices != nullptr) column.indices->push_back(static_cast<std::int16_t>(value));
    }
}

/// Axes and quaternions must have length one, or every angle from them is wrong.
void check_unit_length(const CsvReader& reader, const std::string& column,
                       std::initializer_list<const std::vector<double>*> parts) {
    double sum = 0;
    for (const auto* part : parts) {
        if (part->empty()) return;
        sum += part->back() * part->back();
    }
    if (std::abs(sum - 1.0) > 0.02)
        reader.fail(column, "not of length one (" + std::to_string(std::sqrt(sum)) + ")", "normalise it");
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
                        blank ? "there is a blank line before it"
                              : std::to_string(cells.size()) + " cells where the header has " +
                                    std::to_string(columns.size()),
                        "give every row one cell a column");
        if (trace.t.size() == trace_csv_row_limit)
            reader.fail("(row)", "more than " + std::to_string(trace_csv_row_limit) + " samples",
                        "split the trace");
        for (std::size_t c = 0; c < columns.size(); ++c)
            if (columns[c].known) store_cell(reader, columns[c], cells[c], labels);
        const std::size_t n = trace.t.size();
        if (n > 1 && !(trace.t[n - 1] > trace.t[n - 2]))
            reader.fail("t", "the time does not rise", "sort the rows and remove doubled ones");
        check_unit_length(reader, "left.ax", {&trace.hand[0].ax, &trace.hand[0].ay, &trace.hand[0].az});
        check_unit_length(reader, "right.ax", {&trace.hand[1].ax, &trace.hand[1].ay, &trace.hand[1].az});
        check_unit_length(reader, "camera.qw",
                          {&trace.camera.qw, &trace.camera.qx, &trace.camera.qy, &trace.camera.qz});
    }
    if (trace.t.empty()) reader.fail_at(3, "t", "no sample follows the units", "write one row a sample");
    split_blocks(trace, {});
    return trace;
}

Trace read_trace_csv(const std::string& path) {
    require_regular_file(path);
    std::ifstream in(path, std::ios::binary);
    if (!in) throw InputError(path, "", "the file cannot be opened", "check the path and its permissions");
    return read_trace_csv(in, path);
}

}  // namespace fulcrum
