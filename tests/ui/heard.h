// SPDX-License-Identifier: GPL-3.0-or-later
// What a screen reader gets: the names of controls, and what is announced.
#pragma once

#include <QAccessible>
#include <QStringList>
#include <QWidget>

namespace fulcrum::ui::window_test {

inline QString spoken_name(QWidget* widget) {
    const QAccessibleInterface* const spoken = QAccessible::queryAccessibleInterface(widget);
    return spoken == nullptr ? QString() : spoken->text(QAccessible::Name);
}

/// While it is there: all that is announced, in order.
class Heard {
  public:
    Heard() : before_(QAccessible::installUpdateHandler(note)) {
        QAccessible::setActive(true);  // as a screen reader that runs does
        lines().clear();
    }
    ~Heard() { QAccessible::installUpdateHandler(before_); }
    Heard(const Heard&) = delete;
    Heard& operator=(const Heard&) = delete;
    static QStringList& lines() {
        static QStringList all;
        return all;
    }

  private:
    static void note(QAccessibleEvent* event) {
        if (event->type() != QAccessible::Alert) return;
        const QAccessibleInterface* const said = event->accessibleInterface();
        if (said != nullptr && said->role() == QAccessible::AlertMessage)
            lines() << said->text(QAccessible::Name);
    }
    QAccessible::UpdateHandler before_;
};

}  // namespace fulcrum::ui::window_test
