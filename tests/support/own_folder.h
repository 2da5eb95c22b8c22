// SPDX-License-Identifier: Apache-2.0
// A private folder for a test: tests run in parallel, each as its own process, and must not share files.
#pragma once

#include <filesystem>

namespace fulcrum::test {

/// An empty private folder, removed with its contents at the end. Errors: std::runtime_error.
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
