// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/cut_strokes.h"
#include "sim_core/lab/processor_time.h"
#include "sim_core/lab/yardstick.h"

namespace fulcrum::lab {
namespace {

// Budgets of docs/QUALITY.md: topology alone; a whole step at worst.
constexpr double budget_mg = 10, worst_budget_mg = 700;

double share_of_steps(const StrokeTally& tally) {
    return tally.steps > 0 ? 100.0 * tally.roll_backs / tally.steps : 0;
}

std::vector<std::string> row_of(const std::string& name, const StrokeTally& tally) {
    std::vector<std::string> row = {name};
    for (const int n : {tally.strokes, tally.steps, tally.cuts, tally.nothing, tally.roll_backs,
                        tally.retried, tally.uncut, tally.violations})
        row.push_back(std::to_string(n));
    row.push_back(short_number(share_of_steps(tally), 2));
    row.push_back(short_number(tally.area_error, 2));
    return row;
}

nlohmann::json json_of(const std::string& name, const StrokeTally& tally) {
    return {{"name", name},
            {"strokes", tally.strokes},
            {"steps", tally.steps},
            {"refused", tally.refused},
            {"cut", tally.cuts},
            {"nothing", tally.nothing},
            {"rolled_back", tally.roll_backs},
            {"cut_when_tried_again", tally.retried},
            {"left_uncut", tally.uncut},
            {"widened", tally.widened},
            {"pieces_dropped", tally.pieces},
            {"roots_without_area", tally.flat},
            {"violations", tally.violations},
            {"area_error", tally.area_error}};
}

struct Times {
    double median = 0, p99 = 0, worst = 0;  // mG
};

Times times_of(std::vector<float> us, double yardstick_us) {
    Times times;
    if (us.empty()) return times;
    std::sort(us.begin(), us.end());
    const auto at = [&](double share) {
        return 1000.0 * us[static_cast<std::size_t>(share * static_cast<double>(us.size() - 1))] /
               yardstick_us;
    };
    return {at(0.5), at(0.99), at(1)};
}

// Runs the stress cases and adds their section to the page. Returns their part of the document.
nlohmann::json add_stress_cases(ResultPage& page, int strokes, const std::vector<std::string>& columns) {
    nlohmann::json cases = nlohmann::json::array();
    ResultTable stress_table;
    page.heading("Stress cases");
    const int meshes = std::max(1, strokes / 300);
    page.paragraph(
        std::to_string(meshes) +
        " meshes per case and twelve steps per mesh. (In \"every triangle cut\" the strokes lie closer "
        "together than the cells, in both directions.) Blades are 0.1 um to 100 mm wide, 0.1 mm to 2 m long "
        "and tilted; one in twelve is not finite, and each of those was refused. The whole surface is "
        "checked after every step. A band thinner than a thousandth of the triangles that it meets is "
        "widened to that. Root triangles without area are cut, but the shape of their parts is not judged.");
    stress_table.name = "cut_stress";
    stress_table.columns = {"case", "meshes", "steps"};
    stress_table.columns.insert(stress_table.columns.end(), columns.begin(), columns.end());
    stress_table.columns.insert(stress_table.columns.end(), {"refused", "widened", "roots without area"});
    StrokeTally stress;
    const auto add_row = [&](const std::string& name, const StrokeTally& tally) {
        stress_table.rows.push_back(row_of(name, tally));
        for (const int n : {tally.refused, tally.widened, tally.flat})
            stress_table.rows.back().push_back(std::to_string(n));
        cases.push_back(json_of(name, tally));
    };
    const std::vector<std::string> names = stress_names();
    for (std::size_t which = 0; which < names.size(); ++which) {
        StrokeTally tally;
        for (int i = 0; i < meshes; ++i) run_stress(which, static_cast<std::uint64_t>(i), tally);
        add_row(names[which], tally);
        stress.add(tally);
    }
    add_row("total", stress);
    page.table(stress_table);
    return cases;
}

}  // namespace

ResultPage cut_strokes_page(int strokes) {
    const std::string count = std::to_string(strokes);
    ResultPage page("cut_strokes", count + " random strokes",
                    "fulcrum lab strokes " + count + " --output docs/results");
    const std::vector<std::string> columns = {"steps cut",
                                              "hit nothing",
                                              "rolled back",
                                              "cut on retry",
                                              "not cut",
                                              "invariants broken",
                                              "rolled back, % of steps",
                                              "worst area error, relative"};
    ResultTable table, time_table;
    table.name = "cut_strokes";
    table.columns = {"surface", "strokes", "steps"};
    table.columns.insert(table.columns.end(), columns.begin(), columns.end());
    time_table.columns = {"surface", "median, mG", "p99, mG", "worst, mG"};
    std::vector<double> yardsticks;
    struct Run {
        std::string name;
        StrokeTally tally;
    };
    std::vector<Run> runs;
    StrokeTally all;
    for (const StrokeSurface& surface : stroke_surfaces())
        for (const bool deform : {false, true}) {
            for (int k = 0; k < 5; ++k) {
                const double begin = processor_time_us();
                time_yardstick_us();
                yardsticks.push_back(processor_time_us() - begin);
            }
            runs.push_back({surface.name + (deform ? ", moving" : ", at rest"),
                            run_strokes(surface.mesh, deform, std::max(1, strokes / 8), deform ? 11 : 7)});
            all.add(runs.back().tally);
        }
    std::nth_element(yardsticks.begin(),
                     yardsticks.begin() + static_cast<std::ptrdiff_t>(yardsticks.size() / 2),
                     yardsticks.end());
    const double yardstick = yardsticks[yardsticks.size() / 2];
    nlohmann::json surfaces = nlohmann::json::array();
    runs.push_back({"total", all});
    for (const Run& run : runs) {
        const Times times = times_of(run.tally.step_us, yardstick);
        table.rows.push_back(row_of(run.name, run.tally));
        time_table.rows.push_back(
            {run.name, short_number(times.median), short_number(times.p99), short_number(times.worst)});
        surfaces.push_back(json_of(run.name, run.tally));
        surfaces.back()["median_mg"] = times.median;
        surfaces.back()["p99_mg"] = times.p99;
        surfaces.back()["worst_mg"] = times.worst;
    }
    page.paragraph(
        "Each stroke has one to four steps with a blade 0.2 to 6 mm wide and starts anywhere: inside a "
        "triangle, at a vertex, on or along an edge. \"Moving\" means that the surface deforms during the "
        "stroke, stretched by up to a third. Every step is validated on everything that it touched, and the "
        "whole surface after every tenth stroke. Pieces without a fixed vertex are dropped.");
    page.table(table);
    page.heading("Time of a step");
    page.paragraph(
        "Processor time of one step: the change of topology and the validation of everything that it "
        "touched. G is the processor time of one 512 x 512 x 512 double matrix product in the same process; "
        "1 mG is a thousandth of it. Here G = " +
        short_number(yardstick / 1000) + " ms. Budgets: a step of 2 mm with a blade of 1 mm, " +
        short_number(budget_mg) + " mG median (lab_bench, cut_topology); any step, " +
        short_number(worst_budget_mg) + " mG at worst.");
    page.table(time_table);

    const nlohmann::json cases = add_stress_cases(page, strokes, columns);
    page.document(
        {{"strokes", strokes}, {"yardstick_us", yardstick}, {"surfaces", surfaces}, {"stress", cases}});
    return page;
}

}  // namespace fulcrum::lab
