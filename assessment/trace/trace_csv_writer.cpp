// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <ostream>
#include <string>

#include "assessment/trace/trace_csv.h"

namespace fulcrum {

namespace {

/// One column to write: a name, a unit, and where its cells come from.
struct Output {
    std::string name;
    const char* unit;
    const std::vector<double>* numbers = nullptr;
    const std::vector<std::int16_t>* indices = nullptr;
    const std::vector<std::uint8_t>* flags = nullptr;
    bool label = false;
};

std::vector<Output> outputs_of(const Trace& trace) {
    std::vector<Output> outputs;
    const auto number = [&](const std::string& name, const char* unit, const std::vector<double>& column) {
        if (!column.empty()) outputs.push_back({name, unit, &column});
    };
    number("t", "s", trace.t);
    for (std::size_t h = 0; h < trace.hand.size(); ++h) {
        const std::string prefix = std::string(hand_name(static_cast<Hand>(h))) + ".";
        const HandTrace& hand = trace.hand[h];
        number(prefix + "px", "m", hand.px);
        number(prefix + "py", "m", hand.py);
        number(prefix + "pz", "m", hand.pz);
        number(prefix + "ax", "-", hand.ax);
        number(prefix + "ay", "-", hand.ay);
        number(prefix + "az", "-", hand.az);
        number(prefix + "roll", "rad", hand.roll);
        number(prefix + "fx", "N", hand.fx);
        number(prefix + "fy", "N", hand.fy);
        number(prefix + "fz", "N", hand.fz);
        number(prefix + "tx", "N m", hand.tx);
        number(prefix + "ty", "N m", hand.ty);
        number(prefix + "tz", "N m", hand.tz);
        number(prefix + "jaw", "N", hand.jaw_force);
        number(prefix + "jaw_area", "m2", hand.jaw_area);
        const auto index = [&](const char* name, const std::vector<std::int16_t>& column, bool label) {
            if (!column.empty()) outputs.push_back({prefix + name, "-", nullptr, &column, nullptr, label});
        };
        index("tissue", hand.tissue, true);
        index("patch", hand.patch, false);
        const auto flag = [&](const char* name, const std::vector<std::uint8_t>& column) {
            if (!column.empty()) outputs.push_back({prefix + name, "-", nullptr, nullptr, &column, false});
        };
        flag("inside", hand.inside);
        flag("in_view", hand.in_view);
        flag("energy", hand.energy);
        flag("cutting", hand.cutting);
    }
    number("camera.px", "m", trace.camera.px);
    number("camera.py", "m", trace.camera.py);
    number("camera.pz", "m", trace.camera.pz);
    number("camera.qw", "-", trace.camera.qw);
    number("camera.qx", "-", trace.camera.qx);
    number("camera.qy", "-", trace.camera.qy);
    number("camera.qz", "-", trace.camera.qz);
    return outputs;
}

void append_cell(std::string& line, const Output& output, std::size_t row, const Trace& trace) {
    char text[32];
    char* end = text;
    if (output.numbers != nullptr) {
        end = std::to_chars(text, text + sizeof text, (*output.numbers)[row]).ptr;
    } else if (output.flags != nullptr) {
        *end++ = (*output.flags)[row] != 0 ? '1' : '0';
    } else if (!output.label) {
        end = std::to_chars(text, text + sizeof text, (*output.indices)[row]).ptr;
    } else if ((*output.indices)[row] >= 0) {
        line += trace.tissues.at(static_cast<std::size_t>((*output.indices)[row]));
    }
    line.append(text, end);
}

}  // namespace

void write_trace_csv(const Trace& trace, std::ostream& out) {
    const std::vector<Output> outputs = outputs_of(trace);
    std::string names, units;
    for (const Output& output : outputs) {
        names += (names.empty() ? "" : ",") + output.name;
        units += std::string(units.empty() ? "" : ",") + output.unit;
    }
    out << names << '\n' << units << '\n';
    std::string line;
    for (std::size_t row = 0; row < trace.t.size(); ++row) {
        line.clear();
        for (std::size_t c = 0; c < outputs.size(); ++c) {
            if (c > 0) line += ',';
            append_cell(line, outputs[c], row, trace);
        }
        line += '\n';
        out << line;
    }
}

}  // namespace fulcrum
