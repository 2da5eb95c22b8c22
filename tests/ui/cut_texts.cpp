// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/cut_texts.h"

#include <QAbstractSpinBox>
#include <QFontMetrics>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QTabBar>
#include <algorithm>

namespace fulcrum::ui::window_test {
namespace {

QString cut(const QWidget& widget, const QString& shown, int has, int needs) {
    return QStringLiteral("%1 %2: \"%3\" has %4 of %5 px")
        .arg(QString::fromLatin1(widget.metaObject()->className()), widget.objectName(), shown)
        .arg(has)
        .arg(needs);
}

void look_at_heads(const QHeaderView& heads, QStringList& found) {
    if (heads.orientation() != Qt::Horizontal || heads.model() == nullptr) return;
    // As the style sheet has them.
    constexpr int next_to_words = 2 * 8, above_and_below = 2 * 7;
    QFont bold = heads.font();
    bold.setWeight(QFont::DemiBold);
    const QFontMetrics metrics(bold);
    for (int column = 0; column < heads.count(); ++column) {
        const QString shown = heads.model()->headerData(column, Qt::Horizontal).toString();
        const QString tip = heads.model()->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString();
        if (heads.isSectionHidden(column) || shown.isEmpty() || !tip.isEmpty()) continue;
        const QVariant own = heads.model()->headerData(column, Qt::Horizontal, Qt::TextAlignmentRole);
        const int alignment = own.isValid() ? own.toInt() : static_cast<int>(heads.defaultAlignment());
        const bool wraps = (alignment & Qt::TextWordWrap) != 0;
        const QRegularExpression breaks(wraps ? QStringLiteral("[ \\n]") : QStringLiteral("\\n"));
        int widest = 0;
        for (const QString& line : shown.split(breaks))
            widest = std::max(widest, metrics.horizontalAdvance(line));
        const int room = heads.sectionSize(column) - next_to_words;
        if (room < widest) found << cut(heads, shown, room, widest);
        const int flags = wraps ? static_cast<int>(Qt::TextWordWrap) : 0;
        const int high = metrics.boundingRect(QRect(0, 0, std::max(1, room), 10000), flags, shown).height();
        const int height = heads.height() - above_and_below;
        if (height + 1 < high) found << cut(heads, shown + QStringLiteral(" (height)"), height, high);
    }
}

void look_at_tabs(const QTabBar& tabs, QStringList& found) {
    for (int i = 0; i < tabs.count(); ++i) {
        const int room = tabs.tabRect(i).width();
        const int needs = tabs.fontMetrics().horizontalAdvance(tabs.tabText(i));
        if (room < needs && tabs.tabToolTip(i).isEmpty()) found << cut(tabs, tabs.tabText(i), room, needs);
    }
}

void look_at_field(const QAbstractSpinBox& field, QStringList& found) {
    const auto* const line = field.findChild<QLineEdit*>();
    if (line == nullptr) return;
    const int needs = line->fontMetrics().horizontalAdvance(field.text());
    if (line->width() < needs) found << cut(field, field.text(), line->width(), needs);
}

void look_at_lines(const QListWidget& list, QStringList& found) {
    if (list.wordWrap() || list.horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff) return;
    for (int row = 0; row < list.count(); ++row) {
        const QListWidgetItem& item = *list.item(row);
        const int needs = list.fontMetrics().horizontalAdvance(item.text());
        const int room = list.viewport()->width();
        if (room < needs && item.toolTip().isEmpty()) found << cut(list, item.text(), room, needs);
    }
}

}  // namespace

QStringList cut_texts(const QWidget& all) {
    QStringList found;
    for (const QWidget* widget : all.findChildren<QWidget*>()) {
        if (!widget->isVisible()) continue;
        if (const auto* heads = qobject_cast<const QHeaderView*>(widget)) look_at_heads(*heads, found);
        if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) look_at_tabs(*tabs, found);
        if (const auto* field = qobject_cast<const QAbstractSpinBox*>(widget)) look_at_field(*field, found);
        if (const auto* list = qobject_cast<const QListWidget*>(widget)) look_at_lines(*list, found);
    }
    return found;
}

}  // namespace fulcrum::ui::window_test
