// SPDX-License-Identifier: Apache-2.0
// The columns of a trace and how a cell becomes a value: shared by the reader of the documented format and by
// the reader of other programs' files. Internal to this room.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/trace/csv_reader.h"
#include "assessment/trace/trace.h"

namespace fulcrum {

/// What a column holds: decides unit, range and how a cell is stored.
enum class Quantity { time, length, unitless, angle, force, torque, area, flag, label, index };

struct ColumnRule {
    Quantity quantity;
    const char* unit;
    double low, high;  ///< in this unit
    const char* hint;
};
const ColumnRule& rule_of(Quantity quantity);

struct Column {
    std::string name;
    bool known = false;
    Quantity quantity = Quantity::time;
    std::vector<double>* numbers = nullptr;
    std::vector<std::int16_t>* indices = nullptr;
    std::vector<std::uint8_t>* flags = nullptr;
    double factor = 1;  ///< from the file's unit to that of the rule
};

using ColumnMap = std::map<std::string, Column, std::less<>>;

/// Every column of the format and where it goes in `trace`.
ColumnMap known_columns(Trace& trace);

/// Labels become indices into Trace::tissues, in the order in which they appear.
class LabelTable {
  public:
    explicit LabelTable(std::vector<std::string>& labels) : labels_(labels) {}
    std::int16_t index(const CsvReader& reader, const Column& column, std::string_view label);

  private:
    std::vector<std::string>& labels_;
    std::int16_t last_ = -1;
};

/// Adds one sample's cell to its column. Throws InputError with row and column.
void store_cell(const CsvReader& reader, const Column& column, std::string_view cell, LabelTable& labels);
/// A time of any size, in the unit of the file. Throws InputError.
double parse_time(const CsvReader& reader, const Column& column, std::string_view cell);
/// Axes and quaternions of the last sample must have length one, or every angle from them is wrong.
void check_unit_lengths(const CsvReader& reader, const Trace& trace);

}  // namespace fulcrum
