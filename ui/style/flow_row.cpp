// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/flow_row.h"

#include <algorithm>

namespace fulcrum::ui {

FlowRow::FlowRow(QWidget* parent) : QLayout(parent) {
    setContentsMargins(0, 0, 0, 0);
}

FlowRow::~FlowRow() {
    for (const Item& one : items_) delete one.item;
}

void FlowRow::add(QWidget* widget, int stretch, int narrowest) {
    addWidget(widget);
    items_.back().stretch = stretch;
    items_.back().narrowest = narrowest;
}

void FlowRow::addItem(QLayoutItem* item) {
    items_.push_back({item});
}

QLayoutItem* FlowRow::itemAt(int index) const {
    return index >= 0 && index < count() ? items_[static_cast<std::size_t>(index)].item : nullptr;
}

QLayoutItem* FlowRow::takeAt(int index) {
    QLayoutItem* taken = itemAt(index);
    if (taken != nullptr) items_.erase(items_.begin() + index);
    return taken;
}

int FlowRow::least(const Item& one) {
    const int own = one.item->minimumSize().width();
    return one.stretch > 0 ? std::max(one.narrowest, own) : std::max(own, one.item->sizeHint().width());
}

int FlowRow::height_of(const Item& one, int width) {
    return one.item->hasHeightForWidth() ? one.item->heightForWidth(width) : one.item->sizeHint().height();
}

int FlowRow::arrange(const QRect& place, bool move) const {
    const QMargins margins = contentsMargins();
    const QRect room = place.marginsRemoved(margins);
    const int gap = std::max(0, spacing());
    int top = room.top();
    std::vector<const Item*> line;
    int taken = 0, stretches = 0;
    const auto end_line = [&] {
        if (line.empty()) return;
        int left = room.left(), spare = std::max(0, room.width() - taken), shares = stretches, height = 0;
        std::vector<int> widths;
        for (const Item* one : line) {
            int width = std::min(least(*one), room.width());
            if (one->stretch > 0) {
                const int share = spare * one->stretch / shares;
                width += share;
                spare -= share;
                shares -= one->stretch;
            }
            widths.push_back(width);
            height = std::max(height, height_of(*one, width));
        }
        for (std::size_t i = 0; move && i < line.size(); ++i) {
            // Cards and other widgets that stretch are as high as the line; the others are in its middle.
            const int own = line[i]->stretch > 0 ? height : std::min(height, height_of(*line[i], widths[i]));
            line[i]->item->setGeometry(QRect(left, top + (height - own) / 2, widths[i], own));
            left += widths[i] + gap;
        }
        top += height + gap;
        line.clear();
        taken = stretches = 0;
    };
    for (const Item& one : items_) {
        if (one.item->isEmpty()) continue;
        const int width = std::min(least(one), room.width());
        if (!line.empty() && taken + gap + width > room.width()) end_line();
        taken += width + (line.empty() ? 0 : gap);
        stretches += one.stretch;
        line.push_back(&one);
    }
    end_line();
    return std::max(0, top - gap - room.top()) + margins.top() + margins.bottom();
}

int FlowRow::heightForWidth(int width) const {
    return arrange(QRect(0, 0, width, 0), false);
}

QSize FlowRow::sizeHint() const {
    int width = 0, height = 0;
    for (const Item& one : items_) {
        if (one.item->isEmpty()) continue;
        width +=
            (width > 0 ? std::max(0, spacing()) : 0) + std::max(least(one), one.item->sizeHint().width());
        height = std::max(height, one.item->sizeHint().height());
    }
    const QMargins margins = contentsMargins();
    return {width + margins.left() + margins.right(), height + margins.top() + margins.bottom()};
}

QSize FlowRow::minimumSize() const {
    int width = 0, height = 0;
    for (const Item& one : items_) {
        if (one.item->isEmpty()) continue;
        width = std::max(width, std::max(one.item->minimumSize().width(), one.narrowest));
        height = std::max(height, one.item->minimumSize().height());
    }
    const QMargins margins = contentsMargins();
    return {width + margins.left() + margins.right(), height + margins.top() + margins.bottom()};
}

void FlowRow::setGeometry(const QRect& place) {
    QLayout::setGeometry(place);
    arrange(place, true);
}

}  // namespace fulcrum::ui
