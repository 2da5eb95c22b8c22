// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/main_with_application.h"

int main(int argc, char** argv) {
    return run_tests(argc, argv);
}
