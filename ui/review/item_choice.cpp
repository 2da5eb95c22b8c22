// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/item_choice.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QKeyEvent>
#include <QRadioButton>

#include "ui/reports/rating_words.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int unseen = 1000;  // no scale reaches it
constexpr int points_in_a_row = 11;
constexpr std::size_t anchors_in_a_row = 6;

const FormAnchor* anchor_of(const FormItem& item, int rating) {
    for (const FormAnchor& anchor : item.anchors)
        if (anchor.rating == rating) return &anchor;
    return nullptr;
}

}  // namespace

ItemChoice::ItemChoice(const FormItem& item, bool with_anchors, QWidget* parent)
    : QWidget(parent), item_(item), group_(new QButtonGroup(this)) {
    setObjectName(QStringLiteral("rating_item_") + text(item.id));
    setAccessibleName(form_text(item.title));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 6, 0, 6);
    layout->setSpacing(2);
    QLabel* title = make_label(form_text(item.title));
    QFont strong = title->font();
    strong.setBold(true);
    title->setFont(strong);
    layout->addWidget(title);
    auto* row = new QGridLayout;
    row->setContentsMargins(0, 0, 0, 0);
    for (int rating = item.lowest; rating <= item.highest; ++rating) {
        const FormAnchor* anchor = anchor_of(item, rating);
        add_point(row, rating - item.lowest, rating, QString::number(rating),
                  anchor == nullptr ? QString() : form_text(anchor->text));
    }
    if (item.optional)
        add_point(row, item.highest - item.lowest + 1, unseen, tr("not seen"), tr("this was not seen"));
    layout->addLayout(row);
    if (with_anchors) layout->addWidget(build_anchors());
    connect(group_, QOverload<QAbstractButton*>::of(&QButtonGroup::buttonClicked), this, &ItemChoice::chosen);
    set_answer(std::nullopt, false);
}

void ItemChoice::add_point(QGridLayout* grid, int number, int id, const QString& shown,
                           const QString& meaning) {
    auto* point = new QRadioButton(shown);
    point->setObjectName(id == unseen ? QStringLiteral("rate_%1_unseen").arg(text(item_.id))
                                      : QStringLiteral("rate_%1_%2").arg(text(item_.id)).arg(id));
    QString name = form_text(item_.title) + QStringLiteral(": ") +
                   (id == unseen ? shown : rating_answer_text(item_, id));
    if (!meaning.isEmpty()) name += QStringLiteral(". ") + meaning;
    point->setAccessibleName(name);
    if (!meaning.isEmpty()) point->setToolTip(meaning);
    point->setCursor(Qt::PointingHandCursor);
    group_->addButton(point, id);
    const int column = number % points_in_a_row;
    grid->addWidget(point, number / points_in_a_row, column, Qt::AlignCenter);
    grid->setColumnStretch(column, 1);
}

QWidget* ItemChoice::build_anchors() {
    auto* words = new QWidget;
    const bool rows = item_.anchors.size() > anchors_in_a_row;
    auto* row = new QBoxLayout(rows ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight, words);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(rows ? 0 : 18);
    const std::size_t last = item_.anchors.size() - 1;
    const bool every_point =
        item_.anchors.size() == static_cast<std::size_t>(item_.highest - item_.lowest + 1);
    for (std::size_t i = 0; i <= last; ++i) {
        const FormAnchor& anchor = item_.anchors[i];
        QLabel* label =
            make_label(QStringLiteral("%1 · %2").arg(anchor.rating).arg(form_text(anchor.text)), "muted");
        label->setProperty("rating", anchor.rating);
        label->setCursor(Qt::PointingHandCursor);
        label->installEventFilter(this);
        const Qt::Alignment side = every_point || (i > 0 && i < last) ? Qt::AlignHCenter
                                   : i == 0                           ? Qt::AlignLeft
                                                                      : Qt::AlignRight;
        label->setAlignment((rows ? Qt::AlignLeft : side) | Qt::AlignTop);
        row->addWidget(label, 1);
    }
    return words;
}

void ItemChoice::set_answer(const std::optional<int>& answer, bool answered) {
    if (QAbstractButton* point = answered ? group_->button(answer.value_or(unseen)) : nullptr) {
        point->setChecked(true);
        return;
    }
    // One stop for the tabulator; the arrow keys go along the scale.
    for (QAbstractButton* point : group_->buttons())
        point->setFocusPolicy(group_->id(point) == item_.lowest ? Qt::StrongFocus : Qt::ClickFocus);
}

std::optional<int> ItemChoice::answer() const {
    const int id = group_->checkedId();
    return id < 0 || id == unseen ? std::nullopt : std::optional<int>(id);
}

bool ItemChoice::answered() const {
    return group_->checkedButton() != nullptr;
}

void ItemChoice::focus_scale() {
    QAbstractButton* point = group_->checkedButton();
    if (point == nullptr) point = group_->button(item_.lowest);
    point->setFocus(Qt::TabFocusReason);
}

QWidget* ItemChoice::follow(QWidget* before) {
    for (QAbstractButton* point : group_->buttons()) {
        setTabOrder(before, point);
        before = point;
    }
    return before;
}

void ItemChoice::keyPressEvent(QKeyEvent* event) {
    const int digit = event->key() - Qt::Key_0;
    QAbstractButton* point = digit >= 0 && digit <= 9 ? group_->button(digit) : nullptr;
    if (point == nullptr) {
        QWidget::keyPressEvent(event);
        return;
    }
    point->setFocus(Qt::OtherFocusReason);
    point->click();
}

bool ItemChoice::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonRelease) {
        if (QAbstractButton* point = group_->button(watched->property("rating").toInt())) {
            point->setFocus(Qt::MouseFocusReason);
            point->click();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace fulcrum::ui

#include "moc_item_choice.cpp"
