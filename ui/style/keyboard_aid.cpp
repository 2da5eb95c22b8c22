// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/keyboard_aid.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QFocusEvent>
#include <QLabel>
#include <QTimer>
#include <QToolTip>

namespace fulcrum::ui {
namespace {

/// Of the current cell; nothing where the cell itself says as much.
void show_tip_of_cell(QAbstractItemView& view) {
    const QModelIndex cell = view.currentIndex();
    const QString tip = cell.data(Qt::ToolTipRole).toString(), shown = cell.data().toString();
    const QRect place = view.visualRect(cell);
    const bool fits = view.fontMetrics().horizontalAdvance(shown) < place.width();
    if (tip.isEmpty() || (tip == shown && fits)) return QToolTip::hideText();
    QToolTip::showText(view.viewport()->mapToGlobal(place.bottomLeft()), tip, &view);
}

void show_tip_of(QWidget& widget) {
    if (!widget.hasFocus() || !widget.isVisible()) return;
    QString tip = widget.toolTip();
    if (auto* view = qobject_cast<QAbstractItemView*>(&widget); view != nullptr && tip.isEmpty())
        return show_tip_of_cell(*view);
    if (const auto* box = qobject_cast<QComboBox*>(&widget); box != nullptr && tip.isEmpty())
        tip = box->currentData(Qt::ToolTipRole).toString();
    if (!tip.isEmpty()) QToolTip::showText(widget.mapToGlobal(QPoint(0, widget.height())), tip, &widget);
}

bool has_label(const QComboBox& box) {
    if (box.parentWidget() == nullptr) return false;
    for (const QLabel* label :
         box.parentWidget()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
        if (label->buddy() == &box) return true;
    return false;
}

void describe_choice(QComboBox& box) {
    if (!box.accessibleDescription().isEmpty() || box.accessibleName().isEmpty() || has_label(box)) return;
    box.setAccessibleDescription(box.toolTip().isEmpty()
                                     ? box.accessibleName()
                                     : box.accessibleName() + QStringLiteral(". ") + box.toolTip());
}

class KeyboardAid : public QObject {
  public:
    using QObject::QObject;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::FocusIn && watched->isWidgetType()) {
            if (auto* box = qobject_cast<QComboBox*>(watched)) describe_choice(*box);
            const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
            if (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason)
                show_soon(static_cast<QWidget*>(watched));
        } else if (event->type() == QEvent::KeyRelease) {
            // The press has moved the current cell.
            if (auto* view = qobject_cast<QAbstractItemView*>(watched)) show_soon(view);
        }
        return QObject::eventFilter(watched, event);
    }

  private:
    /// What the focus left hides its tip first.
    static void show_soon(QWidget* widget) {
        QTimer::singleShot(0, widget, [widget] { show_tip_of(*widget); });
    }
};

}  // namespace

void aid_keyboard(QApplication& application) {
    application.installEventFilter(new KeyboardAid(&application));
}

}  // namespace fulcrum::ui
