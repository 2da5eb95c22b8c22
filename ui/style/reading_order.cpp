// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/reading_order.h"

#include <QAbstractItemView>
#include <QCoreApplication>
#include <QGridLayout>
#include <QPointer>
#include <QScrollArea>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace fulcrum::ui {
namespace {

using Widgets = std::vector<QWidget*>;

struct PlacedItem {
    int row = 0, column = 0;
    QLayoutItem* item = nullptr;
};

/// A grid line by line, other layouts as they were filled.
std::vector<PlacedItem> items_of(QLayout& layout) {
    const auto* grid = qobject_cast<const QGridLayout*>(&layout);
    std::vector<PlacedItem> items;
    for (int i = 0; i < layout.count(); ++i) {
        PlacedItem placed;
        placed.item = layout.itemAt(i);
        int rows = 0, columns = 0;
        if (grid != nullptr) grid->getItemPosition(i, &placed.row, &placed.column, &rows, &columns);
        items.push_back(placed);
    }
    std::stable_sort(items.begin(), items.end(), [](const PlacedItem& a, const PlacedItem& b) {
        return a.row != b.row ? a.row < b.row : a.column < b.column;
    });
    return items;
}

void collect(QWidget* widget, const QWidget* from, Widgets& found);

void collect_items(QLayout& layout, const QWidget* from, Widgets& found) {
    for (const PlacedItem& placed : items_of(layout)) {
        if (QWidget* const widget = placed.item->widget())
            collect(widget, from, found);
        else if (QLayout* const inner = placed.item->layout())
            collect_items(*inner, from, found);
    }
}

/// The widget and all that is visible in it: what its layout holds, then from top to bottom what it places
/// itself (tabs, scroll areas, fields in tables). Of what is hidden only the way to `from`: Qt asks for the
/// next control while it hides the one that has the keyboard.
void collect(QWidget* widget, const QWidget* from, Widgets& found) {
    if (!widget->isVisible() && widget != from && !widget->isAncestorOf(from)) return;
    found.push_back(widget);
    const auto known = static_cast<std::ptrdiff_t>(found.size());
    if (widget->layout() != nullptr) collect_items(*widget->layout(), from, found);
    Widgets others;
    for (QObject* const child : widget->children()) {
        if (!child->isWidgetType()) continue;
        auto* const one = static_cast<QWidget*>(child);
        if (!one->isWindow() && std::find(found.begin() + known, found.end(), one) == found.end())
            others.push_back(one);
    }
    std::stable_sort(others.begin(), others.end(), [](const QWidget* a, const QWidget* b) {
        return a->y() != b->y() ? a->y() < b->y() : a->x() < b->x();
    });
    for (QWidget* const one : others) collect(one, from, found);
}

bool is_stop(const QWidget& widget) {
    return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0 &&
           widget.focusProxy() == nullptr;
}

/// Qt scrolls only the area that the keyboard comes from.
void reveal(QWidget& widget) {
    // What the keyboard left or came to may have changed the page: its places are those of the layout to
    // come.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    for (QWidget* up = widget.parentWidget(); up != nullptr; up = up->parentWidget()) {
        if (auto* const area = qobject_cast<QScrollArea*>(up)) area->ensureWidgetVisible(&widget);
        auto* const table = qobject_cast<QAbstractItemView*>(up);
        if (table != nullptr && table->viewport()->isAncestorOf(&widget))
            table->scrollTo(table->indexAt(widget.mapTo(table->viewport(), QPoint(0, 0))));
    }
}

}  // namespace

bool focus_in_reading_order(QWidget& all, bool next) {
    const QWidget* const from = all.window()->focusWidget();
    Widgets found;
    collect(&all, from, found);
    const auto count = static_cast<std::ptrdiff_t>(found.size());
    std::ptrdiff_t at = std::find(found.begin(), found.end(), from) - found.begin();
    if (at == count && next) at = -1;  // from nowhere: to the first, or to the last
    for (std::ptrdiff_t step = 1; step <= count; ++step) {
        const std::ptrdiff_t place = (at + (next ? step : -step) + 2 * count) % count;
        QWidget* const one = found[static_cast<std::size_t>(place)];
        if (one == from || !is_stop(*one)) continue;
        const QPointer<QWidget> kept(one);  // the field that is left may fill its page again
        one->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
        if (!kept.isNull()) reveal(*one);
        return true;
    }
    return false;
}

}  // namespace fulcrum::ui
