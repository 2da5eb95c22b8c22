// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of tables fit the width that the table has.
#include <gtest/gtest.h>

#include <QHeaderView>
#include <QTest>
#include <memory>

#include "ui/style/widgets.h"

namespace fulcrum::ui::window_test {
namespace {

class TableColumns : public ::testing::Test {
  protected:
    TableColumns() : table(make_table({"No.", "Person", "Operation", "Details"}, "table")) {
        table->setRowCount(2);
        for (int row = 0; row < 2; ++row) {
            table->setItem(row, 0, make_cell("1"));
            table->setItem(row, 1, make_cell(long_name));
            table->setItem(row, 2, make_cell("Signed in"));
            table->setItem(row, 3, make_cell(long_name));
        }
    }
    void show(int width) {
        table->resize(width, 300);
        table->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(table.get()));
        QCoreApplication::processEvents();
    }
    int width_of_columns() const { return table->horizontalHeader()->length(); }

    const QString long_name =
        "Wilhelmina Alexandra of the Department of Colorectal Surgery at the University";
    std::unique_ptr<QTableWidget> table;
};

TEST_F(TableColumns, AreNarrowedToTheTableAndKeepTheShortOnesWhole) {
    fit_columns(table.get());
    const int number = table->columnWidth(0), operation = table->columnWidth(2);
    show(520);
    EXPECT_LE(width_of_columns(), table->viewport()->width());
    EXPECT_EQ(table->columnWidth(0), number);
    EXPECT_EQ(table->columnWidth(2), operation);
    EXPECT_NEAR(table->columnWidth(1), table->columnWidth(3), 2);
    EXPECT_EQ(table->item(0, 1)->toolTip(), long_name);
    EXPECT_TRUE(table->item(0, 0)->toolTip().isEmpty());
}

TEST_F(TableColumns, ThatMustBeReadKeepTheirWidth) {
    fit_columns(table.get(), {1});
    const int name = table->columnWidth(1);
    show(name + 360);
    EXPECT_EQ(table->columnWidth(1), name);
    EXPECT_LT(table->columnWidth(3), name);
    EXPECT_LE(width_of_columns(), table->viewport()->width());
}

TEST_F(TableColumns, ThatAreNarrowedWrapTheirTextAndKeepEveryWordWhole) {
    table->item(1, 1)->setText("administrator of Heidelberg");
    fit_columns(table.get());
    const int line = table->fontMetrics().lineSpacing(),
              usual = table->verticalHeader()->defaultSectionSize();
    show(520);
    EXPECT_GE(table->rowHeight(0), 2 * line + 16) << "more than a line, so that the row is higher";
    EXPECT_LE(table->rowHeight(0), std::max(usual, 3 * line + 16)) << "and not without end";
    EXPECT_GE(table->columnWidth(1), table->fontMetrics().horizontalAdvance("administrator"));
    table->resize(2400, 300);
    QCoreApplication::processEvents();
    EXPECT_EQ(table->rowHeight(0), usual) << "one line again where there is room";
}

TEST_F(TableColumns, ThatAreHiddenTakeNoRoomAndHaveTheirWidthWhenShown) {
    table->setColumnHidden(1, true);
    fit_columns(table.get());
    show(1000);
    EXPECT_EQ(table->rowHeight(0), table->verticalHeader()->defaultSectionSize()) << "one line is enough";
    table->setColumnHidden(1, false);
    table->resize(1020, 300);
    QCoreApplication::processEvents();
    EXPECT_GT(table->columnWidth(1), 100);
}

TEST_F(TableColumns, GetTheirWidthBackWhenTheTableGrows) {
    fit_columns(table.get());
    const int wanted = table->columnWidth(1);
    show(520);
    ASSERT_LT(table->columnWidth(1), wanted);
    table->resize(1900, 300);
    QCoreApplication::processEvents();
    EXPECT_EQ(table->columnWidth(1), wanted);
    EXPECT_EQ(width_of_columns(), table->viewport()->width());
}

TEST_F(TableColumns, StayAsAPersonDragsThemUntilTheContentsAreNew) {
    fit_columns(table.get());
    show(520);
    table->horizontalHeader()->resizeSection(1, 400);
    table->resize(560, 300);
    QCoreApplication::processEvents();
    EXPECT_EQ(table->columnWidth(1), 400);
    fit_columns(table.get());
    EXPECT_LE(width_of_columns(), table->viewport()->width());
}

TEST_F(TableColumns, InAnotherOrderAreFittedToo) {
    table->horizontalHeader()->moveSection(1, 3);
    fit_columns(table.get());
    show(520);
    EXPECT_LE(width_of_columns(), table->viewport()->width());
    EXPECT_GE(table->columnWidth(0), table->horizontalHeader()->sectionSizeHint(0));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
