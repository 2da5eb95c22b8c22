// SPDX-License-Identifier: Apache-2.0
#include "tests/support/built.h"

#include <filesystem>

namespace fulcrum::test {
namespace {

std::filesystem::path tests_folder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

}  // namespace

std::string built_program(const std::string& name) {
    return (tests_folder().parent_path() / "app" / name).string();
}

std::string hapticd_program() {
    return built_program("fulcrum-hapticd");
}

std::string fake_library(const std::string& file) {
    return (tests_folder() / "fakes" / file).string();
}

std::string fake_program(const std::string& name) {
    return fake_library(name);
}

}  // namespace fulcrum::test
