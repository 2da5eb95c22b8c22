// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/widgets.h"

#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollArea>
#include <QShortcut>
#include <QStyle>
#include <algorithm>
#include <vector>

#include "ui/style/announce.h"
#include "ui/style/palette.h"

namespace fulcrum::ui {

ElidedLabel::ElidedLabel(const QString& shown) : QLabel(shown) {
    setTextFormat(Qt::PlainText);
}

QSize ElidedLabel::minimumSizeHint() const {
    return {fontMetrics().horizontalAdvance(QStringLiteral("MMM…")), QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
    style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), palette(), isEnabled(),
                          shown, foregroundRole());
}

QLabel* make_label(const QString& shown, const char* role) {
    auto* label = new QLabel(shown);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    if (role != nullptr) label->setProperty("role", role);
    return label;
}

QString in_lines(const QString& shown, const QFontMetrics& metrics, int width) {
    QString lines, line;
    const auto fits = [&](const QString& longer) { return metrics.horizontalAdvance(longer) <= width; };
    for (QString word : shown.split(QLatin1Char(' '))) {
        const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
        if (!fits(longer) && !line.isEmpty()) {
            lines += line + QLatin1Char('\n');
            line = word;
        } else {
            line = longer;
        }
        while (line.size() > 1 && !fits(line)) {
            int kept = line.size() - 1;
            while (kept > 1 && !fits(line.left(kept))) --kept;
            lines += line.left(kept) + QLatin1Char('\n');
            line.remove(0, kept);
        }
    }
    return lines + line;
}

namespace {

/// Outside dialogs Qt's buttons answer to Space alone; people at the keyboard press Enter too.
class EnterButton : public QPushButton {
  public:
    using QPushButton::QPushButton;

  protected:
    void keyPressEvent(QKeyEvent* event) override {
        const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
        if (!enter) {
            QPushButton::keyPressEvent(event);
        } else if (!event->isAutoRepeat()) {
            click();  // held, it would press the next button too, to which the first press has led
        }
    }
};

/// Signs at the ends of words, which a screen reader would spell out.
QString without_signs(const QString& shown) {
    static const QString signs = QStringLiteral("▲▼◀▶←→ ");
    int first = 0, last = shown.size();
    while (first < last && signs.contains(shown[first])) ++first;
    while (last > first && signs.contains(shown[last - 1])) --last;
    return shown.mid(first, last - first);
}

}  // namespace

QString button_text(QString shown) {
    return shown.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

QPushButton* make_button(const QString& shown, const char* name, const char* role) {
    auto* button = new EnterButton(button_text(shown));
    button->setObjectName(QString::fromLatin1(name));
    if (const QString spoken = without_signs(shown); spoken != shown) button->setAccessibleName(spoken);
    button->setCursor(Qt::PointingHandCursor);
    button->setAutoDefault(false);
    if (role != nullptr) button->setProperty("role", role);
    return button;
}

void ask_twice(QPushButton* first, QPushButton* sure, std::function<bool()> needed) {
    sure->hide();
    QObject::connect(first, &QPushButton::clicked, sure, [first, sure, needed = std::move(needed)] {
        if (needed && !needed()) return sure->click();
        sure->show();
        announce(first, QCoreApplication::translate("fulcrum::ui::text",
                                                    "Nothing has happened yet. To confirm, choose: %1")
                            .arg(sure->text().replace(QLatin1String("&&"), QLatin1String("&"))));
    });
    for (QPushButton* button : {first, sure}) {
        auto* back = new QShortcut(Qt::Key_Escape, button, nullptr, nullptr, Qt::WidgetShortcut);
        QObject::connect(back, &QShortcut::activated, sure, [first, sure] {
            if (sure->hasFocus()) first->setFocus();
            sure->hide();
        });
    }
}

QComboBox* make_narrow_choice(const char* name, const QString& accessible_name, int characters) {
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(accessible_name);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(characters);
    return box;
}

QFrame* make_card(int spacing) {
    auto* card = new QFrame;
    card->setProperty("role", "card");
    auto* layout = new QVBoxLayout(card);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(spacing);
    return card;
}

namespace {

constexpr int tint_role = Qt::UserRole + 100;

}  // namespace

void set_tint(QWidget* label, Tint tint) {
    const char* const names[] = {"", "good", "bad", "muted"};
    label->setProperty("tint", names[static_cast<int>(tint)]);
    label->style()->unpolish(label);
    label->style()->polish(label);
}

void set_tint(QTableWidgetItem* cell, Tint tint) {
    cell->setData(tint_role, static_cast<int>(tint));
}

void set_tint(QListWidgetItem* line, Tint tint) {
    line->setData(tint_role, static_cast<int>(tint));
}

void TintDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    const Palette& p = colours();
    switch (static_cast<Tint>(index.data(tint_role).toInt())) {
        case Tint::none:
            break;
        case Tint::good:
            option->palette.setColor(QPalette::Text, p.good);
            break;
        case Tint::bad:
            option->palette.setColor(QPalette::Text, p.bad);
            break;
        case Tint::muted:
            option->palette.setColor(QPalette::Text, p.muted);
            break;
    }
}

