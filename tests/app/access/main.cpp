// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>

#include "ui/style/palette.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QApplication application(argc, argv);
    fulcrum::ui::apply_theme(application, fulcrum::ui::Theme::light);
    return RUN_ALL_TESTS();
}
