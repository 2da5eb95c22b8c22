// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/database/station_keys.h"
#include "ui/language/language.h"
#include "ui/shell/window_application.h"
#include "ui/style/palette.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    fulcrum::ui::WindowApplication application(argc, argv);
    const fulcrum::database::test::OwnStationKeys keys;
    QCoreApplication::setOrganizationName(QStringLiteral("fulcrum-test"));
    const QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    fulcrum::ui::apply_theme(application, fulcrum::ui::Theme::light);
    fulcrum::ui::use_language(fulcrum::ui::Language::english);  // with its plurals, as the program does
    return RUN_ALL_TESTS();
}
