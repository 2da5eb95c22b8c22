// SPDX-License-Identifier: Apache-2.0
// Where tests find the repository's files.
#pragma once

#include <string>

namespace fulcrum::test {

/// Absolute path of a file in the repository.
std::string source_path(const std::string& relative);

}  // namespace fulcrum::test
