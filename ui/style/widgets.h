// SPDX-License-Identifier: GPL-3.0-or-later
// Small helpers that every page is built from: labels by role, cards, buttons with a name that tests and
// assistive technology can find.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace fulcrum::ui {

QLabel* make_label(const QString& shown, const char* role = nullptr);
/// A button whose object name and accessible name are set; role "primary", "link", "card" or null.
QPushButton* make_button(const QString& shown, const char* name, const char* role = nullptr);
/// A rounded frame with a vertical layout (reach it by card->layout()).
QFrame* make_card(int spacing = 8);
inline QVBoxLayout* card_layout(QFrame* card) {
    return static_cast<QVBoxLayout*>(card->layout());
}
/// A table that is read: rows selectable, no editing, no vertical header.
QTableWidget* make_table(const QStringList& columns, const char* name);
QTableWidgetItem* make_cell(const QString& shown, Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter);
/// Columns as wide as what they hold, with at most `air` pixels between them, less where there is no room; a
/// header stands above its figures; the last column takes the rest.
void fit_columns(QTableWidget* table, int air = 16);
/// Rows, or the row of heads, as high as their words need in columns that are narrower. The table's own
/// measure takes no account of what the style leaves free beside the words.
void fit_rows(QTableWidget* table);
void fit_heads(QTableWidget* table);
/// Changes a label's role (and so its look).
void set_role(QWidget* widget, const char* role);
/// Empties a layout and deletes its widgets.
void clear_layout(QLayout* layout);
/// A widget inside a scroll area of its own, as a page body of at most `width` pixels, centred.
QWidget* scrolled(QWidget* body, int width = 1180);

}  // namespace fulcrum::ui
