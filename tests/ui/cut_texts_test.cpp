// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/cut_texts.h"

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QListWidget>
#include <QSpinBox>
#include <QTabBar>
#include <QtTest>

#include "ui/style/widgets.h"

namespace fulcrum::ui::window_test {
namespace {

class CutTexts : public ::testing::Test {
  protected:
    CutTexts() { page.resize(600, 400); }
    std::string found() {
        page.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&page));
        QCoreApplication::processEvents();
        return cut_texts(page).join('\n').toStdString();
    }
    QWidget page;
};

TEST_F(CutTexts, AHeadInAColumnThatIsTooNarrowIsFound) {
    QTableWidget* table = make_table({"Proficient after", "Task"}, "limits");
    table->setParent(&page);
    table->setGeometry(0, 0, 500, 200);
    size_columns(table);
    EXPECT_EQ(found(), "");
    table->horizontalHeader()->resizeSection(0, 40);
    EXPECT_NE(found().find("Proficient after"), std::string::npos);
    table->horizontalHeaderItem(0)->setToolTip("Proficient after");
    EXPECT_EQ(found(), "") << "whole in its tool tip";
}

TEST_F(CutTexts, ANumberAndALineWithoutRoomAreFound) {
    auto* weeks = new QSpinBox(&page);
    weeks->setRange(0, 1000);
    weeks->setValue(999);
    weeks->setSuffix(" weeks after the last practice");
    weeks->setGeometry(0, 0, 500, 40);
    auto* list = new QListWidget(&page);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->addItem("Fulcrum targeting and bowel handling");
    list->setGeometry(0, 100, 500, 100);
    EXPECT_EQ(found(), "");
    weeks->setGeometry(0, 0, 80, 40);
    list->setGeometry(0, 100, 60, 100);
    EXPECT_NE(found().find("999 weeks"), std::string::npos);
    EXPECT_NE(found().find("Fulcrum targeting"), std::string::npos);
    list->setWordWrap(true);
    EXPECT_EQ(found().find("Fulcrum targeting"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
