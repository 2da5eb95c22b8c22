// SPDX-License-Identifier: GPL-3.0-or-later
// One value that an attempt is held against, as a bar: the part that meets the limit is filled, the experts'
// range is a box, the limit a line, the trainee's own last value a diamond. Shapes differ, so that colour is
// never alone.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>

namespace fulcrum::ui {

struct LimitBarData {
    QString name;  ///< of the metric, with hand and tissue
    QString unit;
    std::optional<double> limit;
    bool higher_is_better = false;
    std::optional<double> experts_low, experts_high;
    std::optional<double> last;  ///< the trainee's own last value
    QString limit_words;         ///< "at most 12.3 s"; or why there is no limit
};

/// The values that a bar spans: 0 and every value given, with some room beyond. low < high always.
struct LimitBarSpan {
    double low = 0, high = 1;
};
LimitBarSpan limit_bar_span(const LimitBarData& data);

class LimitBar : public QWidget {
    Q_OBJECT
  public:
    explicit LimitBar(LimitBarData data, QWidget* parent = nullptr);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    const LimitBarData& data() const { return data_; }
    /// px from the left of this widget; clamped to the bar.
    double x_of(double value) const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QRectF bar() const;
    LimitBarData data_;
};

}  // namespace fulcrum::ui
