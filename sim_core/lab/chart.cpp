// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim_core/lab/chart_axis.h"
#include "sim_core/lab/svg.h"

namespace fulcrum::lab {
namespace {

constexpr const char* ink = "#222222";
constexpr const char* faint = "#dddddd";
constexpr const char* fainter = "#f0f0f0";

void draw_axes(Svg& svg, const ChartAxis& x, const ChartAxis& y, double left, double top, double right,
               double bottom, bool grid) {
    for (const ChartAxis::Tick& tick : x.ticks()) {
        const double at = x.at(tick.value);
        if (grid) svg.line(at, top, at, bottom, tick.label.empty() ? fainter : faint);
        svg.line(at, bottom, at, bottom + (tick.label.empty() ? 3 : 5), ink);
        if (!tick.label.empty()) svg.text(at, bottom + 18, tick.label, 11, "middle");
    }
    for (const ChartAxis::Tick& tick : y.ticks()) {
        const double at = y.at(tick.value);
        if (grid) svg.line(left, at, right, at, tick.label.empty() ? fainter : faint);
        svg.line(left - (tick.label.empty() ? 3 : 5), at, left, at, ink);
        if (!tick.label.empty()) svg.text(left - 8, at + 4, tick.label, 11, "end");
    }
}

// The parts of a curve inside the plot; where it leaves the plot it ends at the border.
void draw_curve(Svg& svg, const ChartSeries& series, const ChartAxis& x, const ChartAxis& y,
                const std::string& colour, double width) {
    std::string part;
    const auto finish = [&] {
        if (part.find(' ') != part.rfind(' ')) svg.polyline(part, colour, width, series.dashed);
        part.clear();
    };
    const auto add = [&](double sx, double sy) {
        part += pixel(x.at(x.unscaled(sx))) + "," + pixel(y.at(y.unscaled(sy))) + " ";
    };
    const std::size_t count = std::min(series.x.size(), series.y.size());
    for (std::size_t i = 0; i + 1 < count; ++i) {
        if (!x.takes(series.x[i]) || !y.takes(series.y[i]) || !x.takes(series.x[i + 1]) ||
            !y.takes(series.y[i + 1])) {
            finish();
            continue;
        }
        const double ax = x.scaled(series.x[i]), ay = y.scaled(series.y[i]);
        const double dx = x.scaled(series.x[i + 1]) - ax, dy = y.scaled(series.y[i + 1]) - ay;
        double from = 0, to = 1;
        const auto cut = [&](double start, double change) {
            if (change == 0) {
                if (start < 0 || start > 1) to = -1;
                return;
            }
            const double t0 = -start / change, t1 = (1 - start) / change;
            from = std::max(from, std::min(t0, t1));
            to = std::min(to, std::max(t0, t1));
        };
        cut(ax, dx);
        cut(ay, dy);
        if (from >= to) {
            finish();
            continue;
        }
        if (part.empty() || from > 0) {
            finish();
            add(ax + from * dx, ay + from * dy);
        }
        add(ax + to * dx, ay + to * dy);
        if (to < 1) finish();
    }
    finish();
}

double legend_width(const std::vector<std::string>& names) {
    std::size_t longest = 0;
    for (const std::string& name : names) longest = std::max(longest, name.size());
    return 40 + 6.4 * static_cast<double>(longest);
}

double title_width(const std::string& title, double left) {
    return left + 10 + 9.4 * static_cast<double>(title.size());
}

}  // namespace

std::string svg_chart(const Chart& chart) {
    std::vector<double> xs, ys;
    std::vector<std::string> names;
    for (const ChartSeries& series : chart.series) {
        xs.insert(xs.end(), series.x.begin(), series.x.end());
        ys.insert(ys.end(), series.y.begin(), series.y.end());
        names.push_back(series.name);
    }
    const double left = 86, top = 46, plot_width = 560, plot_height = 380, right = left + plot_width,
                 bottom = top + plot_height;
    const double legend = legend_width(names);
    const double height =
        std::max(bottom + (chart.note.empty() ? 56 : 78), top + 24 + 20 * static_cast<double>(names.size()));
    Svg svg(std::max(right + 16 + legend, title_width(chart.title, left)), height);
    ChartAxis x(xs, chart.x_logarithmic), y(ys, chart.y_logarithmic);
    x.place(left, right);
    y.place(bottom, top);
    svg.text(left, 26, chart.title, 15, "start", 0, ink, true);
    draw_axes(svg, x, y, left, top, right, bottom, true);
    for (std::size_t s = 0; s < chart.series.size(); ++s) {
        const ChartSeries& series = chart.series[s];
        const std::string colour = series_colour(s);
        const int shape = static_cast<int>(s % 6);
        if (series.line) draw_curve(svg, series, x, y, colour, 2);
        for (std::size_t i = 0; series.markers && i < std::min(series.x.size(), series.y.size()); ++i) {
            if (!x.inside(series.x[i]) || !y.inside(series.y[i])) continue;
            const bool marked = i < series.marked.size() && series.marked[i];
            if (marked) svg.marker(x.at(series.x[i]), y.at(series.y[i]), 0, 9, "#000000", false);
            svg.marker(x.at(series.x[i]), y.at(series.y[i]), shape, 4.5, colour,
                       series.marked.empty() || marked);
        }
        const double row = top + 8 + 20 * static_cast<double>(s);
        if (series.line) svg.line(right + 16, row, right + 40, row, colour, 2, series.dashed);
        if (series.markers) svg.marker(right + 28, row, shape, 4.5, colour, true);
        svg.text(right + 46, row + 4, series.name, 11);
    }
    svg.line(left, bottom, right, bottom, ink);
    svg.line(left, top, left, bottom, ink);
    svg.text(0.5 * (left + right), bottom + 40, chart.x_label, 12, "middle");
    svg.text(20, 0.5 * (top + bottom), chart.y_label, 12, "middle", -90);
    if (!chart.note.empty()) svg.text(left, bottom + 64, chart.note, 11, "start", 0, "#555555");
    return svg.finish();
}

std::string svg_bars(const BarChart& chart) {
    std::vector<double> values;
    std::size_t longest = 0;
    for (const BarRow& row : chart.rows) {
        values.push_back(row.value);
        if (row.limit > 0) values.push_back(row.limit);
        longest = std::max(longest, row.name.size());
    }
    const double left = 24 + 7.2 * static_cast<double>(longest), top = 46, row_height = 22,
                 right = left + 560;
    const double bottom = top + row_height * static_cast<double>(chart.rows.size());
    Svg svg(right + 110, bottom + 62);
    ChartAxis x(values, true);
    x.place(left, right);
    svg.text(16, 26, chart.title, 15, "start", 0, ink, true);
    for (const ChartAxis::Tick& tick : x.ticks()) {
        const double at = x.at(tick.value);
        svg.line(at, top, at, bottom, tick.label.empty() ? fainter : faint);
        if (!tick.label.empty()) svg.text(at, bottom + 18, tick.label, 11, "middle");
    }
    for (std::size_t i = 0; i < chart.rows.size(); ++i) {
        const BarRow& row = chart.rows[i];
        const double y = top + row_height * static_cast<double>(i);
        const bool over = row.limit > 0 && row.value > row.limit;
        svg.text(left - 8, y + 15, row.name, 11, "end");
        if (x.takes(row.value))
            svg.rectangle(left, y + 4, std::max(1.0, x.at(row.value) - left), row_height - 8,
                          over ? "#D55E00" : "#0072B2");
        if (row.limit > 0)
            svg.line(x.at(row.limit), y + 1, x.at(row.limit), y + row_height - 1, "#000000", 3);
        svg.text(right + 8, y + 15, short_number(row.value) + (over ? " over" : ""), 11);
    }
    svg.line(left, top, left, bottom, ink);
    svg.text(0.5 * (left + right), bottom + 38, chart.label, 12, "middle");
    svg.line(left, bottom + 44, left, bottom + 58, "#000000", 3);
    svg.text(left + 8, bottom + 56, chart.limit_name, 11);
    return svg.finish();
}

// Fill of each category of a map.
static constexpr std::array<const char*, 4> map_fills = {"#009E73", "#F0E442", "#D55E00", "#000000"};

// Borders of the cells at these values: half-way between neighbours.
static std::vector<double> cell_borders(const std::vector<double>& values, bool logarithmic) {
    std::vector<double> v;
    for (const double value : values) v.push_back(logarithmic ? std::log10(value) : value);
    std::vector<double> edges;
    const std::size_t n = v.size();
    for (std::size_t i = 0; i + 1 < n; ++i) edges.push_back(0.5 * (v[i] + v[i + 1]));
    const double first = n > 1 ? v[0] - 0.5 * (v[1] - v[0]) : v[0] - 0.5,
                 last = n > 1 ? v[n - 1] + 0.5 * (v[n - 1] - v[n - 2]) : v[0] + 0.5;
    edges.insert(edges.begin(), first);
    edges.push_back(last);
    if (logarithmic) {
        for (double& edge : edges) edge = std::pow(10.0, edge);
    }
    return edges;
}

static std::size_t nearest_index(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::min_element(values.begin(), values.end(),
                                                     [value](double a, double b) {
                                                         return std::fabs(a - value) < std::fabs(b - value);
                                                     }) -
                                    values.begin());
}

