// SPDX-License-Identifier: Apache-2.0
#include "tests/support/own_folder.h"

#include <cstdlib>
#include <stdexcept>

namespace fulcrum::test {

OwnFolder::OwnFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "fulcrum_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make the folder " + name);
    path_ = name;
}

OwnFolder::~OwnFolder() {
    std::error_code failed;
    std::filesystem::remove_all(path_, failed);
}

}  // namespace fulcrum::test
