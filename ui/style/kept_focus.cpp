// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/kept_focus.h"

#include <QApplication>
#include <QScrollArea>
#include <QTimer>
#include <algorithm>

namespace fulcrum::ui {

void bring_into_view(QWidget* widget) {
    QTimer::singleShot(0, widget, [widget] {
        for (QWidget* up = widget->parentWidget(); up != nullptr; up = up->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(up)) area->ensureWidgetVisible(widget);
    });
}

namespace {

/// With all around it: as those are, until they are deleted, that were taken out of a layout. What is new is
/// not shown yet, but was not hidden either.
bool was_hidden(const QWidget* widget) {
    for (const QWidget* up = widget; up != nullptr && !up->isWindow(); up = up->parentWidget())
        if (up->isHidden() && up->testAttribute(Qt::WA_WState_ExplicitShowHide)) return true;
    return false;
}

}  // namespace

KeptFocus::KeptFocus(QWidget* part, QWidget* otherwise) : part_(part), otherwise_(otherwise) {
    const QWidget* const focused = QApplication::focusWidget();
    if (focused == nullptr || !part->isAncestorOf(focused)) return;
    held_ = true;
    name_ = focused->objectName();
    for (const QWidget* one : named()) {
        if (one == focused) return;
        ++number_;
    }
}

KeptFocus::~KeptFocus() {
    if (!held_) return;
    // One that stayed has kept it.
    const QWidget* const focused = QApplication::focusWidget();
    if (focused != nullptr && part_->isAncestorOf(focused) && focused->objectName() == name_) return;
    const QList<QWidget*> present = named();
    QWidget* next = present.isEmpty() ? otherwise_ : present[std::min(number_, present.size() - 1)];
    if (next != nullptr && !was_hidden(next) && next->isEnabled()) next->setFocus();
}

QList<QWidget*> KeptFocus::named() const {
    QList<QWidget*> found;
    if (name_.isEmpty()) return found;
    for (QWidget* one : part_->findChildren<QWidget*>(name_))
        if (!was_hidden(one)) found << one;
    return found;
}

}  // namespace fulcrum::ui
