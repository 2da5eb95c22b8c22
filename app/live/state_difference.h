// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames of one replay follow one another closely, and most of a state does not change from one to the
// next: what is kept is the difference.
#pragma once

#include <cstdint>
#include <vector>

namespace fulcrum::app {

/// A state as bytes (sim_core/numerics/state_archive.h) with the places at which its tables begin.
struct StateImage {
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint32_t> starts;  ///< ascending, none beyond the end
};

/// What makes `to` out of `from`. Right for any two states; small where tables with the same number are
/// nearly the same, whatever their lengths.
std::vector<std::uint8_t> state_difference(const StateImage& from, const StateImage& to);

/// Applies it to the state that it was made from. `spare`: anything; its memory is used where tables changed
/// their length. Throws StateArchiveError where the difference is not one of this state, whose bytes may have
/// changed then.
void apply_difference(StateImage& image, const std::vector<std::uint8_t>& difference, StateImage& spare);

}  // namespace fulcrum::app
