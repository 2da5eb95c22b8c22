// SPDX-License-Identifier: GPL-3.0-or-later
// Qt loads its SQLite driver only within an application.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <cstring>

#include "tests/database/processes.h"
#include "tests/database/station_keys.h"

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    const fulcrum::database::test::OwnStationKeys keys;
    if (argc == 5 && std::strcmp(argv[1], "--child") == 0)
        return fulcrum::database::test::run_child(argv[2], argv[3], std::atoi(argv[4]));
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