static void draw_legend(Svg& svg, const CategoryMap& map, double right, double top) {
    double row = top + 8;
    for (std::size_t c = 0; c < map.categories.size(); ++c, row += 20) {
        svg.rectangle(right + 16, row - 8, 16, 16, map_fills[c]);
        if (c == 1) svg.marker(right + 24, row, 5, 4, "#444444", false);
        if (c >= 2) svg.marker(right + 24, row, 4, 4, "#ffffff", true);
        svg.text(right + 40, row + 4, map.categories[c], 11);
    }
    std::vector<std::string> listed;
    for (const MapPanel& panel : map.panels) {
        for (const ChartSeries& curve : panel.curves) {
            if (std::find(listed.begin(), listed.end(), curve.name) != listed.end()) continue;
            svg.line(right + 16, row, right + 34, row, listed.empty() ? "#000000" : "#0072B2", 2.5,
                     curve.dashed);
            svg.text(right + 40, row + 4, curve.name, 11);
            listed.push_back(curve.name);
            row += 20;
        }
    }
}

std::string svg_map(const CategoryMap& map) {
    const double left = 86, top = 66, size = map.panels.size() > 2 ? 250 : 340, gap = 34;
    const auto count = static_cast<double>(std::max<std::size_t>(1, map.panels.size()));
    const double right = left + count * size + (count - 1) * gap, bottom = top + size;
    std::vector<std::string> names = map.categories;
    for (const MapPanel& panel : map.panels) {
        for (const ChartSeries& curve : panel.curves) names.push_back(curve.name);
    }
    Svg svg(std::max(right + 16 + legend_width(names), title_width(map.title, left)),
            bottom + (map.note.empty() ? 56 : 78));
    svg.text(left, 26, map.title, 15, "start", 0, ink, true);
    if (map.x.empty() || map.y.empty()) return svg.finish();
    const std::vector<double> x_edges = cell_borders(map.x, map.x_logarithmic),
                              y_edges = cell_borders(map.y, map.y_logarithmic);
    std::vector<std::string> curves;
    for (std::size_t p = 0; p < map.panels.size(); ++p) {
        const MapPanel& panel = map.panels[p];
        const double from = left + static_cast<double>(p) * (size + gap), to = from + size;
        ChartAxis x(x_edges, map.x_logarithmic), y(y_edges, map.y_logarithmic);
        x.place(from, to);
        y.place(bottom, top);
        svg.text(0.5 * (from + to), top - 10, panel.title, 12, "middle");
        for (const MapCell& cell : panel.cells) {
            const std::size_t i = nearest_index(map.x, cell.x), j = nearest_index(map.y, cell.y);
            const double x0 = x.at(x_edges[i]), x1 = x.at(x_edges[i + 1]), y0 = y.at(y_edges[j + 1]),
                         y1 = y.at(y_edges[j]);
            const auto category = static_cast<std::size_t>(std::clamp(cell.category, 0, 3));
            svg.rectangle(x0, y0, x1 - x0, y1 - y0, map_fills[category], "#ffffff");
            // A mark as well, for greyscale prints.
            const double mark = std::min(4.0, 0.22 * std::min(x1 - x0, y1 - y0));
            if (category == 1) svg.marker(0.5 * (x0 + x1), 0.5 * (y0 + y1), 5, mark, "#444444", false);
            if (category >= 2) svg.marker(0.5 * (x0 + x1), 0.5 * (y0 + y1), 4, mark, "#ffffff", true);
        }
        for (const ChartSeries& curve : panel.curves) {
            std::size_t number = static_cast<std::size_t>(
                std::find(curves.begin(), curves.end(), curve.name) - curves.begin());
            if (number == curves.size()) curves.push_back(curve.name);
            draw_curve(svg, curve, x, y, number == 0 ? "#000000" : "#0072B2", 2.5);
        }
        draw_axes(svg, x, y, from, top, to, bottom, false);
        svg.line(from, bottom, to, bottom, ink);
        svg.line(from, top, from, bottom, ink);
        svg.text(0.5 * (from + to), bottom + 40, map.x_label, 12, "middle");
    }
    svg.text(20, 0.5 * (top + bottom), map.y_label, 12, "middle", -90);
    draw_legend(svg, map, right, top);
    if (!map.note.empty()) svg.text(left, bottom + 64, map.note, 11, "start", 0, "#555555");
    return svg.finish();
}

}  // namespace fulcrum::lab
