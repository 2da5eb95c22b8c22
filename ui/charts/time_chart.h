// SPDX-License-Identifier: GPL-3.0-or-later
// Quantities over the time of an attempt: any number of series (at most 4,000 points each, whatever the
// length; a line ends where nothing was measured), values that hold for a time, lanes of what was on and off,
// limits, event marks, a cursor. Wheel zooms at the pointer, a drag moves, a click chooses a time, double
// click shows all; keys: arrows move the cursor, Page Up and Page Down go to the mark before and after it, +
// and - zoom, 0 shows all. Where it is wanted, a drag with Shift selects a range.
#pragma once

#include <QChartView>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ui/charts/chart_table.h"
#include "ui/charts/decimation.h"
#include "ui/style/palette.h"

QT_CHARTS_BEGIN_NAMESPACE
class QAreaSeries;
class QLineSeries;
class QValueAxis;
QT_CHARTS_END_NAMESPACE

namespace fulcrum::ui {

/// What somebody has decided about the event of a mark.
enum class MarkReview : std::uint8_t { none, confirmed, struck };

struct ChartMark {
    double time = 0;
    QString text;
    QColor Palette::*colour = &Palette::neutral;  ///< looked up when painted: it follows the theme
    bool severe = false;                          ///< drawn as a filled triangle, others as a small line
    /// Struck: hollow, in the colour of secondary text, with a stroke across; confirmed: with a ring.
    MarkReview review = MarkReview::none;
};

/// Something that was so from one moment to another, s.
struct ChartSpan {
    double from = 0, to = 0;
};
/// With a value, which held as long; between two of them there is none.
struct ChartStep {
    double from = 0, to = 0, value = 0;
};

/// Of a band at a time: its two borders and the line between them.
struct ChartBand {
    double time = 0, low = 0, middle = 0, high = 0;
};

/// s between the ticks of an axis that shows `span` s > 0: 1, 2 or 5 times a power of ten, eight steps or
/// fewer, so that a label is its tick's own time.
double tick_interval(double span);

class TimeChart : public QtCharts::QChartView {
    Q_OBJECT
  public:
    explicit TimeChart(const QString& y_title, QWidget* parent = nullptr);
    /// What the keys do, for the pages and for its tool tip.
    static QString key_words();
    void add_series(const QString& name, QColor Palette::*colour, Qt::PenStyle pen,
                    std::shared_ptr<const MinMaxPyramid> samples);
    void add_limit(const QString& name, double value);
    /// Behind the series; time rises in even steps, and where it makes a longer one the band has a gap. At
    /// most chart_point_limit points.
    void add_band(const QString& name, QColor Palette::*colour, const std::vector<ChartBand>& band);
    /// Values that held for a time; their ends rise. Drawn as bars from 0.
    void set_steps(const QString& name, QColor Palette::*colour, std::vector<ChartStep> steps);
    /// A lane at the top of the plot, one below the other, that is filled where something was on; time rises.
    /// `name`: of its column in the table.
    void add_lane(const QString& name, QColor Palette::*colour, std::vector<ChartSpan> spans);
    const std::vector<ChartMark>& marks() const { return marks_; }
    /// Shades the part of the time axis that is selected; to <= from: nothing is.
    void set_selection(double from, double to);
    /// A drag with Shift selects (range_selected).
    void offer_selection(bool offered) { selects_ = offered; }
    void set_marks(std::vector<ChartMark> marks);
    /// s: all data begins at `from` and is there at least until `to`, whatever the series hold.
    void set_extent(double from, double to) {
        begin_ = from;
        end_ = to;
    }
    void set_cursor(double time);
    double cursor() const { return cursor_; }  ///< s; negative: none
    /// Shows all data, y from 0 (or the lowest value below it) to the highest.
    void show_all();
    void show_range(double from, double to);
    void clear();
    void set_y_title(const QString& title);
    /// Of the values, such as "N"; in the names of columns and at peaks.
    void set_unit(const QString& unit);
    /// Marks the highest sample of each series in view, with its value and unit.
    void show_peaks(bool shown) { peaks_shown_ = shown; }
    /// The highest sample of a series in view; none where it has no sample there or only zeros.
    std::optional<ChartPoint> peak_of(std::size_t series) const;
    /// What is drawn of a series.
    const std::vector<ChartLine>& lines_of(std::size_t series) const { return series_[series].lines; }
    /// Times of the points that are drawn, of a moment in each gap between them, and of the ends of steps and
    /// lanes in view, rising.
    std::vector<double> times_drawn() const;
    /// Of the series, bands, steps and lanes, in the order of the cells of add_values().
    std::vector<ChartColumn> columns() const;
    /// What they are at this time; a lane is 1 or 0.
    void add_values(double time, std::vector<ChartCell>& cells) const;
    /// The names of the series above the plot; the title of the time axis below it.
    void show_names(bool shown);
    void show_time_title(bool shown);
    /// Its title and the times at its ticks.
    void show_time_axis(bool shown);
    /// For charts below each other: the plot begins `left` px from the edge, whatever its labels, and the
    /// name of the values is in its upper corner, so that a low chart has room for both.
    void set_compact(int left);
    /// s, of the time axis.
    double first_shown() const;
    double last_shown() const;

