// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program_path.h"

namespace fulcrum::app {

const char* program_path() {
    return FULCRUM_PROGRAM;
}

}  // namespace fulcrum::app
