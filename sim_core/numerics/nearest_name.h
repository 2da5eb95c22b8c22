// SPDX-License-Identifier: Apache-2.0
// The known name that a wrong one was probably meant to be, for hints of errors.
#pragma once

#include <string>
#include <vector>

namespace fulcrum {

/// Of `known` the one that differs from `name` in the fewest letters (added, left out, changed); the first of
/// equals. Empty where none is near: more than a third of the letters differ, but two at least may.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace fulcrum
