// SPDX-License-Identifier: GPL-3.0-or-later
// A figure as a widget: parts are chosen by a click, or by the arrow keys and Enter, and say what they are in
// tool tips and to assistive technology. UI thread.
#pragma once

#include <QWidget>

#include "ui/charts/chart_table.h"
#include "ui/charts/figure.h"

namespace fulcrum::ui {

class FigureChart : public QWidget, public TabledChart {
    Q_OBJECT
  public:
    explicit FigureChart(const char* name, QWidget* parent = nullptr);
    /// `words`: all of it in a sentence or two. `nothing`: what is said in place of an empty figure.
    void show_figure(Figure figure, ChartTable table, const QString& words, const QString& nothing);
    const Figure& figure() const { return figure_; }
    ChartTable table() const override { return table_; }
    /// Of the part with this key, in px of this widget; empty where there is none.
    QRectF place_of(const QString& key) const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    void part_chosen(const QString& key);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    QRectF room() const;
    int spot_at(const QPointF& position) const;
    void select(int spot);
    /// Says what it is, as the tool tip under the mouse does.
    void select_by_key(int spot);

    Figure figure_;
    ChartTable table_;
    QString words_, nothing_;
    std::vector<FigureSpot> spots_;  ///< as they were painted last
    int selected_ = -1;
};

}  // namespace fulcrum::ui
