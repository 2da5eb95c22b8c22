// SPDX-License-Identifier: GPL-3.0-or-later
// A row of widgets that continues on the next line where it has no more room, as words do: with large text,
// or with the longer words of another language.
#pragma once

#include <QLayout>
#include <QWidget>
#include <vector>

namespace fulcrum::ui {

class FlowRow : public QLayout {
  public:
    explicit FlowRow(QWidget* parent = nullptr);
    ~FlowRow() override;
    /// `stretch` > 0: takes its share of what is left of its line, and may be as narrow as `narrowest` pixels
    /// or its own least width before it moves to the next line.
    void add(QWidget* widget, int stretch = 0, int narrowest = 0);

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(items_.size()); }
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSize() const override;
    Qt::Orientations expandingDirections() const override { return Qt::Horizontal; }
    void setGeometry(const QRect& place) override;

  private:
    struct Item {
        QLayoutItem* item;
        int stretch = 0, narrowest = 0;
    };
    static int least(const Item& one);
    static int height_of(const Item& one, int width);
    /// Puts them into the lines of a place this wide, if asked to, and returns the height of all lines.
    int arrange(const QRect& place, bool move) const;
    std::vector<Item> items_;
};

}  // namespace fulcrum::ui