QTableWidget* make_table(const QStringList& columns, const char* name) {
    auto* table = new QTableWidget(0, columns.size());
    table->setObjectName(QString::fromLatin1(name));
    table->setHorizontalHeaderLabels(columns);
    table->setItemDelegate(new TintDelegate(table));
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(QFontMetrics(QApplication::font()).height() + 16);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setAlternatingRowColors(true);
    table->setShowGrid(false);
    table->setTabKeyNavigation(false);
    table->horizontalHeader()->setStretchLastSection(true);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    return table;
}

namespace {

/// Its tool tip is its description for a screen reader as well.
class DescribedCell : public QTableWidgetItem {
  public:
    using QTableWidgetItem::QTableWidgetItem;
    QVariant data(int role) const override {
        const QVariant own = QTableWidgetItem::data(role);
        if (role != Qt::AccessibleDescriptionRole || own.isValid()) return own;
        const QVariant tip = QTableWidgetItem::data(Qt::ToolTipRole);
        return tip == QTableWidgetItem::data(Qt::DisplayRole) ? QVariant() : tip;
    }
};

}  // namespace

QTableWidgetItem* make_cell(const QString& shown, Qt::Alignment alignment) {
    auto* item = new DescribedCell(shown);
    item->setTextAlignment(alignment);
    return item;
}

void size_columns(QTableWidget* table, int air) {
    QHeaderView* header = table->horizontalHeader();
    header->setStretchLastSection(false);
    table->resizeColumnsToContents();
    const int room = (table->viewport()->width() - header->length()) / std::max(1, table->columnCount());
    air = std::clamp(room, std::min(4, air), air);
    for (int column = 0; column < table->columnCount(); ++column) {
        header->resizeSection(column, header->sectionSize(column) + air);
        if (table->rowCount() > 0 && table->item(0, column) != nullptr) {
            table->horizontalHeaderItem(column)->setTextAlignment(table->item(0, column)->textAlignment());
        }
    }
    header->setStretchLastSection(true);
}

