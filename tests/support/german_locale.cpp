// SPDX-License-Identifier: Apache-2.0
#include "tests/support/german_locale.h"

#include <clocale>
#include <cstdlib>
#include <filesystem>

namespace fulcrum::test {

GermanLocale::GermanLocale() : before_(std::setlocale(LC_ALL, nullptr)) {
    std::string pattern = (std::filesystem::temp_directory_path() / "german-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) return;
    folder_ = pattern;
    const std::string make =
        "localedef -i de_DE -f UTF-8 '" + folder_ + "/de_DE.UTF-8' >'" + folder_ + "/log' 2>&1";
    if (std::system(make.c_str()) != 0) return;
    setenv("LOCPATH", folder_.c_str(), 1);
    in_force_ = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr && *std::localeconv()->decimal_point == ',';
}

GermanLocale::~GermanLocale() {
    std::setlocale(LC_ALL, before_.c_str());
    unsetenv("LOCPATH");
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
}

}  // namespace fulcrum::test
