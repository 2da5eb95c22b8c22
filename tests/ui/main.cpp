// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

#include "ui/style/palette.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("fulcrum-test"));
    fulcrum::ui::apply_theme(application, fulcrum::ui::Theme::light);
    return RUN_ALL_TESTS();
}
