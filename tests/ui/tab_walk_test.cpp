// SPDX-License-Identifier: GPL-3.0-or-later
// Tab goes through every screen of every role as it is read, Shift+Tab goes the same way back, all that can
// be used is reached, and what has the keyboard is seen and shows it.
#include <gtest/gtest.h>

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QButtonGroup>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QHeaderView>
#include <QImage>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tests/ui/screens.h"

namespace fulcrum::ui::window_test {
namespace {

/// Within its group the arrow keys lead to it.
bool is_reached_by_arrows(const QWidget& widget) {
    const auto* const button = qobject_cast<const QAbstractButton*>(&widget);
    if (button == nullptr) return false;
    if (button->group() != nullptr && button->group()->exclusive()) return true;
    return button->autoExclusive();
}

/// A widget as it was when the keyboard came to it; it may be gone later.
struct Stop {
    const QWidget* widget = nullptr;
    const QWidget* area = nullptr;  ///< what scrolls it; null: nothing
    QRect place;                    ///< in the area's whole content
    std::string name;
    bool by_arrows = false;
};

std::string name_of(const QWidget& widget) {
    return widget.metaObject()->className() + (' ' + widget.objectName().toStdString());
}

Stop stop_at(const QWidget& widget) {
    Stop stop{&widget, nullptr, widget.rect(), name_of(widget), is_reached_by_arrows(widget)};
    for (QWidget* up = widget.parentWidget(); up != nullptr; up = up->parentWidget()) {
        const auto* const area = qobject_cast<const QScrollArea*>(up);
        if (area == nullptr) continue;
        stop.area = area;
        stop.place.moveTopLeft(widget.mapTo(area->widget(), QPoint(0, 0)));
        break;
    }
    return stop;
}

bool is_seen(const QWidget& widget) {
    constexpr int enough = 20;  // px: a line of words
    // What fills a view is not its own region.
    const auto* const view = qobject_cast<const QAbstractScrollArea*>(&widget);
    const QRegion own = widget.visibleRegion();
    const QSize seen =
        (view == nullptr ? own : own + view->viewport()->visibleRegion()).boundingRect().size();
    return seen.width() >= std::min(enough, widget.width()) &&
           seen.height() >= std::min(enough, widget.height());
}

/// What a person uses, apart from the parts that Qt makes its widgets from.
bool is_control(const QWidget& widget) {
    if (qobject_cast<const QHeaderView*>(&widget) != nullptr || widget.objectName().startsWith("qt_") ||
        qobject_cast<const QScrollBar*>(&widget) != nullptr || widget.focusProxy() != nullptr)
        return false;
    const QWidget* const above = widget.parentWidget();
    if (qobject_cast<const QTabBar*>(above) != nullptr || qobject_cast<const QLineEdit*>(above) != nullptr ||
        qobject_cast<const QTableView*>(above) != nullptr)
        return false;
    return qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(&widget) != nullptr ||
           qobject_cast<const QPlainTextEdit*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSlider*>(&widget) != nullptr;
}

class TabWalk : public Screens {
  protected:
    void walk(const QString& screen) {
        screen_ = screen.toStdString();
        std::vector<Stop> expected;
        for (const QWidget* one : window->findChildren<QWidget*>()) {
            if (one->isWindow() || !one->isVisible() || !one->isEnabled()) continue;
            const bool stops = (one->focusPolicy() & Qt::TabFocus) != 0 && one->focusProxy() == nullptr;
            if (stops) expected.push_back(stop_at(*one));
            if (!stops && is_control(*one)) {
                EXPECT_TRUE(is_reached_by_arrows(*one)) << screen_ << ": no key leads to " << name_of(*one);
            }
        }
        const auto first = std::find_if(expected.begin(), expected.end(), [](const Stop& one) {
            return qobject_cast<const QDateTimeEdit*>(one.widget) == nullptr;
        });
        ASSERT_NE(first, expected.end()) << screen_;
        for (QWidget* one : window->findChildren<QWidget*>())
            if (one == first->widget) one->setFocus(Qt::TabFocusReason);
        const std::size_t most = 2 * expected.size() + 20;
        const std::vector<Stop> forth = press_until_back(Qt::Key_Tab, most, true);
        const std::vector<Stop> back = press_until_back(Qt::Key_Backtab, most, false);
        expect_reached(expected, forth);
        expect_in_order(forth);
        expect_same_way(forth, back);
        stops_ += forth.size();
    }

