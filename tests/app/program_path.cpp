// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_path.h"

#include <string>

#include "tests/support/built.h"

namespace fulcrum::app {

const char* program_path() {
    static const std::string path = fulcrum::test::built_program("fulcrum");
    return path.c_str();
}

}  // namespace fulcrum::app
