// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <cstring>

namespace fulcrum::app::test {
int perform_until_killed(const char* store, const char* counters, unsigned long seed);
}

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc == 5 && std::strcmp(argv[1], "--perform-until-killed") == 0)
        return fulcrum::app::test::perform_until_killed(argv[2], argv[3], std::strtoul(argv[4], nullptr, 10));
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