    std::vector<Stop> press_until_back(Qt::Key key, std::size_t most, bool look) {
        const QWidget* const first = window->focusWidget();
        std::vector<Stop> stops{stop_at(*first)};
        for (std::size_t i = 0; i < most; ++i) {
            QWidget* const before = window->focusWidget();
            QTest::keyClick(before, key, key == Qt::Key_Backtab ? Qt::ShiftModifier : Qt::NoModifier);
            QCoreApplication::processEvents();  // as between two keys of a person
            QWidget* const now = window->focusWidget();
            if (now == nullptr) {
                ADD_FAILURE() << screen_ << ": the keyboard is lost after " << stops.back().name;
                return stops;
            }
            if (now == first) return stops;
            if (now == before) {
                if (qobject_cast<QDateTimeEdit*>(now) != nullptr) continue;  // day, month and year in turn
                ADD_FAILURE() << screen_ << ": " << name_of(*now) << " keeps the keyboard";
                return stops;
            }
            stops.push_back(stop_at(*now));
            EXPECT_TRUE(is_seen(*now)) << screen_ << ": out of sight: " << name_of(*now);
            if (look) expect_shown(*now);
        }
        ADD_FAILURE() << screen_ << ": does not come back to " << stops.front().name;
        return stops;
    }

    /// Once for each kind of widget: it is painted otherwise with the keyboard than without.
    void expect_shown(QWidget& widget) {
        const std::string kind =
            widget.metaObject()->className() + (' ' + widget.property("role").toString().toStdString());
        if (!kinds_.insert(kind).second) return;
        // A window of another test on the same screen may become the active one in the middle.
        QImage with, without;
        const bool looked = wait_for([&] {
            if (!become_active(*window)) return false;
            widget.setFocus(Qt::TabFocusReason);
            with = widget.grab().toImage();
            widget.clearFocus();
            without = widget.grab().toImage();
            widget.setFocus(Qt::TabFocusReason);
            return window->isActiveWindow();
        });
        EXPECT_TRUE(looked) << screen_ << ": the window does not become active";
        EXPECT_TRUE(with != without) << screen_ << ": does not show the keyboard: " << name_of(widget);
    }

    void expect_reached(const std::vector<Stop>& expected, const std::vector<Stop>& stops) {
        for (const Stop& one : expected) {
            const bool reached = std::any_of(stops.begin(), stops.end(),
                                             [&](const Stop& stop) { return stop.widget == one.widget; });
            // Of a group that excludes each other Tab goes to the chosen one only, as Qt decides when it is
            // shown.
            EXPECT_TRUE(reached || one.by_arrows) << screen_ << ": not reached: " << one.name;
        }
    }

    /// Within what scrolls as one, never up to what is above the last stop.
    void expect_in_order(const std::vector<Stop>& stops) {
        for (std::size_t i = 1; i < stops.size(); ++i) {
            const Stop &last = stops[i - 1], &now = stops[i];
            if (last.area == nullptr || last.area != now.area) continue;
            const bool above = now.place.bottom() < last.place.top();
            const bool in_column =
                now.place.left() <= last.place.right() && last.place.left() <= now.place.right();
            EXPECT_FALSE(above && in_column) << screen_ << ": from " << last.name << " up to " << now.name;
        }
    }

    void expect_same_way(const std::vector<Stop>& forth, const std::vector<Stop>& back) {
        ASSERT_EQ(forth.size(), back.size()) << screen_;
        for (std::size_t i = 1; i < forth.size(); ++i)
            EXPECT_EQ(forth[i].widget, back[back.size() - i].widget)
                << screen_ << ": " << forth[i].name << " and back " << back[back.size() - i].name;
    }

    std::string screen_;
    std::set<std::string> kinds_;
    std::size_t stops_ = 0;
};

TEST_F(TabWalk, GoesThroughEveryScreenAndBack) {
    open({1280, 800});
    ASSERT_TRUE(become_active(*window));
    const std::string attempt = perform();
    visit(attempt, [&](const QString& screen) {
        // There Tab belongs to the instruments.
        if (screen.endsWith("-theatre") || screen.endsWith("-realignment")) return;
        walk(screen);
        each_tab(screen, [&](const QString& tab) { walk(tab); });
    });
    EXPECT_GT(stops_, 300U);
}

/// What a page fills in again is made last.
TEST_F(TabWalk, LeadsFromACommentToTheFieldBelowIt) {
    open({1280, 800});
    ASSERT_TRUE(become_active(*window));
    const std::string attempt = perform();
    sign_in(Role::educator);
    emit window->context().debrief_wanted(text(attempt), -1);
    wait_for_debrief();
    auto* words = find<QPlainTextEdit>(*window, "comment_text");
    ASSERT_NE(words, nullptr);
    bring(*words);
    QTest::keyClicks(words, "Less force here.");
    click(*window, "comment_send");
    settle();
    auto* moment = find<QAbstractButton>(*window, "comment_moment");
    ASSERT_NE(moment, nullptr);
    moment->setFocus();
    QTest::keyClick(moment, Qt::Key_Tab);
    EXPECT_EQ(window->focusWidget(), words);
    QTest::keyClick(words, Qt::Key_Backtab, Qt::ShiftModifier);
    EXPECT_EQ(window->focusWidget(), moment);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
