// SPDX-License-Identifier: Apache-2.0
#include "tests/support/support.h"

namespace fulcrum::test {

std::string source_path(const std::string& relative) {
    return std::string(FULCRUM_SOURCE_DIR) + "/" + relative;
}

}  // namespace fulcrum::test
