// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a few values each, painted by the same functions on screen and on paper: shares with intervals,
// columns, the steps of a funnel, points against a line, curves in steps. Colour is never alone: shapes,
// dashes and hatching say the same.
#pragma once

#include <QRectF>
#include <QString>
#include <optional>
#include <variant>
#include <vector>

#include "ui/style/palette.h"

class QPainter;

namespace fulcrum::ui {

/// A share from 0 to 1 with its interval.
struct IntervalRow {
    QString key, label, words;
    std::optional<double> value;
    double low = 0, high = 1;
};
struct IntervalFigure {
    std::vector<IntervalRow> rows;
};

enum class ColumnFill { plain, bad, warning, faint };
struct FigureColumn {
    QString key, label;  ///< two lines where it has a line break
    int count = 0;
    ColumnFill fill = ColumnFill::plain;
    QString words;
};
struct ColumnFigure {
    QString y_title;
    std::vector<FigureColumn> columns;
};

struct FunnelStep {
    QString key, label;
    int count = 0;
    bool done = false;  ///< filled; else an outline with a light filling
    QString words;
};
struct FunnelFigure {
    int all = 0;
    std::vector<FunnelStep> steps;
};

struct FigureDot {
    QString key;
    double x = 0, y = 0;
    bool marked = false;  ///< a triangle in place of a disc
    QString words;
};
struct DotFigure {
    QString x_title, y_title;
    double x_high = 1, y_high = 1;
    double line_x = 1, line_y = 1;  ///< from 0, 0 to there, then level
    QString line_name, dot_name, marked_name;
    std::vector<FigureDot> dots;
};

struct CurveStep {
    double x = 0, value = 0, low = 0, high = 1;
};
struct StepCurve {
    QString key, name, words;
    std::vector<CurveStep> steps;  ///< from 0 at 0; x rises
};
struct StepFigure {
    QString x_title;
    double x_high = 1;
    std::vector<StepCurve> curves;  ///< at most three; shares from 0 to 1
};

using Figure = std::variant<IntervalFigure, ColumnFigure, FunnelFigure, DotFigure, StepFigure>;

/// A part of a painted figure that can be chosen, and what it says.
struct FigureSpot {
    QRectF place;
    QString key, words;
};

/// Draws into `area` of any device with the painter's font. `unit`: of one screen pixel in the painter's
/// coordinates. Returns the parts, in the order in which keys step through them.
std::vector<FigureSpot> paint_figure(QPainter& painter, const QRectF& area, const Figure& figure,
                                     const Palette& palette, double unit);

/// Lines of text that the figure needs from top to bottom.
double figure_lines(const Figure& figure);
bool is_empty(const Figure& figure);

}  // namespace fulcrum::ui
