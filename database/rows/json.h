// SPDX-License-Identifier: GPL-3.0-or-later
// Small JSON texts for audit payloads and evidence; internal to this floor.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::database {

/// {"key": "value", ...} with strings escaped, in the order given.
std::string json_object(std::initializer_list<std::pair<const char*, std::string>> members);
/// [[t0, t1], ...], shortest digits that read back to the same number.
std::string json_intervals(const std::vector<std::pair<double, double>>& intervals);
/// The reverse; pairs that are not two numbers are left out.
std::vector<std::pair<double, double>> parse_intervals(const std::string& text);

}  // namespace fulcrum::database
