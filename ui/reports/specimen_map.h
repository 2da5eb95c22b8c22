// SPDX-License-Identifier: GPL-3.0-or-later
// The map of a dissected specimen: levels (rows, cranial at the top) by sectors (columns, the patient's right
// on the left), coloured by the distance of the cut from the intended plane, defects with their depth,
// undivided ground hatched, the tumour, grade and margins as short labels. Painted by one function, so that
// screen and paper show the same. Colour is never alone: direction has a sign, undivided ground a hatch.
#pragma once

#include <QPainter>
#include <vector>

#include "assessment/pathology/pathology.h"
#include "ui/style/palette.h"

namespace fulcrum::ui {

/// The steps of a sector's colour. The distance is the 95th percentile of the size of the sector's distances;
/// its direction is the side on which more of the cut lies outside the tolerance.
enum class DeviationStep { none, in_plane, near_limit, outside, far_outside };
struct SectorDeviation {
    DeviationStep step = DeviationStep::none;  ///< none: nothing was cut in the sector
    bool deep = false;                         ///< towards the sacrum; else into the mesorectum
};
/// in_plane up to half the tolerance, near_limit up to it, outside up to twice it.
SectorDeviation deviation_of(const SectorFinding& finding, double tolerance);
/// The fill of a sector; `palette` of screen or paper.
QColor deviation_colour(const SectorDeviation& deviation, const Palette& palette);
/// "▼" towards the sacrum, "▲" into the mesorectum, doubled beyond twice the tolerance, else "".
QString deviation_sign(const SectorDeviation& deviation);

/// Where the parts of the map are, in the painter's units, from (0, 0).
struct SpecimenMapLayout {
    QRectF grid;                ///< all levels and sectors
    std::vector<QRectF> cells;  ///< as the report's findings
    QRectF labels;              ///< grade and margins: right of the grid, or below it where it is narrow
    QRectF legend;
    double height = 0;  ///< of the whole
};
/// For a width; `metrics` of the font that is painted with, `unit` units of the painter per screen pixel.
/// `least_grid`: height of grid and heads, in lines of text, where something else is shown in their place.
SpecimenMapLayout specimen_map_layout(const PathologyReport& report, double width,
                                      const QFontMetricsF& metrics, double unit, double least_grid = 0);
/// Paints at `top_left` in the painter's font. A report without findings (a plan without levels) paints its
/// labels only.
void paint_specimen_map(QPainter& painter, const QPointF& top_left, double width,
                        const PathologyReport& report, const Palette& palette, double unit);
/// Labels and legend alone, around something that is shown in place of the grid.
void paint_around_specimen_map(QPainter& painter, double width, const PathologyReport& report,
                               const Palette& palette, double least_grid);

}  // namespace fulcrum::ui
