// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of counts from which no small count can be read, nor computed from the others. Pure.
#pragma once

#include <optional>
#include <vector>

namespace fulcrum::database {

inline constexpr int least_people = 5;  ///< fewer are never shown

/// Counts with their totals: the last row is the sum of the others, and so is the last column.
struct CountTable {
    std::vector<std::vector<long long>> counts;
    /// How many people each count stands for: fewer than least_people are hidden. Of the same shape.
    std::vector<std::vector<int>> people;
};

/// The counts, nothing where they are hidden: those of fewer than least_people people or below least_people,
/// and as many more as are needed so that no hidden count follows from what is shown: in each row and column
/// that has a hidden one there are two or more, together at least least_people, and no hidden one is the only
/// link between rows and columns (its value would follow from all the sums).
std::vector<std::vector<std::optional<long long>>> suppress_small(const CountTable& table);

}  // namespace fulcrum::database
