// SPDX-License-Identifier: Apache-2.0
// Where the programs and libraries are that are built with the tests. They are found from the running test
// program: a path among the options of a compiler keeps ccache from finding what another clone compiled.
#pragma once

#include <string>

namespace fulcrum::test {

/// A program, with its path: "fulcrum".
std::string built_program(const std::string& name);
/// fulcrum-hapticd, with its path.
std::string hapticd_program();
/// A library of tests/fakes, by the name of its file: "libHD.so".
std::string fake_library(const std::string& file);
/// A program of tests/fakes, with its path.
std::string fake_program(const std::string& name);

}  // namespace fulcrum::test
