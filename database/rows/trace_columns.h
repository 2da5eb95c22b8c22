// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic on the columns of a recorded chunk, wrapping at 32 bits: differences there and back, how
// long a column's codes come out, what other columns say of one.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "database/rows/trace_bits.h"

namespace fulcrum::database::trace_columns {

inline constexpr unsigned highest_order = 3;       ///< of differences
inline constexpr unsigned coefficient_bits = 20;   // two's complement
inline constexpr unsigned coefficient_shift = 10;  // value = coefficient / 1024, so |value| < 512
inline constexpr std::int64_t coefficient_limit = (std::int64_t{1} << (coefficient_bits - 1U)) - 1;

using Column = std::vector<std::uint32_t>;
using Coefficients = std::array<std::int64_t, 3>;
enum Share : unsigned { share_none = 0, share_less = 1, share_plus = 2, share_guided = 3 };

/// Pass 0, 1, 2 of differences in place. Pass p leaves the first p + 1 values alone, so that only the first
/// of a column is large.
inline void difference(Column& column, std::size_t pass) {
    for (std::size_t i = column.size(); i-- > pass + 1;) column[i] -= column[i - 1];
}
inline void restore(Column& column, std::size_t pass) {
    for (std::size_t i = pass + 1; i < column.size(); ++i) column[i] += column[i - 1];
}

/// Sum of bit lengths: what choosing a prediction goes by.
inline std::uint64_t roughness(const Column& column) {
    std::uint64_t bits = 0;
    for (const std::uint32_t value : column) bits += bit_length(zigzag(value));
    return bits;
}

inline std::int64_t signed_value(std::uint32_t value) {
    return static_cast<std::int32_t>(value);
}

/// What the guides' residuals say of a column's, rounded; the same integers on both sides.
inline std::uint32_t guided(const Coefficients& coefficients, const std::array<const Column*, 3>& guides,
                            std::size_t i) {
    std::int64_t sum = std::int64_t{1} << (coefficient_shift - 1U);
    for (std::size_t g = 0; g < 3; ++g) sum += coefficients[g] * signed_value((*guides[g])[i]);
    return static_cast<std::uint32_t>(sum >> coefficient_shift);
}

/// Whether a later column is predicted from this one.
template <typename Columns>
bool is_partner(std::size_t column) {
    for (std::size_t other = column + 1; other < Columns::columns; ++other) {
        if (Columns::partner(other) == static_cast<int>(column)) return true;
    }
    return false;
}

}  // namespace fulcrum::database::trace_columns
