// SPDX-License-Identifier: GPL-3.0-or-later
// A figure over the attempts of one task: one line a device class (never pooled), passed, failed and not
// scored distinguished by shape. Painted by one function, so that screen and paper show the same. Arrow keys
// choose an attempt, Enter opens it.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "ui/charts/chart_table.h"
#include "ui/style/palette.h"

class QPainter;

namespace fulcrum::ui {

struct AttemptPoint {
    std::string attempt_id;
    int number = 0;               ///< 1, 2, ...
    std::optional<double> value;  ///< nothing is drawn without one
    std::optional<bool> passed;
    bool counting = false;  ///< practice and the like are drawn smaller
    QString tip;
};
struct AttemptSeries {
    QString name;
    std::vector<AttemptPoint> points;
    std::vector<std::pair<double, double>> curve;     ///< fitted: attempt number, value
    std::optional<double> plateau_low, plateau_high;  ///< interval of where the curve levels off
};
struct AttemptChartData {
    QString y_title;
    QString unit = {};  ///< of the values; the title has it too
    std::vector<AttemptSeries> series;
    std::optional<double> limit;
    QString limit_name;
    std::optional<double> band_low, band_high;  ///< the experts' range, drawn as a band
    QString band_name;
    std::optional<double> y_maximum;  ///< fixed top, for points (100)
};

/// Draws into `area` of any device; `selected` an attempt id or "". `unit` is the size of one screen pixel in
/// the painter's coordinates.
void paint_attempt_chart(QPainter& painter, const QRectF& area, const AttemptChartData& data,
                         const Palette& palette, double unit, const std::string& selected = {});

class AttemptChart : public QWidget, public TabledChart {
    Q_OBJECT
  public:
    explicit AttemptChart(QWidget* parent = nullptr);
    void set_data(AttemptChartData shown);
    const AttemptChartData& shown() const { return data_; }
    /// A row's key: the attempt's id.
    ChartTable table() const override;
    QSize sizeHint() const override { return {640, 300}; }
    QSize minimumSizeHint() const override { return {320, 200}; }

  signals:
    void attempt_chosen(const QString& attempt_id);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    const AttemptPoint* point_near(const QPointF& position) const;
    QPointF place_of(const AttemptPoint& point) const;
    void say(const AttemptPoint& point);
    AttemptChartData data_;
    std::string selected_;
};

}  // namespace fulcrum::ui
