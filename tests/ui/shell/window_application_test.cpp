// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/window_application.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "database/rows/errors.h"

namespace fulcrum::ui::window_test {
namespace {

[[noreturn]] void damaged() {
    throw database::StoreError(database::StoreErrorKind::corrupt, "the store is damaged", "restore a backup");
}

TEST(WindowApplication, StoreErrorInAnEventBecomesAMessageAndTheNextEventIsHandled) {
    auto* application = dynamic_cast<WindowApplication*>(QCoreApplication::instance());
    ASSERT_NE(application, nullptr);
    QStringList shown;
    application->set_trouble([&](const QString& line) { shown << line; });
    QPushButton button;
    int clicks = 0;
    QObject::connect(&button, &QPushButton::clicked, [&] {
        if (++clicks == 1) damaged();
    });
    button.show();
    QTest::mouseClick(&button, Qt::LeftButton);
    QTimer::singleShot(0, [] { damaged(); });
    QTRY_COMPARE_WITH_TIMEOUT(shown.size(), 2, 5000);
    EXPECT_EQ(shown.first(), QStringLiteral("the store is damaged; restore a backup"));
    QTest::mouseClick(&button, Qt::LeftButton);
    EXPECT_EQ(clicks, 2);
    EXPECT_EQ(shown.size(), 2);
    application->set_trouble({});
}

}  // namespace
}  // namespace fulcrum::ui::window_test
