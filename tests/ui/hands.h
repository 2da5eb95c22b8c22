// SPDX-License-Identifier: GPL-3.0-or-later
// A person at the window: finds what is visible by its name, clicks and types with real events, waits for
// conditions.
#pragma once

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QScreen>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QtTest>
#include <functional>

#include "ui/page/background_job.h"

namespace fulcrum::ui::window_test {

/// While it is there the end of the last window does not end the program: later dialogs still have their
/// loop.
struct OutlivesItsWindows {
    OutlivesItsWindows() { QApplication::setQuitOnLastWindowClosed(false); }
    ~OutlivesItsWindows() { QApplication::setQuitOnLastWindowClosed(true); }
};

template <typename T>
T* find(QWidget& window, const char* name) {
    T* found = nullptr;
    const bool seen = QTest::qWaitFor(
        [&] {
            for (T* widget : window.findChildren<T*>(QString::fromLatin1(name))) {
                if (widget->isVisible()) found = widget;
            }
            return found != nullptr;
        },
        5000);
    EXPECT_TRUE(seen) << "nothing visible is called " << name;
    return found;
}

inline bool sees(QWidget& window, const char* name) {
    for (QWidget* widget : window.findChildren<QWidget*>(QString::fromLatin1(name))) {
        if (widget->isVisible()) return true;
    }
    return false;
}

inline bool wait_for(const std::function<bool()>& condition, int milliseconds = 60000) {
    return QTest::qWaitFor(condition, milliseconds);
}

/// Also where a window of another test on the same screen becomes the active one at the same moment.
inline bool become_active(QWidget& window) {
    return wait_for(
        [&] {
            window.activateWindow();
            return QTest::qWaitForWindowActive(&window, 500);
        },
        20000);
}

/// Until the window has shown what its pages read and write in the background.
inline void wait_until_read(QWidget& window) {
    EXPECT_TRUE(wait_for([&] {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        return window.findChildren<BackgroundJob*>().isEmpty();
    }));
    for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();  // the layout of what was shown
}

/// Scrolls the page with the wheel until the widget is visible.
inline void bring(QWidget& widget) {
    for (QWidget* above = widget.parentWidget(); above != nullptr; above = above->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(&widget);
    }
}

inline void click(QWidget& window, const char* name) {
    ASSERT_TRUE(wait_for([&] { return sees(window, name); })) << name;
    auto* button = find<QAbstractButton>(window, name);
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(button->isEnabled()) << name;
    QTest::mouseClick(button, Qt::LeftButton);
}

/// Clicks in the list of pages, which large text in a small window puts behind a menu.
inline void choose_page(QWidget& window, const char* name) {
    if (sees(window, "menu")) click(window, "menu");
    click(window, name);
}

/// Clicks a tab by its title.
inline void choose_tab(QWidget& window, const char* tabs, const QString& title) {
    auto* widget = find<QTabWidget>(window, tabs);
    ASSERT_NE(widget, nullptr);
    for (int i = 0; i < widget->count(); ++i) {
        if (widget->tabText(i) != title) continue;
        QTest::mouseClick(widget->tabBar(), Qt::LeftButton, {}, widget->tabBar()->tabRect(i).center());
        EXPECT_EQ(widget->currentIndex(), i) << title.toStdString();
        return;
    }
    FAIL() << "no tab " << title.toStdString();
}

inline void type(QWidget& window, const char* name, const QString& words) {
    auto* edit = find<QLineEdit>(window, name);
    ASSERT_NE(edit, nullptr);
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, words);
}
/// Fills the form *Create programme*: the department and its administrator, Alma.
inline void type_programme(QWidget& window) {
    type(window, "programme_name", "Department of Surgery");
    type(window, "administrator_name", "Alma Admin");
    type(window, "administrator_login", "alma");
    type(window, "administrator_password", "correct horse");
    type(window, "administrator_password_again", "correct horse");
}

/// Clicks a check box or radio button unless it already has the wanted state.
inline void check(QWidget& window, const char* name, bool on = true) {
    auto* box = find<QAbstractButton>(window, name);
    ASSERT_NE(box, nullptr);
    if (box->isChecked() != on) QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(9, box->height() / 2));
    EXPECT_EQ(box->isChecked(), on) << name;
}

/// Clicks the check mark of a list item.
inline void check_item(QListWidget& list, int row) {
    QListWidgetItem* item = list.item(row);
    list.scrollToItem(item);
    const QRect place = list.visualItemRect(item);
    if (item->checkState() != Qt::Checked)
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, QPoint(place.left() + 11, place.center().y()));
    EXPECT_EQ(item->checkState(), Qt::Checked);
}

/// Selects a row of a table by a click on its first cell that is shown.
inline void choose_row(QTableWidget& table, int row) {
    int column = 0;
    while (table.isColumnHidden(column)) ++column;
    table.scrollToItem(table.item(row, column));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualItemRect(table.item(row, column)).center());
    EXPECT_EQ(table.currentRow(), row);
}

/// Stores a picture in the folder FULCRUM_PICTURES, for inspection.
inline void keep_picture(QWidget& window, const QString& name) {
    const QByteArray folder = qgetenv("FULCRUM_PICTURES");
    if (folder.isEmpty()) return;
    QDir().mkpath(QString::fromLocal8Bit(folder));
    // Grabbed from the screen once it has come to rest: a page that was just opened is laid out in several
    // turns of the event loop. What moves all the time (the theatre) is grabbed after three seconds.
    QPixmap picture;
    QImage before;
    const bool at_rest = QTest::qWaitFor(
        [&] {
            QTest::qWait(150);
            picture = window.screen()->grabWindow(window.winId());
            const QImage now = picture.toImage();
            const bool same = now == before;
            before = now;
            return same;
        },
        3000);
    Q_UNUSED(at_rest);
    if (picture.isNull()) picture = window.grab();
    picture.save(QString::fromLocal8Bit(folder) + QLatin1Char('/') + name + QStringLiteral(".png"));
}

/// Stores a picture of the whole scrolled page.
inline void keep_body(QWidget& window, QWidget& page, const QString& name) {
    const QByteArray folder = qgetenv("FULCRUM_PICTURES");
    if (folder.isEmpty()) return;
    auto* body = page.findChild<QWidget*>(QStringLiteral("page_body"));
    ASSERT_NE(body, nullptr);
    QTest::qWait(100);
    body->grab().save(QString::fromLocal8Bit(folder) + QLatin1Char('/') + name + QStringLiteral(".png"));
    window.raise();
}

}  // namespace fulcrum::ui::window_test
