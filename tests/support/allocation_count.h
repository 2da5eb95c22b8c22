// SPDX-License-Identifier: Apache-2.0
// Counts heap allocations of this process, so that "no allocation in the loop" is a test.
#pragma once

#include <cstdint>

namespace fulcrum::test {

/// Allocations so far on all threads: malloc and its kin, and with them operator new and Eigen.
std::uint64_t allocation_count();

/// Allocations that a call makes.
template <typename Call>
std::uint64_t allocations_in(Call&& call) {
    const std::uint64_t before = allocation_count();
    call();
    return allocation_count() - before;
}

}  // namespace fulcrum::test
