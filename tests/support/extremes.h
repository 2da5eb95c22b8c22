// SPDX-License-Identifier: Apache-2.0
// Shared by the generated extremes of all rooms: the number of cases, and random numbers over a wide range.
#pragma once

#include <cstdlib>

#include "sim_core/lab/random_values.h"

namespace fulcrum::test {

using lab::between;
using lab::direction;
using lab::inside_unit_box;
using lab::not_a_length;

/// FULCRUM_CASES, or the default of the suite: 2,500 where cases are cheap.
inline int cases_asked(int in_the_suite = 2500) {
    const char* text = std::getenv("FULCRUM_CASES");
    return text != nullptr ? std::atoi(text) : in_the_suite;
}

}  // namespace fulcrum::test
