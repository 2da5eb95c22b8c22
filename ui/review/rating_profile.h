// SPDX-License-Identifier: GPL-3.0-or-later
// Ratings with one form as a picture: a row for each item, a mark for each rater, joined from item to item.
// Raters differ by shape as well as by colour.
#pragma once

#include <QWidget>
#include <vector>

#include "assessment/forms/observer_form.h"

class QPainter;

namespace fulcrum::ui {

/// The mark of a rater by number: disc, square, diamond, triangle, then the same as outlines.
void paint_rater_mark(QPainter& painter, QPointF centre, double size, int number);

/// The mark alone, next to the rater's name.
class RaterMark : public QWidget {
  public:
    explicit RaterMark(int number, QWidget* parent = nullptr);
    QSize sizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    int number_;
};

struct RatingLine {
    QString rater;
    int mark = 0;
    FormAnswers answers;
};

class RatingProfile : public QWidget {
  public:
    RatingProfile(ObserverForm form, std::vector<RatingLine> lines, QWidget* parent = nullptr);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Where a rating of an item is drawn, in px of this widget, before raters are set apart.
    QPointF place_of(std::size_t item, int rating) const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    double row_height() const;
    double label_width() const;
    double set_apart(std::size_t line) const;
    void paint_scales(QPainter& painter) const;
    void paint_line(QPainter& painter, std::size_t line) const;

    ObserverForm form_;
    std::vector<RatingLine> lines_;
};

}  // namespace fulcrum::ui
