// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <cstring>

#include "tests/app/counters.h"
#include "tests/database/station_keys.h"
#include "ui/language/language.h"
#include "ui/style/palette.h"

int main(int argc, char** argv) {
    const fulcrum::database::test::OwnStationKeys keys;
    const auto asked = [&](const char* child, int arguments = 5) {
        return argc == arguments && std::strcmp(argv[1], child) == 0;
    };
    if (asked("--use-window-until-killed")) {
        QApplication application(argc, argv);
        fulcrum::ui::apply_theme(application, fulcrum::ui::Theme::light);
        return fulcrum::app::program_test::use_window_until_killed(argv[2], argv[3],
                                                                   std::strtoul(argv[4], nullptr, 10));
    }
    if (asked("--press-until-killed")) {
        QApplication application(argc, argv);
        fulcrum::ui::apply_theme(application, fulcrum::ui::Theme::light);
        return fulcrum::app::program_test::press_until_killed(argv[2], argv[3],
                                                              std::strtoul(argv[4], nullptr, 10));
    }
    if (asked("--perform-until-killed")) {
        QCoreApplication application(argc, argv);
        return fulcrum::app::program_test::perform_until_killed(argv[2], argv[3],
                                                                std::strtoul(argv[4], nullptr, 10));
    }
    if (asked("--break-limit", 4)) {
        QCoreApplication application(argc, argv);
        return fulcrum::app::program_test::break_limit_until_killed(argv[2], argv[3]);
    }
    if (asked("--reach-moments")) {
        QCoreApplication application(argc, argv);
        return fulcrum::app::program_test::reach_moments_until_killed(argv[2], argv[3],
                                                                      std::strcmp(argv[4], "broken") == 0);
    }
    testing::InitGoogleTest(&argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("fulcrum-test"));
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    fulcrum::ui::apply_theme(application, fulcrum::ui::Theme::light);
    fulcrum::ui::use_language(fulcrum::ui::Language::english);  // with its plurals, as the program does
    return RUN_ALL_TESTS();
}
