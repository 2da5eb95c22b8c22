// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/lab/fidelity_page.h"
#include "sim_core/lab/chart.h"
#include "sim_core/lab/svg.h"

namespace fulcrum::app {
namespace {

using lab::short_number;

constexpr double panel_width = 330, panel_height = 330, margin = 24, head = 96, plot_left = 52,
                 shift_top = 44, shift_bottom = 190, cost_top = 226, cost_bottom = 286;
constexpr double smallest = 0.1, largest = 100;  // percent, of the logarithmic axis
constexpr const char* ink = "#222222";
constexpr const char* good = "#009E73";
constexpr const char* bad = "#D55E00";
constexpr const char* performed_colour = "#0072B2";
constexpr const char* replayed_colour = "#E69F00";

/// One task's panel with its top left corner.
struct Panel {
    lab::Svg& svg;
    const TaskAnswer& answer;
    double x, y;

    double column(std::size_t level) const {
        return x + plot_left + (static_cast<double>(level) + 0.5) * column_width();
    }
    double column_width() const {
        return (panel_width - plot_left - margin) / static_cast<double>(answer.levels.size());
    }
    double height_of(double percent) const {
        const double share =
            std::log(std::clamp(percent, smallest, largest) / smallest) / std::log(largest / smallest);
        return y + shift_bottom - share * (shift_bottom - shift_top);
    }
    double right() const { return x + panel_width - margin; }
};

void draw_shift_axis(const Panel& panel) {
    const double left = panel.x + plot_left, right = panel.right();
    panel.svg.rectangle(left, panel.height_of(allowed_percent), right - left,
                        panel.y + shift_bottom - panel.height_of(allowed_percent), "#E3F4EC");
    for (const double percent : {0.1, 1.0, 10.0, 100.0}) {
        const double at = panel.height_of(percent);
        panel.svg.line(left, at, right, at, "#dddddd");
        panel.svg.text(left - 6, at + 4,
                       percent == smallest  ? "0.1 %"
                       : percent == largest ? "100 %"
                                            : short_number(percent) + " %",
                       10, "end");
    }
    const double at = panel.height_of(allowed_percent);
    panel.svg.line(left, at, right, at, good, 2, true);
    panel.svg.text(left - 6, at + 4, "2 %", 11, "end", 0, good, true);
    panel.svg.line(left, panel.y + shift_top, left, panel.y + shift_bottom, ink);
}

void draw_comparison(const Panel& panel, const Comparison& comparison, double at, int shape,
                     const std::string& colour) {
    const MetricShift* worst = comparison.worst();
    if (worst == nullptr) return;
    const double size = std::fabs(worst->percent());
    const double reach = std::max(std::fabs(worst->low()), std::fabs(worst->high()));
    const bool spans = worst->low() <= 0 && worst->high() >= 0;
    const double least = spans ? 0 : std::min(std::fabs(worst->low()), std::fabs(worst->high()));
    panel.svg.line(at, panel.height_of(least), at, panel.height_of(reach), colour, 1.5);
    panel.svg.marker(at, panel.height_of(size), shape, 5, colour, true);
    if (!comparison.flips.empty()) {
        const double top = panel.y + shift_top - 9;
        panel.svg.marker(at - 8, top, 4, 4, bad, true);
        panel.svg.text(at - 1, top + 4, std::to_string(comparison.flips.size()), 11, "start", 0, bad, true);
    }
}

void draw_costs(const Panel& panel) {
    double most = 0;
    for (const LevelAnswer& level : panel.answer.levels) most = std::max(most, level.processor_ms);
    const double bottom = panel.y + cost_bottom;
    for (std::size_t i = 0; i < panel.answer.levels.size(); ++i) {
        const LevelAnswer& level = panel.answer.levels[i];
        const double height = most > 0 ? level.processor_ms / most * (cost_bottom - cost_top) : 0;
        const bool named = level.level == panel.answer.cheapest;
        const double wide = 0.5 * panel.column_width();
        panel.svg.rectangle(panel.column(i) - 0.5 * wide, bottom - height, wide, height,
                            named ? good : "#bbbbbb");
        panel.svg.text(panel.column(i), bottom - height - 4, short_number(level.processor_ms) + " ms", 10,
                       "middle");
        panel.svg.text(panel.column(i), bottom + 17, row_of(fidelity_levels, level.level).name, 12, "middle",
                       0, named ? good : ink, named);
    }
    panel.svg.line(panel.x + plot_left, bottom, panel.right(), bottom, ink);
}

void draw_panel(const Panel& panel) {
    panel.svg.text(
        panel.x + plot_left, panel.y + 14,
        panel.answer.task.id + ": " + row_of(fidelity_levels, panel.answer.cheapest).name + " is enough", 14,
        "start", 0, ink, true);
    draw_shift_axis(panel);
    for (std::size_t i = 0; i < panel.answer.levels.size(); ++i) {
        const LevelAnswer& level = panel.answer.levels[i];
        if (level.level == FidelityLevel::fine) {
            panel.svg.text(panel.column(i), panel.y + shift_bottom - 8, "reference", 10, "middle");
            continue;
        }
        draw_comparison(panel, level.performed, panel.column(i) - 14, 0, performed_colour);
        draw_comparison(panel, level.replayed, panel.column(i) + 14, 1, replayed_colour);
    }
    draw_costs(panel);
}

void draw_legend(lab::Svg& svg) {
    svg.text(margin, 28, "How coarse may the simulation be before the score changes?", 17, "start", 0, ink,
             true);
    svg.marker(margin + 8, 50, 0, 5, performed_colour, true);
    svg.text(margin + 20, 54, "same operators perform the task", 11);
    svg.marker(margin + 250, 50, 1, 5, replayed_colour, true);
    svg.text(margin + 262, 54, "same recorded movements", 11);
    svg.marker(margin + 450, 50, 4, 4, bad, true);
    svg.text(margin + 460, 54, "number of verdicts that change", 11);
    svg.text(
        margin, 74,
        "Marker: largest shift of a gated metric against fine, with its 95 % interval; in the green area "
        "it is allowed. Bars: processor time for one simulated second; green: the answer.",
        11);
}

}  // namespace

std::string fidelity_chart(const std::vector<TaskAnswer>& answers) {
    constexpr std::size_t across = 3;
    const std::size_t rows = (answers.size() + across - 1) / across;
    lab::Svg svg(across * panel_width + 2 * margin, head + static_cast<double>(rows) * panel_height);
    draw_legend(svg);
    for (std::size_t i = 0; i < answers.size(); ++i)
        draw_panel({svg, answers[i], margin + static_cast<double>(i % across) * panel_width,
                    head + static_cast<double>(i / across) * panel_height});
    return svg.finish();
}

}  // namespace fulcrum::app
