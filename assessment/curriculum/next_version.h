// SPDX-License-Identifier: Apache-2.0
// A new version of a curriculum with other pass rules: the text of its file.
#pragma once

#include <map>
#include <string>

#include "assessment/curriculum/curriculum.h"

namespace fulcrum {

/// The file of `from` (its text) with the version after the newest installed one and these rules, by task.
/// All else is as it was. Throws InputError for a task that is not in it, and where `from` has no text.
std::string next_version_text(const Curriculum& from, const std::map<std::string, PassRule>& rules);

}  // namespace fulcrum