  signals:
    void time_chosen(double time);
    /// The view was zoomed or moved here, by mouse or keys.
    void range_changed(double from, double to);
    /// A range was selected here, from < to.
    void range_selected(double from, double to);
    /// Other points are drawn.
    void points_changed();

  protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void restyle();
    void place_plot();
    struct Series {
        QtCharts::QLineSeries* line = nullptr;  ///< for the legend, without points: Qt Charts joins all
        QColor Palette::*colour = &Palette::neutral;
        Qt::PenStyle pen = Qt::SolidLine;
        std::shared_ptr<const MinMaxPyramid> data;
        std::vector<ChartLine> lines = {};  ///< of the view
    };
    /// A stretch of a band without a gap.
    struct BandPart {
        QtCharts::QAreaSeries* area = nullptr;
        QtCharts::QLineSeries* middle = nullptr;
    };
    struct Band {
        QString name;
        QColor Palette::*colour = &Palette::neutral;
        std::vector<ChartBand> data = {};
        std::vector<BandPart> parts = {};
        double step = 0, highest = 0, last = 0;

        bool joins(const ChartBand& before, const ChartBand& after) const {
            return after.time - before.time <= 1.5 * step;
        }
    };
    BandPart make_part(const Band& band, std::size_t from, std::size_t to);
    struct Lane {
        QString name;
        QColor Palette::*colour = &Palette::neutral;
        std::vector<ChartSpan> spans;
    };
    void draw_series(QPainter& painter, const QRectF& area) const;
    void draw_selection(QPainter& painter, const QRectF& area) const;
    void draw_peaks(QPainter& painter, const QRectF& area) const;
    void describe();
    void draw_steps(QPainter& painter, const QRectF& area) const;
    void draw_lanes(QPainter& painter, const QRectF& area) const;
    void draw_limits(QPainter& painter, const QRectF& area) const;
    void draw_labels(QPainter& painter, const QRectF& area) const;
    void draw_name(QPainter& painter, const QRectF& area) const;
    double lanes_height() const;
    void draw_mark(QPainter& painter, const QRectF& area, const ChartMark& mark) const;
    double y_of(double value) const;
    /// As many as the plot's width can show, never more than chart_point_limit.
    std::size_t points_wanted() const;
    void refresh();
    double time_at(const QPoint& position) const;
    double x_of(double time) const;
    void zoom(double factor, double around);
    void choose_range(double from, double to);
    void choose_all();
    const ChartMark* mark_near(const QPoint& position) const;
    /// By a key: a view that the time is not in follows.
    void choose_time(double time);
    /// False where there is no mark on that side.
    bool go_to_mark(double now, bool ahead);

    QtCharts::QValueAxis *x_axis_, *y_axis_;
    std::vector<Series> series_;
    std::vector<Band> bands_;
    std::vector<ChartMark> marks_;
    std::vector<std::pair<QString, double>> limits_;
    std::vector<ChartStep> steps_;
    QString steps_name_;
    QColor Palette::*steps_colour_ = &Palette::neutral;
    std::vector<Lane> lanes_;
    int compact_left_ = 0;  ///< px; 0: Qt Charts lays the plot out
    double first_ = 0, last_ = 1, cursor_ = -1, begin_ = 0, end_ = 0;
    QPoint pressed_at_;
    double pressed_from_ = 0, pressed_to_ = 1;
    double selected_from_ = 0, selected_to_ = 0;
    bool pressed_ = false, dragged_ = false, selects_ = false, selecting_ = false, peaks_shown_ = false;
    QString unit_;
};

}  // namespace fulcrum::ui
