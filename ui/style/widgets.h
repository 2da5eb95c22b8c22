// SPDX-License-Identifier: GPL-3.0-or-later
// Small helpers that every page is built from: labels by role, cards, buttons with a name that tests and
// assistive technology can find.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QVBoxLayout>
#include <functional>
#include <vector>

class QComboBox;

namespace fulcrum::ui {

QLabel* make_label(const QString& shown, const char* role = nullptr);
/// One line that ends in "…" where there is no room for it, and never makes its window wider.
class ElidedLabel : public QLabel {
  public:
    explicit ElidedLabel(const QString& shown = {});
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

/// Pixels that a line of a choice or check box may be wide in a window of 1280 pixels with the largest text:
/// their text does not wrap by itself.
inline constexpr int widest_line = 800;
/// The text with a line break wherever a line would be wider; a word that is too long is broken as well.
QString in_lines(const QString& shown, const QFontMetrics& metrics, int width);
/// Of text that anybody wrote: '&' is a letter there, and no key of the button.
QString button_text(QString shown);
/// A button with an object name; role "primary", "link", "card" or null. A screen reader reads what it shows,
/// also after a change, without arrows at the ends; an accessible name of its own is only for what is not
/// clear without its surroundings. Enter and Space press it once, however long they are held.
QPushButton* make_button(const QString& shown, const char* name, const char* role = nullptr);
/// For what cannot be undone: `first` shows `sure`, which is hidden until then, and Escape on either of them
/// hides it again. `sure` does not get the focus, so that no key that is pressed once too often is the second
/// press. Where `needed` says no, nothing would be lost: one press does it.
void ask_twice(QPushButton* first, QPushButton* sure, std::function<bool()> needed = {});
/// A choice that is as wide as so many characters at least, whatever its longest line; the rest ends in "…".
QComboBox* make_narrow_choice(const char* name, const QString& accessible_name, int characters);
/// A rounded frame with a vertical layout (reach it by card->layout()).
QFrame* make_card(int spacing = 8);
inline QVBoxLayout* card_layout(QFrame* card) {
    return static_cast<QVBoxLayout*>(card->layout());
}
/// A table that is read: rows selectable, no editing, no vertical header.
QTableWidget* make_table(const QStringList& columns, const char* name);
/// What a word says by its colour. Widgets and cells keep the meaning, not the colour, which is looked up
/// when they are painted: a change of the theme reaches everything that is already on the screen.
enum class Tint { none, good, bad, muted };
void set_tint(QWidget* label, Tint tint);
void set_tint(QTableWidgetItem* cell, Tint tint);
void set_tint(QListWidgetItem* line, Tint tint);
/// Paints cells in their tint. make_table() gives it to its tables; lists take it with setItemDelegate().
class TintDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

QTableWidgetItem* make_cell(const QString& shown, Qt::Alignment alignment = Qt::AlignLeft | Qt::AlignVCenter);
/// Columns as wide as what they hold, with at most `air` pixels between them, less where there is no room; a
/// header is aligned with its values; the last column takes the rest.
void size_columns(QTableWidget* table, int air = 16);
/// size_columns(), and from now on the widest columns are narrowed to the table's width, also when it
/// changes: a text without room continues on the next line, up to three, and is whole in its tool tip.
/// Columns named in `whole` (times, figures) keep their width. A column that a person drags stays as it is.
void fit_columns(QTableWidget* table, std::vector<int> whole = {});
/// Rows, or the row of heads, as high as their words need in columns that are narrower. The table's own
/// measure takes no account of what the style leaves free next to the words.
void fit_rows(QTableWidget* table);
/// The table as high as its heads and rows, of which it shows at most `most_rows` at once.
void fit_height(QTableWidget* table, int most_rows);
void fit_heads(QTableWidget* table);
/// Changes a label's role (and so its look).
void set_role(QWidget* widget, const char* role);
/// Empties a layout and deletes its widgets.
void clear_layout(QLayout* layout);
/// Pixels of a page at the usual text size. Narrower ones begin at the same left edge.
inline constexpr int page_width = 1240;
enum class PagePlace { in_column, centred };
/// A widget inside a scroll area of its own, as a page body of at most `width` pixels at the usual text size.
QWidget* scrolled(QWidget* body, int width = page_width, PagePlace place = PagePlace::in_column);

}  // namespace fulcrum::ui
