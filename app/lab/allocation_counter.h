// SPDX-License-Identifier: GPL-3.0-or-later
// Counts heap allocations for the laboratory (this program replaces operator new).
#pragma once

#include <cstdint>

namespace fulcrum::app {

/// Allocations made so far by the calling thread.
std::uint64_t allocations_of_this_thread();

}  // namespace fulcrum::app
