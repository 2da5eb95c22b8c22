// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/trace_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "assessment/trace/utf8.h"

namespace fulcrum {
namespace {

constexpr std::size_t label_limit = 64;  // bytes

/// In the unit of the file.
double parse_raw(const CsvReader& reader, const Column& column, std::string_view cell) {
    const ColumnRule& rule = rule_of(column.quantity);
    if (cell.empty()) reader.fail(column.name, QT_TRANSLATE_NOOP("errors", "the cell is empty"), rule.hint);
    if (cell.front() == '+') cell.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error == std::errc::result_out_of_range)
        reader.fail(column.name, {QT_TRANSLATE_NOOP("errors", "%1 is out of range"), CsvReader::quoted(cell)},
                    rule.hint);
    if (error != std::errc() || end != cell.data() + cell.size())
        reader.fail(column.name, {QT_TRANSLATE_NOOP("errors", "%1 is not a number"), CsvReader::quoted(cell)},
                    rule.hint);
    if (!std::isfinite(value))
        reader.fail(column.name,
                    {QT_TRANSLATE_NOOP("errors", "%1 is not a finite number"), CsvReader::quoted(cell)},
                    QT_TRANSLATE_NOOP("errors", "leave the sample out or give the value"));
    return value;
}

double parse_number(const CsvReader& reader, const Column& column, std::string_view cell) {
    const ColumnRule& rule = rule_of(column.quantity);
    const double value = column.factor * parse_raw(reader, column, cell);
    if (value < rule.low || value > rule.high)
        reader.fail(column.name, {QT_TRANSLATE_NOOP("errors", "%1 is out of range"), CsvReader::quoted(cell)},
                    rule.hint);
    return value;
}

void check_unit_length(const CsvReader& reader, const std::string& column,
                       std::initializer_list<const std::vector<double>*> parts) {
    double sum = 0;
    for (const auto* part : parts) {
        if (part->empty()) return;
        sum += part->back() * part->back();
    }
    if (std::abs(sum - 1.0) > 0.02)
        reader.fail(column,
                    {QT_TRANSLATE_NOOP("errors", "not of length one (%1)"), std::to_string(std::sqrt(sum))},
                    QT_TRANSLATE_NOOP("errors", "normalise it"));
}

}  // namespace

const ColumnRule& rule_of(Quantity quantity) {
    static const ColumnRule rules[] = {
        {Quantity::time, "s", -1.0, trace_csv_time_limit,
         QT_TRANSLATE_NOOP("errors", "give t in seconds since the attempt began, at most 2 h")},
        {Quantity::length, "m", -10.0, 10.0, QT_TRANSLATE_NOOP("errors", "give positions in metres")},
        {Quantity::unitless, "-", -1.001, 1.001,
         QT_TRANSLATE_NOOP("errors", "give components of a unit vector or quaternion")},
        {Quantity::angle, "rad", -1e4, 1e4, QT_TRANSLATE_NOOP("errors", "give angles in radians")},
        {Quantity::force, "N", -1e4, 1e4, QT_TRANSLATE_NOOP("errors", "give forces in newtons")},
        {Quantity::torque, "N m", -1e4, 1e4, QT_TRANSLATE_NOOP("errors", "give torques in newton metres")},
        {Quantity::area, "m2", 0.0, 1.0, QT_TRANSLATE_NOOP("errors", "give areas in square metres")},
        {Quantity::flag, "-", 0.0, 1.0, QT_TRANSLATE_NOOP("errors", "write 1 or 0")},
        {Quantity::label, "-", 0.0, 0.0,
         QT_TRANSLATE_NOOP("errors", "write a label or leave the cell empty")},
        {Quantity::index, "-", -1.0, 32767.0,
         QT_TRANSLATE_NOOP("errors", "write a whole number from -1 to 32767")},
    };
    return rules[static_cast<std::size_t>(quantity)];
}

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

std::int16_t LabelTable::index(const CsvReader& reader, const Column& column, std::string_view label) {
    if (label.empty()) return -1;
    if (last_ >= 0 && labels_[static_cast<std::size_t>(last_)] == label) return last_;
    const auto found = std::find(labels_.begin(), labels_.end(), label);
    if (found == labels_.end()) {
        if (label.size() > label_limit || !is_utf8(label))
            reader.fail(column.name,
                        {QT_TRANSLATE_NOOP("errors", "%1 is not a tissue label"), CsvReader::quoted(label)},
                        {QT_TRANSLATE_NOOP("errors", "use UTF-8 text of at most %1 bytes"), label_limit});
        if (labels_.size() == trace_csv_tissue_limit)
            reader.fail(
                column.name,
                {QT_TRANSLATE_NOOP("errors", "more than %1 different labels"), trace_csv_tissue_limit},
                QT_TRANSLATE_NOOP("errors", "use one label per tissue"));
        labels_.emplace_back(label);
        last_ = static_cast<std::int16_t>(labels_.size() - 1);
    } else {
        last_ = static_cast<std::int16_t>(found - labels_.begin());
    }
    return last_;
}

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
            reader.fail(column.name,
                        {QT_TRANSLATE_NOOP("errors", "%1 is not a whole number"), CsvReader::quoted(cell)},
                        rule_of(column.quantity).hint);
        if (column.flags != nullptr) column.flags->push_back(value > 0 ? 1 : 0);
        if (column.indices != nullptr) column.indices->push_back(static_cast<std::int16_t>(value));
    }
}

double parse_time(const CsvReader& reader, const Column& column, std::string_view cell) {
    return parse_raw(reader, column, cell);
}

void check_unit_lengths(const CsvReader& reader, const Trace& trace) {
    check_unit_length(reader, "left.ax", {&trace.hand[0].ax, &trace.hand[0].ay, &trace.hand[0].az});
    check_unit_length(reader, "right.ax", {&trace.hand[1].ax, &trace.hand[1].ay, &trace.hand[1].az});
    check_unit_length(reader, "camera.qw",
                      {&trace.camera.qw, &trace.camera.qx, &trace.camera.qy, &trace.camera.qz});
}

}  // namespace fulcrum