namespace {

/// Pixels of a cell next to its words: the style sheet's padding and Qt's margin, at both sides.
constexpr int beside_words = 18;

int height_of(const QTableWidgetItem* item, int width, const QFont& font) {
    if (item == nullptr) return 0;
    constexpr int above_and_below = 16;
    const QRect room(0, 0, std::max(1, width - beside_words), 10000);
    return QFontMetrics(font).boundingRect(room, Qt::TextWordWrap, item->text()).height() + above_and_below;
}

/// Narrows the columns of its table to the width of the viewport. Child of the table.
class ColumnFitter : public QObject {
  public:
    explicit ColumnFitter(QTableWidget* table) : QObject(table), table_(table) {
        setObjectName(QString::fromLatin1(name));
        table->viewport()->installEventFilter(this);
        connect(table->horizontalHeader(), &QHeaderView::sectionResized, this,
                [this](int column, int before, int now) {
                    const bool hidden_or_shown = before == 0 || now == 0;
                    dragged_ =
                        dragged_ || (!fitting_ && !hidden_or_shown && column + 1 < table_->columnCount());
                });
    }
    static ColumnFitter* of(QTableWidget* table) {
        auto* present = table->findChild<QObject*>(QString::fromLatin1(name), Qt::FindDirectChildrenOnly);
        return present != nullptr ? static_cast<ColumnFitter*>(present) : new ColumnFitter(table);
    }
    /// The contents are new.
    void renew(std::vector<int> whole) {
        whole_ = std::move(whole);
        fitting_ = true;
        size_columns(table_);
        fitting_ = false;
        dragged_ = false;
        wanted_.clear();
        for (int column = 0; column < table_->columnCount(); ++column)
            wanted_.push_back(table_->isColumnHidden(column) ? held_by(column) + 4
                                                             : table_->columnWidth(column));
        // The last one is stretched: what it holds counts.
        if (!wanted_.empty()) {
            int& end = wanted_[static_cast<std::size_t>(last())];
            end = std::min(end, held_by(last()) + 16);
        }
        if (table_->isVisible()) narrow();
    }

  protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Resize || event->type() == QEvent::Show) narrow();
        return false;
    }

  private:
    static constexpr const char* name = "column_fitter";

    /// Pixels that a column needs for its head and all that it holds.
    int held_by(int column) const {
        return std::max(static_cast<QAbstractItemView*>(table_)->sizeHintForColumn(column),
                        table_->horizontalHeader()->sectionSizeHint(column));
    }
    /// Columns may stand in another order than they are numbered.
    int last() const { return table_->horizontalHeader()->logicalIndex(table_->columnCount() - 1); }
    void narrow() {
        if (dragged_ || wanted_.empty()) return;
        // The widest columns share what the others leave: the width w with sum(min(wanted, w)) = room.
        int left = table_->viewport()->width();
        std::vector<int> narrowest_first;
        for (int column = 0; column < table_->columnCount(); ++column) {
            if (table_->isColumnHidden(column)) continue;
            const int wanted = wanted_[static_cast<std::size_t>(column)];
            if (is_whole(column))
                left -= wanted;
            else
                narrowest_first.push_back(wanted);
        }
        if (narrowest_first.empty()) return;
        std::sort(narrowest_first.begin(), narrowest_first.end());
        int columns = static_cast<int>(narrowest_first.size()), share = narrowest_first.back();
        for (const int width : narrowest_first) {
            share = left / columns;
            if (width > share) break;
            left -= width;
            --columns;
            share = narrowest_first.back();
        }
        share = std::max(share, table_->fontMetrics().horizontalAdvance(QLatin1Char('m')) * 7);
        fitting_ = true;
        std::vector<int> narrow;
        for (int column = 0; column < table_->columnCount(); ++column) {
            if (table_->isColumnHidden(column)) continue;
            const int wanted = wanted_[static_cast<std::size_t>(column)];
            const bool fits = is_whole(column) || wanted <= share;
            // The column's own head and its words stay whole.
            const int least = std::max(head_width(column), word_width(column));
            const int narrowed = std::max(share, std::min(wanted, least));
            table_->horizontalHeader()->resizeSection(column, fits ? wanted : narrowed);
            if (!fits) narrow.push_back(column);
        }
        fitting_ = false;
        wrap(narrow);
    }

    /// Rows become as high as the words of these columns need, up to three lines.
    void wrap(const std::vector<int>& columns) {
        const bool wraps = table_->wordWrap();  // without: a line each, whole in its tool tip
        const int usual = table_->verticalHeader()->defaultSectionSize();
        const int most = std::max(usual, 3 * table_->fontMetrics().lineSpacing() + 16);
        for (int row = 0; row < table_->rowCount(); ++row) {
            int height = usual;
            for (const int column : columns) {
                QTableWidgetItem* cell = table_->item(row, column);
                if (cell == nullptr) continue;
                if (cell->toolTip().isEmpty()) cell->setToolTip(cell->text());
                if (wraps)
                    height = std::max(height, height_of(cell, table_->horizontalHeader()->sectionSize(column),
                                                        table_->font()));
            }
            if (!columns.empty() || wrapped_) table_->setRowHeight(row, std::min(height, most));
        }
        wrapped_ = !columns.empty();
    }

    /// The longest word of a column, up to a length that only keys and paths have.
    int word_width(int column) const {
        const int most = table_->fontMetrics().averageCharWidth() * 18;
        int widest = 0;
        for (int row = 0; row < table_->rowCount() && widest < most; ++row) {
            const QTableWidgetItem* cell = table_->item(row, column);
            if (cell == nullptr) continue;
            for (const QString& word : cell->text().split(QLatin1Char(' ')))
                widest = std::max(widest, table_->fontMetrics().horizontalAdvance(word));
        }
        return std::min(widest, most) + beside_words;
    }

    int head_width(int column) const {
        QFont bold = table_->horizontalHeader()->font();
        bold.setWeight(QFont::DemiBold);
        constexpr int beside = 2 * 8 + 2;  // as the style sheet has it
        return QFontMetrics(bold).horizontalAdvance(
                   table_->model()->headerData(column, Qt::Horizontal).toString()) +
               beside;
    }
    bool is_whole(int column) const {
        return std::find(whole_.begin(), whole_.end(), column) != whole_.end();
    }

    QTableWidget* table_;
    std::vector<int> whole_;   ///< columns that are not narrowed
    std::vector<int> wanted_;  ///< px, of each column, for all that it holds
    bool fitting_ = false, dragged_ = false, wrapped_ = false;
};

}  // namespace

