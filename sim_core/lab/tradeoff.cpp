// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/tradeoff.h"

#include <iterator>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/collision_tradeoff.h"
#include "sim_core/lab/contact_tradeoff.h"
#include "sim_core/lab/membrane_tradeoff.h"
#include "sim_core/lab/skin_tradeoff.h"
#include "sim_core/lab/tradeoff_rooms.h"

namespace fulcrum::lab {

void mark_pareto(TradeoffStudy& study) {
    for (TradeoffLevel& level : study.levels) {
        level.pareto =
            std::none_of(study.levels.begin(), study.levels.end(), [&](const TradeoffLevel& other) {
                return other.error_unit == level.error_unit && other.error <= level.error &&
                       other.time_us <= level.time_us &&
                       (other.error < level.error || other.time_us < level.time_us);
            });
    }
}

std::vector<TradeoffStudy> tradeoff_studies() {
    std::vector<TradeoffStudy> studies;
    for (const auto room : {rod_tradeoff, collision_tradeoff, membrane_tradeoff}) {
        for (TradeoffStudy& study : room()) {
            mark_pareto(study);
            studies.push_back(std::move(study));
        }
    }
    for (const auto study : {tool_contact_tradeoff, model_age_tradeoff, skinning_tradeoff})
        studies.push_back(study());
    return studies;
}

nlohmann::json to_json(const std::vector<TradeoffStudy>& studies) {
    nlohmann::json list = nlohmann::json::array();
    for (const TradeoffStudy& study : studies) {
        nlohmann::json levels = nlohmann::json::array();
        for (const TradeoffLevel& level : study.levels) {
            levels.push_back({{"level", level.level},
                              {"family", level.family},
                              {"error", level.error},
                              {"error_unit", level.error_unit},
                              {"time_us", level.time_us},
                              {"pareto", level.pareto}});
        }
        list.push_back({{"model", study.model}, {"reference", study.reference}, {"levels", levels}});
    }
    return {{"studies", list}};
}

namespace {

// One chart per error unit: points of a family are joined, the front is ringed.
void add_charts(ResultPage& page, const TradeoffStudy& study, std::size_t number) {
    std::vector<std::string> units;
    for (const TradeoffLevel& level : study.levels) {
        if (std::find(units.begin(), units.end(), level.error_unit) == units.end())
            units.push_back(level.error_unit);
    }
    for (std::size_t u = 0; u < units.size(); ++u) {
        Chart chart;
        chart.title = study.model + ": error against time of a step";
        chart.x_label = "median time of a step, us";
        chart.y_label = "error: " + units[u];
        chart.x_logarithmic = chart.y_logarithmic = true;
        chart.note =
            "Ringed and filled: on the Pareto front (no other level is both faster and more accurate).";
        bool exact = false;
        for (const TradeoffLevel& level : study.levels) {
            if (level.error_unit != units[u]) continue;
            if (!(level.error > 0)) {
                exact = true;
                continue;
            }
            const auto same = [&](const ChartSeries& series) { return series.name == level.family; };
            auto series = std::find_if(chart.series.begin(), chart.series.end(), same);
            if (series == chart.series.end()) {
                chart.series.push_back({});
                series = std::prev(chart.series.end());
                series->name = level.family;
            }
            series->x.push_back(level.time_us);
            series->y.push_back(level.error);
            series->marked.push_back(level.pareto);
        }
        if (exact) chart.note += " Levels without any error are in the table only.";
        if (chart.series.empty()) continue;
        page.chart("tradeoff_" + std::to_string(number) + "_" + study.model +
                       (u > 0 ? "_" + std::to_string(u + 1) : ""),
                   study.model + ": error against time", svg_chart(chart));
    }
}

}  // namespace

ResultPage tradeoff_page(const std::vector<TradeoffStudy>& studies) {
    ResultPage page("lab_tradeoff", "Speed against accuracy", "fulcrum lab tradeoff --output docs/results");
    page.paragraph(
        "Each level of each model at several resolutions: its error against the stated reference and the "
        "median time of a step on this machine. A level is on the Pareto front if no other level measured in "
        "the same unit is at least as good in both and better in one.");
    for (std::size_t i = 0; i < studies.size(); ++i) {
        const TradeoffStudy& study = studies[i];
        page.heading(study.model);
        page.paragraph("Reference: " + study.reference + ".");
        ResultTable table;
        table.name = "tradeoff_" + std::to_string(i + 1) + "_" + study.model;
        table.columns = {"level", "error", "error is", "time, us", "Pareto front"};
        for (const TradeoffLevel& level : study.levels) {
            table.rows.push_back({level.level, short_number(level.error), level.error_unit,
                                  short_number(level.time_us), level.pareto ? "yes" : ""});
        }
        page.table(table);
        add_charts(page, study, i + 1);
    }
    page.document(to_json(studies));
    return page;
}

}  // namespace fulcrum::lab
