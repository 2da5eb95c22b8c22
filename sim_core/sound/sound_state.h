// SPDX-License-Identifier: Apache-2.0
// What is to be heard of an attempt, as numbers that one thread hands to another (SharedLatest). Left hand
// first.
#pragma once

#include <cstdint>
#include <type_traits>

namespace fulcrum {

struct SoundState {
    double volume = 0;                   ///< 0 to 1
    std::uint64_t contacts[2] = {0, 0};  ///< counts them: each change is one click
    double strength[2] = {0, 0};         ///< 0 to 1, of the newest contact
    std::uint64_t hard[2] = {0, 0};      ///< 1: it was with something that has no limit of force
    double excess[2] = {0, 0};           ///< force beyond the tissue's limit, as a share of it; 0: none
    std::uint64_t energy[2] = {0, 0};    ///< 1: energy is on
    std::uint64_t bleeding = 0;          ///< 1: faster than the alarm allows
    std::uint64_t tests = 0;             ///< counts them: each change plays every sound once
};
static_assert(std::is_trivially_copyable_v<SoundState>);

}  // namespace fulcrum
