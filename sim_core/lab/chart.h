// SPDX-License-Identifier: Apache-2.0
// Charts as SVG text: lines and points on linear or logarithmic axes, bars against a budget, maps of
// outcomes. Same data, same bytes. Colours are those of Okabe and Ito, which colour-blind readers can
// distinguish; shapes differ as well, so that greyscale prints stay readable.
#pragma once

#include <string>
#include <vector>

namespace fulcrum::lab {

/// A named series of points. Values that are not finite, or not positive on a logarithmic axis, are skipped.
struct ChartSeries {
    std::string name;
    std::vector<double> x, y;
    bool line = true, markers = true;
    bool dashed = false;
    std::vector<bool> marked;  ///< empty, or one per point: drawn filled and ringed (the Pareto front)
};

struct Chart {
    std::string title, x_label, y_label;
    bool x_logarithmic = false, y_logarithmic = false;
    std::vector<ChartSeries> series;
    std::string note;  ///< a line under the chart; may be empty
};
std::string svg_chart(const Chart& chart);

/// Horizontal bars, one per row, each with a limit (0: none) drawn as a mark; logarithmic.
struct BarRow {
    std::string name;
    double value = 0, limit = 0;
};
struct BarChart {
    std::string title, label;
    std::vector<BarRow> rows;
    std::string limit_name;
};
std::string svg_bars(const BarChart& chart);

/// Cells in classes over two axes. Panels are drawn next to each other and share axes, classes and legend.
struct MapCell {
    double x = 0, y = 0;
    int category = 0;  ///< index into CategoryMap::categories
};
struct MapPanel {
    std::string title;
    std::vector<MapCell> cells;
    std::vector<ChartSeries> curves;
};
struct CategoryMap {
    std::string title, x_label, y_label;
    bool x_logarithmic = true, y_logarithmic = true;
    std::vector<double> x, y;             ///< positions of the cells, ascending
    std::vector<std::string> categories;  ///< from good to bad, at most four
    std::vector<MapPanel> panels;
    std::string note;
};
std::string svg_map(const CategoryMap& map);

/// Number with the given significant digits, the same in every locale; "1.2e-07" outside 1e-3 .. 1e5.
std::string short_number(double value, int digits = 3);

}  // namespace fulcrum::lab
