// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/membrane_tradeoff.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/lab/membrane_reference.h"

namespace fulcrum::lab {
namespace {

constexpr double frame = 0.005;  // s

MembraneSolve solve_of(MembraneIntegrator integrator, int iterations = 0) {
    MembraneSolve solve;
    solve.integrator = integrator;
    solve.iterations = iterations;
    return solve;
}

// Frames of a sheet whose edge moves: the worst energy gap of twelve, and the median time.
TradeoffStudy frames() {
    TradeoffStudy study;
    study.model = "membrane_frame";
    study.reference =
        "implicit Euler by Newton to 1e-10, frame by frame; a sheet held at two edges, one moving at 50 "
        "mm/s, frames of 5 ms";
    struct Level {
        const char* name;
        MembraneSolve solve;
    };
    const Level levels[] = {{"symplectic", solve_of(MembraneIntegrator::symplectic)},
                            {"global-local, 2 iterations", solve_of(MembraneIntegrator::global_local, 2)},
                            {"global-local, 4 iterations", solve_of(MembraneIntegrator::global_local, 4)},
                            {"global-local, 8 iterations", solve_of(MembraneIntegrator::global_local, 8)},
                            {"global-local, 16 iterations", solve_of(MembraneIntegrator::global_local, 16)},
                            {"implicit, to 1e-10", solve_of(MembraneIntegrator::implicit)}};
    for (const int side : {16, 32, 48}) {
        HeldSheet sheet(side);
        const Membrane& membrane = sheet.membrane;
        const MembraneSolve exact = solve_of(MembraneIntegrator::implicit);
        MembraneState hung = membrane.make_state();
        {
            MembraneScratch statics = membrane.make_scratch(0);
            membrane.solve(hung, sheet.inputs, statics, exact);
        }
        for (const Level& level : levels) {
            MembraneScratch scratch = membrane.make_scratch(frame), judge = membrane.make_scratch(frame);
            MembraneState state = hung, start = hung;
            int count = 0;
            TradeoffLevel row;
            row.family = std::to_string(side * side) + " nodes";
            row.level = std::string(level.name) + ", " + row.family;
            const auto judge_last = [&] {
                if (count == 0) return;
                MembraneState ideal = start;
                membrane.step(ideal, sheet.inputs, frame, judge, exact);
                row.error = std::max(row.error,
                                     energy_gap(membrane, start, state, ideal, sheet.inputs, frame, judge));
            };
            row.time_us = median_time_us(
                0, 12, [&] { membrane.step(state, sheet.inputs, frame, scratch, level.solve); },
                [&] {
                    judge_last();
                    start = state;
                    sheet.move_edge(++count);
                });
            judge_last();
            // Sheets of different size are different problems: each has its own front.
            row.error_unit = "worst energy gap of a frame / (E_start - E_reference), " + row.family;
            study.levels.push_back(row);
            sheet.move_edge(0);
        }
    }
    return study;
}

// Static sag in the middle compared with a finer sheet of the same tissue. The springs of one mesh do not
// define a material: the refinement converges to the sag of a finer mesh with the same springs.
TradeoffStudy resolution() {
    TradeoffStudy study;
    study.model = "membrane_resolution";
    study.reference =
        "a 4 times finer sheet (129 x 129 nodes) solved the same way: sag of the middle of a sheet held at "
        "two edges";
    const auto sag = [](int side, double* time) {
        HeldSheet sheet(side);
        MembraneScratch scratch = sheet.membrane.make_scratch(0);
        const MembraneState flat = sheet.membrane.make_state();
        MembraneState state = flat;
        MembraneSolve solve = solve_of(MembraneIntegrator::global_local, 40);
        const auto step = [&] { sheet.membrane.solve(state, sheet.inputs, scratch, solve); };
        if (time != nullptr)
            *time = median_time_us(1, 5, step, [&] { state = flat; });
        else
            step();
        return state.positions[static_cast<std::size_t>((side / 2) * side + side / 2)].z();
    };
    const double exact = sag(129, nullptr);
    for (const int side : {9, 17, 33}) {
        TradeoffLevel row;
        row.family = "global-local, 40 iterations";
        row.level = std::to_string(side) + " x " + std::to_string(side) + " nodes";
        row.error = std::fabs(sag(side, &row.time_us) / exact - 1);
        row.error_unit = "sag, relative";
        study.levels.push_back(row);
    }
    return study;
}

}  // namespace

std::vector<TradeoffStudy> membrane_tradeoff() {
    return {frames(), resolution()};
}

std::vector<StabilityMap> membrane_stability() {
    std::vector<StabilityMap> maps;
    constexpr int side = 14;
    std::vector<double> time_steps, stiffnesses;
    for (int i = 0; i < 10; ++i) time_steps.push_back(5e-5 * std::pow(1000.0, i / 9.0));
    for (int i = 0; i < 9; ++i) stiffnesses.push_back(std::pow(10.0, -1 + i * 0.875));
    struct Row {
        MembraneIntegrator integrator;
        const char* name;
    };
    for (const Row row : {Row{MembraneIntegrator::symplectic, "symplectic Euler"},
                          Row{MembraneIntegrator::global_local, "global-local"},
                          Row{MembraneIntegrator::implicit, "implicit Euler"}}) {
        StabilityMap map;
        map.model = "membrane";
        map.title = std::string("Membrane, ") + row.name + ": time step against stiffness";
        map.axes = {{"time_step_s", "s", time_steps, true}, {"stiffness_n_m", "N/m", stiffnesses, true}};
        map.measure = "substeps of a step, at most";
        StabilityCurve limit;
        limit.name = "symplectic limit";
        limit.formula =
            "dt = (2/w)(sqrt(1 + z^2) - z), w the highest frequency of the tangent at rest: symplectic Euler "
            "substeps beyond it and refuses beyond 256 "
            "substeps; the implicit integrators have no such bound";
        for (const double stiffness : stiffnesses) {
            HeldSheet sheet(side, stiffness);
            MembraneScratch first = sheet.membrane.make_scratch(frame);
            limit.x.push_back(sheet.membrane.limit(sheet.membrane.make_state(), first).time_step);
            limit.y.push_back(stiffness);
            for (const double dt : time_steps) {
                StabilityCell cell;
                cell.at = {dt, stiffness};
                MembraneScratch scratch = sheet.membrane.make_scratch(dt);
                MembraneState state = sheet.membrane.make_state();
                for (int i = 1; i <= 24 && cell.outcome != StabilityOutcome::fault; ++i) {
                    sheet.move_edge(i);
                    const MembraneReport report =
                        sheet.membrane.step(state, sheet.inputs, dt, scratch, solve_of(row.integrator));
                    cell.measure = std::max(cell.measure, static_cast<double>(report.substeps));
                    cell.finite = cell.finite && Membrane::finite(state);
                    double farthest = 0;
                    for (const Vector3& p : state.positions) farthest = std::max(farthest, p.norm());
                    // Bounded by free fall over the whole run and the sheet's own size.
                    const double fall = 0.5 * 9.81 * (24 * dt) * (24 * dt);
                    if (!cell.finite || report.fault == MembraneFault::refused ||
                        report.fault == MembraneFault::frozen || farthest > 1.0 + 2 * fall) {
                        cell.outcome = StabilityOutcome::fault;
                    } else if (report.fault != MembraneFault::none) {
                        cell.outcome = StabilityOutcome::degraded;
                    }
                }
                sheet.move_edge(0);
                map.cells.push_back(cell);
            }
        }
        map.theory.push_back(limit);
        maps.push_back(map);
    }
    maps.push_back(membrane_sliver_map());
    return maps;
}

}  // namespace fulcrum::lab
