// SPDX-License-Identifier: Apache-2.0
// de_DE.UTF-8, made in a folder of its own, since a machine need not have it installed: numbers have a
// decimal comma.
#pragma once

#include <string>

namespace fulcrum::test {

/// Makes the locale; in force in this process while the object exists.
class GermanLocale {
  public:
    GermanLocale();
    GermanLocale(const GermanLocale&) = delete;
    GermanLocale& operator=(const GermanLocale&) = delete;
    ~GermanLocale();
    /// False where localedef or its source files are missing.
    bool in_force() const { return in_force_; }
    /// For LOCPATH of a child process.
    const std::string& folder() const { return folder_; }

  private:
    std::string folder_, before_;
    bool in_force_ = false;
};

}  // namespace fulcrum::test
