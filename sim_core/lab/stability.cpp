// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/stability.h"

#include <algorithm>
#include <iterator>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/membrane_tradeoff.h"
#include "sim_core/lab/stability_map.h"
#include "sim_core/lab/stability_rooms.h"

namespace fulcrum::lab {

const char* name_of(StabilityOutcome outcome) {
    switch (outcome) {
        case StabilityOutcome::stable:
            return "stable";
        case StabilityOutcome::degraded:
            return "degraded";
        case StabilityOutcome::fault:
            return "fault";
    }
    return "fault";
}

std::vector<StabilityMap> stability_maps() {
    std::vector<StabilityMap> maps;
    for (const auto room :
         {rod_stability, skin_stability, membrane_stability, haptic_stability_maps, lever_stability}) {
        std::vector<StabilityMap> more = room();
        maps.insert(maps.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    }
    return maps;
}

nlohmann::json to_json(const std::vector<StabilityMap>& maps) {
    nlohmann::json list = nlohmann::json::array();
    int non_finite = 0;
    for (const StabilityMap& map : maps) {
        nlohmann::json axes = nlohmann::json::array(), cells = nlohmann::json::array(),
                       theory = nlohmann::json::array();
        for (const StabilityAxis& axis : map.axes)
            axes.push_back({{"name", axis.name}, {"unit", axis.unit}, {"values", axis.values}});
        for (const StabilityCell& cell : map.cells) {
            nlohmann::json row;
            for (std::size_t a = 0; a < map.axes.size() && a < cell.at.size(); ++a)
                row[map.axes[a].name] = cell.at[a];
            row["outcome"] = name_of(cell.outcome);
            row["finite"] = cell.finite;
            if (!map.measure.empty()) row["measure"] = cell.measure;
            non_finite += cell.finite ? 0 : 1;
            cells.push_back(row);
        }
        for (const StabilityCurve& curve : map.theory) {
            theory.push_back(
                {{"name", curve.name}, {"formula", curve.formula}, {"x", curve.x}, {"y", curve.y}});
        }
        nlohmann::json entry = {
            {"model", map.model}, {"title", map.title}, {"axes", axes}, {"cells", cells}, {"theory", theory}};
        if (!map.theory_note.empty()) entry["theory_note"] = map.theory_note;
        if (!map.measure.empty()) entry["measure"] = map.measure;
        list.push_back(entry);
    }
    return {{"maps", list}, {"non_finite", non_finite}};
}

namespace {

std::string label_of(const StabilityAxis& axis) {
    return axis.unit.empty() ? axis.name : axis.name + ", " + axis.unit;
}

std::string drawing(const StabilityMap& map) {
    CategoryMap drawn;
    drawn.title = map.title;
    drawn.x_label = label_of(map.axes[0]);
    drawn.y_label = label_of(map.axes[1]);
    drawn.x = map.axes[0].values;
    drawn.y = map.axes[1].values;
    drawn.x_logarithmic = map.axes[0].logarithmic;
    drawn.y_logarithmic = map.axes[1].logarithmic;
    drawn.categories = {"stable", "degraded", "fault"};
    if (map.theory_note.size() < 90) drawn.note = map.theory_note;  // a longer one is on the page only
    std::vector<double> panels = {0};
    if (map.axes.size() > 2) panels = map.axes[2].values;
    for (const double value : panels) {
        MapPanel panel;
        if (map.axes.size() > 2)
            panel.title = map.axes[2].name + " " + short_number(value) + " " + map.axes[2].unit;
        for (const StabilityCell& cell : map.cells) {
            if (map.axes.size() > 2 && cell.at[2] != value) continue;
            panel.cells.push_back({cell.at[0], cell.at[1], static_cast<int>(cell.outcome)});
        }
        for (const StabilityCurve& curve : map.theory) {
            ChartSeries series;
            series.name = curve.name;
            series.x = curve.x;
            series.y = curve.y;
            panel.curves.push_back(series);
        }
        drawn.panels.push_back(panel);
    }
    return svg_map(drawn);
}

}  // namespace

ResultPage stability_page(const std::vector<StabilityMap>& maps) {
    ResultPage page("lab_stability", "Where the models stay bounded",
                    "fulcrum lab stability --output docs/results");
    page.paragraph(
        "Green: bounded, and within the stated accuracy. Yellow with +: finite and bounded, but the step "
        "needed substeps, did not converge or is outside the stated accuracy; the model reports this. Red "
        "with x: the model gave up and reported a fault, or left its bounds. Curves: the theoretical "
        "boundary (docs/THEORY.md).");
    std::size_t cells = 0, broken = 0;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const StabilityMap& map = maps[i];
        page.heading(map.title);
        std::size_t counts[3] = {0, 0, 0};
        ResultTable table;
        table.name = "stability_" + std::to_string(i + 1) + "_" + map.model;
        for (const StabilityAxis& axis : map.axes) table.columns.push_back(label_of(axis));
        table.columns.insert(table.columns.end(), {"outcome", "finite"});
        if (!map.measure.empty()) table.columns.push_back(map.measure);
        for (const StabilityCell& cell : map.cells) {
            ++counts[static_cast<std::size_t>(cell.outcome)];
            ++cells;
            broken += cell.finite ? 0 : 1;
            std::vector<std::string> row;
            for (const double value : cell.at) row.push_back(short_number(value, 6));
            row.emplace_back(name_of(cell.outcome));
            row.emplace_back(cell.finite ? "yes" : "no");
            if (!map.measure.empty()) row.push_back(short_number(cell.measure, 5));
            table.rows.push_back(row);
        }
        page.paragraph("Model: " + map.model + ". " + std::to_string(map.cells.size()) +
                       " cells: " + std::to_string(counts[0]) + " stable, " + std::to_string(counts[1]) +
                       " degraded, " + std::to_string(counts[2]) + " faults.");
        for (const StabilityCurve& curve : map.theory)
            page.paragraph("Curve \"" + curve.name + "\": " + curve.formula + ".");
        if (!map.theory_note.empty()) page.paragraph(map.theory_note);
        page.table_file(table);
        page.chart(table.name, map.title, drawing(map));
    }
    page.paragraph(std::to_string(cells) + " cells in all; " + std::to_string(broken) +
                   " produced a value that is not finite.");
    page.document(to_json(maps));
    return page;
}

}  // namespace fulcrum::lab
