// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/reading_order.h"

#include <gtest/gtest.h>

#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QtTest>

namespace fulcrum::ui {
namespace {

/// A list that is filled after all else is there, then a grid whose lower line was made first.
class ReadingOrder : public ::testing::Test {
  protected:
    ReadingOrder() {
        auto* column = new QVBoxLayout(&window);
        auto* list = new QVBoxLayout;
        column->addLayout(list);
        auto* grid = new QGridLayout;
        grid->addWidget(button("below"), 1, 0);
        grid->addWidget(button("right"), 0, 1);
        grid->addWidget(button("left"), 0, 0);
        column->addLayout(grid);
        column->addWidget(button("last"));
        list->addWidget(button("first"));
        list->addWidget(button("second"));
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    static QPushButton* button(const char* name) {
        auto* made = new QPushButton(QString::fromLatin1(name));
        made->setObjectName(QString::fromLatin1(name));
        return made;
    }
    QString focused() const {
        return window.focusWidget() == nullptr ? QString() : window.focusWidget()->objectName();
    }
    QStringList stops(bool next, int count) {
        QStringList names;
        for (int i = 0; i < count; ++i) {
            EXPECT_TRUE(focus_in_reading_order(window, next));
            names << focused();
        }
        return names;
    }
    QWidget window;
};

TEST_F(ReadingOrder, WhatIsFilledInLaterComesWhereItIs) {
    window.findChild<QPushButton*>("first")->setFocus();
    EXPECT_EQ(stops(true, 6).join(' ').toStdString(), "second left right below last first");
    EXPECT_EQ(stops(false, 6).join(' ').toStdString(), "last below right left second first");
}

TEST_F(ReadingOrder, WhatIsHiddenOrDisabledIsLeftOut) {
    window.findChild<QPushButton*>("second")->setEnabled(false);
    window.findChild<QPushButton*>("right")->hide();
    window.findChild<QPushButton*>("below")->setFocusPolicy(Qt::ClickFocus);
    window.findChild<QPushButton*>("first")->setFocus();
    EXPECT_EQ(stops(true, 3).join(' ').toStdString(), "left last first");
    for (const char* name : {"left", "last"}) window.findChild<QPushButton*>(name)->hide();
    EXPECT_FALSE(focus_in_reading_order(window, true)) << "there is no other";
}

/// The window of the program: Qt asks it for the next control, also when the one with the keyboard is hidden.
class AskedByQt : public QWidget {
  protected:
    bool focusNextPrevChild(bool next) override { return focus_in_reading_order(*this, next); }
};

TEST_F(ReadingOrder, WhereTheControlIsHiddenTheOneBehindItGetsTheKeyboard) {
    AskedByQt asked;
    auto* column = new QVBoxLayout(&asked);
    for (const char* name : {"first", "second", "third"}) column->addWidget(button(name));
    asked.show();
    asked.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&asked));
    auto* second = asked.findChild<QPushButton*>("second");
    second->setFocus();
    second->hide();
    ASSERT_NE(asked.focusWidget(), nullptr);
    EXPECT_EQ(asked.focusWidget()->objectName(), "third");
}

TEST_F(ReadingOrder, WhatIsReachedFromOutsideItsAreaIsScrolledIntoView) {
    auto* column = static_cast<QVBoxLayout*>(window.layout());
    auto* body = new QWidget;
    auto* lines = new QVBoxLayout(body);
    for (int i = 0; i < 30; ++i) lines->addWidget(button("line"));
    lines->addWidget(button("lowest"));
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(body);
    area->setFixedHeight(120);
    column->addWidget(area);
    auto* table = new QTableWidget(20, 1);
    for (int row = 0; row < 20; ++row) {
        auto* edit = new QLineEdit;
        edit->setObjectName(QStringLiteral("value_%1").arg(row));
        table->setCellWidget(row, 0, edit);
    }
    table->setFixedHeight(120);
    table->setFocusPolicy(Qt::NoFocus);
    column->addWidget(table);
    QCoreApplication::processEvents();
    auto* top = window.findChild<QPushButton*>("first");
    top->setFocus();
    ASSERT_TRUE(focus_in_reading_order(window, false));
    ASSERT_EQ(focused(), "value_19");
    EXPECT_FALSE(window.focusWidget()->visibleRegion().isEmpty());
    window.findChild<QLineEdit*>("value_0")->setFocus();
    ASSERT_TRUE(focus_in_reading_order(window, false));
    ASSERT_EQ(focused(), "lowest");
    EXPECT_FALSE(window.focusWidget()->visibleRegion().isEmpty());
}

TEST_F(ReadingOrder, FromNowhereItLeadsToTheFirstOrTheLast) {
    if (window.focusWidget() != nullptr) window.focusWidget()->clearFocus();
    ASSERT_TRUE(focus_in_reading_order(window, true));
    EXPECT_EQ(focused(), "first");
    window.focusWidget()->clearFocus();
    ASSERT_TRUE(focus_in_reading_order(window, false));
    EXPECT_EQ(focused(), "last");
}

}  // namespace
}  // namespace fulcrum::ui
