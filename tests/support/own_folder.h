// SPDX-License-Identifier: Apache-2.0
// A folder of a test's own: tests run side by side, each as its own process, and none may meet another's
// files.
#pragma once

#include <filesystem>

namespace fulcrum::test {

/// An empty folder that no one else has, removed with all it holds. Errors: std::runtime_error.
class OwnFolder {
  public:
    OwnFolder();
    ~OwnFolder();
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

}  // namespace fulcrum::test
