// SPDX-License-Identifier: GPL-3.0-or-later
// What a screen reader gets: the names of controls, and what is announced.
#pragma once

#include <QAccessible>
#include <QApplication>
#include <QDynamicPropertyChangeEvent>
#include <QStringList>
#include <QWidget>

#include "ui/style/announce.h"

namespace fulcrum::ui::window_test {

inline QString spoken_name(QWidget* widget) {
    const QAccessibleInterface* const spoken = QAccessible::queryAccessibleInterface(widget);
    return spoken == nullptr ? QString() : spoken->text(QAccessible::Name);
}

/// While it is there: all that is announced, in order. Qt hands accessible events on only while a screen
/// reader runs, so the count that each announcement raises is looked at.
class Heard : public QObject {
  public:
    Heard() {
        lines().clear();
        qApp->installEventFilter(this);
    }
    static QStringList& lines() {
        static QStringList all;
        return all;
    }
    bool eventFilter(QObject* from, QEvent* event) override {
        if (event->type() == QEvent::DynamicPropertyChange &&
            static_cast<QDynamicPropertyChangeEvent*>(event)->propertyName() == announced_property) {
            const QAccessibleInterface* const said = QAccessible::queryAccessibleInterface(from);
            if (said != nullptr && said->role() == QAccessible::AlertMessage)
                lines() << said->text(QAccessible::Name);
        }
        return false;
    }
};

}  // namespace fulcrum::ui::window_test
