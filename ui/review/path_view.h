// SPDX-License-Identifier: GPL-3.0-or-later
// The paths of both tips in space, turned with the mouse or the arrow keys, with the penalties where they
// happened. A click on one of them chooses its time.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "ui/review/attempt_model.h"

class QPainter;

namespace fulcrum::ui {

class PathView : public QWidget {
    Q_OBJECT
  public:
    explicit PathView(QWidget* parent = nullptr);
    void set_attempt(const AttemptModel& model);
    void set_cursor(double time);
    QSize sizeHint() const override { return {420, 320}; }

  signals:
    void time_chosen(double time);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    struct Mark {
        double time = 0;
        Vector3 position = Vector3::Zero();
        QString words;
        bool critical = false;
    };
    QPointF project(const Vector3& point, double* depth = nullptr) const;
    Vector3 position_at(std::size_t hand, double time) const;
    const Mark* mark_near(const QPointF& place) const;
    void paint_words(QPainter& painter) const;
    void paint_keyboard(QPainter& painter) const;

    std::array<std::vector<PathPoint>, hand_count> path_;
    std::vector<Mark> marks_;
    Vector3 centre_ = Vector3::Zero();
    double radius_ = 0.1, yaw_ = 0.5, pitch_ = 0.35, zoom_ = 1.0, cursor_ = -1;
    QPoint last_;
    bool dragged_ = false;
};

}  // namespace fulcrum::ui