void fit_columns(QTableWidget* table, std::vector<int> whole) {
    ColumnFitter::of(table)->renew(std::move(whole));
}

void fit_rows(QTableWidget* table) {
    for (int row = 0; row < table->rowCount(); ++row) {
        int height = table->verticalHeader()->defaultSectionSize();
        for (int column = 0; column < table->columnCount(); ++column)
            height = std::max(height,
                              height_of(table->item(row, column), table->columnWidth(column), table->font()));
        table->setRowHeight(row, height);
    }
}

void fit_height(QTableWidget* table, int most_rows) {
    int height = table->horizontalHeader()->sizeHint().height() + 2 * table->frameWidth();
    for (int row = 0; row < std::min(most_rows, table->rowCount()); ++row) height += table->rowHeight(row);
    table->setFixedHeight(height);
}

void fit_heads(QTableWidget* table) {
    QFont bold = table->font();
    bold.setBold(true);
    int height = 0;
    for (int column = 0; column < table->columnCount(); ++column)
        height = std::max(height,
                          height_of(table->horizontalHeaderItem(column), table->columnWidth(column), bold));
    table->horizontalHeader()->setMinimumHeight(height);
}

void set_role(QWidget* widget, const char* role) {
    widget->setProperty("role", role);
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
}

void clear_layout(QLayout* layout) {
    while (QLayoutItem* item = layout->takeAt(0)) {
        if (QWidget* widget = item->widget()) {
            widget->hide();
            widget->deleteLater();
        } else if (QLayout* inner = item->layout()) {
            clear_layout(inner);
        }
        delete item;
    }
}

QWidget* scrolled(QWidget* body, int width, PagePlace place) {
    body->setMaximumWidth(with_text(width));
    auto* holder = new QWidget;
    holder->setObjectName(QStringLiteral("page_body"));
    auto* row = new QHBoxLayout(holder);
    row->setContentsMargins(18, 22, 18, 22);
    row->addStretch(1);
    if (place == PagePlace::centred) {
        row->addWidget(body, 1000);
    } else {
        auto* column = new QWidget;
        column->setMaximumWidth(with_text(std::max(width, page_width)));
        auto* in_column = new QHBoxLayout(column);
        in_column->setContentsMargins(0, 0, 0, 0);
        in_column->addWidget(body, 1000);
        in_column->addStretch(1);
        row->addWidget(column, 1000);
    }
    row->addStretch(1);
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setWidget(holder);
    area->setFocusPolicy(Qt::NoFocus);
    return area;
}

}  // namespace fulcrum::ui
