// SPDX-License-Identifier: Apache-2.0
// The membrane's reference workloads (docs/FORMATS.md, lab bench): statics to 1 % of the energy, and one 5 ms
// frame.
#include <algorithm>
#include <memory>
#include <string>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/membrane_reference.h"
#include "sim_core/lab/size_sweep.h"

namespace fulcrum::lab {
namespace {

constexpr double frame = 0.005;  // s
constexpr int static_iterations = 14, frame_iterations = 4;

struct Bench {
    HeldSheet sheet;
    MembraneScratch scratch;
    MembraneState start, state;
    MembraneSolve quick, exact;
    int frames = 0;
    Bench(int side, double dt)
        : sheet(side),
          scratch(sheet.membrane.make_scratch(dt)),
          start(sheet.membrane.make_state()),
          state(start) {
        exact.integrator = MembraneIntegrator::implicit;
    }
};

/// Static equilibrium from the flat sheet, the matrix built with the membrane; error: energy gap to Newton at
/// 1e-10.
Workload::Prepared prepare_static(int side) {
    auto bench = std::make_shared<Bench>(side, 0.0);
    bench->quick.iterations = static_iterations;
    Workload::Prepared prepared;
    prepared.between = [bench] { bench->state = bench->start; };
    prepared.step = [bench] {
        bench->sheet.membrane.solve(bench->state, bench->sheet.inputs, bench->scratch, bench->quick);
    };
    prepared.bytes = bench->sheet.membrane.bytes() + bench->scratch.bytes();
    prepared.error = [bench] {
        MembraneState reference = bench->start;
        const Membrane& membrane = bench->sheet.membrane;
        const MembraneReport report =
            membrane.solve(reference, bench->sheet.inputs, bench->scratch, bench->exact);
        if (!report.converged) return std::optional<double>();
        return std::optional<double>(energy_gap(membrane, bench->start, bench->state, reference,
                                                bench->sheet.inputs, 0, bench->scratch));
    };
    prepared.error_unit = "energy gap over that of the flat start; against Newton at 1e-10";
    return prepared;
}

/// A frame of 5 ms, one edge moved around a circle at 50 mm/s; error: the worst of ten frames spread over
/// half of it, compared with implicit Euler at 1e-10.
Workload::Prepared prepare_frame(int side) {
    auto bench = std::make_shared<Bench>(side, frame);
    bench->quick.iterations = 30;
    bench->sheet.membrane.solve(bench->state, bench->sheet.inputs, bench->scratch, bench->quick);
    bench->scratch = bench->sheet.membrane.make_scratch(frame);
    bench->quick.iterations = frame_iterations;
    Workload::Prepared prepared;
    prepared.between = [bench] { bench->sheet.move_edge(++bench->frames); };
    prepared.step = [bench] {
        bench->sheet.membrane.step(bench->state, bench->sheet.inputs, frame, bench->scratch, bench->quick);
    };
    prepared.bytes = bench->sheet.membrane.bytes() + bench->scratch.bytes();
    prepared.error = [bench] {
        double worst = 0;
        for (int k = 0; k < 10; ++k) {
            for (int i = 0; i < 12; ++i) {
                bench->sheet.move_edge(++bench->frames);
                bench->sheet.membrane.step(bench->state, bench->sheet.inputs, frame, bench->scratch,
                                           bench->quick);
            }
            bench->sheet.move_edge(++bench->frames);
            const MembraneState start = bench->state;
            MembraneState reference = start;
            const Membrane& membrane = bench->sheet.membrane;
            if (!membrane.step(reference, bench->sheet.inputs, frame, bench->scratch, bench->exact).converged)
                return std::optional<double>();
            membrane.step(bench->state, bench->sheet.inputs, frame, bench->scratch, bench->quick);
            worst = std::max(worst, energy_gap(membrane, start, bench->state, reference, bench->sheet.inputs,
                                               frame, bench->scratch));
        }
        return std::optional<double>(worst);
    };
    prepared.error_unit = "worst share of (E_start - E_ref) of a frame; implicit Euler at 1e-10";
    return prepared;
}

}  // namespace

void add_membrane_workloads(std::vector<Workload>& workloads) {
    const struct {
        const char* name;
        int side;
        double budget;
        int samples;
    } sizes[] = {
        {"membrane_1k", 32, 2500, 200}, {"membrane_5k", 71, 10000, 60}, {"membrane_20k", 142, 60000, 24}};
    for (const auto& size : sizes) {
        Workload workload;
        workload.name = size.name;
        workload.budget_mg = size.budget;
        workload.warm_up = 3;
        workload.samples = size.samples;
        const int side = size.side;
        workload.prepare = [side] { return prepare_static(side); };
        workloads.push_back(workload);
    }
    Workload one;
    one.name = "membrane_frame";
    one.budget_mg = 500;
    one.samples = 300;
    one.prepare = [] { return prepare_frame(71); };
    workloads.push_back(one);
}

void add_membrane_sweeps(std::vector<SweepCase>& sweeps) {
    SweepCase sweep;
    sweep.model = "membrane, frame of 5 ms";
    sweep.element = "node";
    sweep.operation = "springs evaluated and entries of the multigrid used, " +
                      std::to_string(frame_iterations) + " iterations a frame";
    sweep.sizes = {22, 71, 142, 224};  // along an edge
    sweep.ratio_limit = 4;
    sweep.warm_up = sweep.counted = 3;
    sweep.prepare = [](int side) {
        const Workload::Prepared prepared = prepare_frame(side);
        const MembraneScratch::Operations each = HeldSheet(side).membrane.make_scratch(frame).operations();
        const auto frames = std::make_shared<int>(0);
        SweepRun run;
        run.elements = static_cast<double>(side) * side;
        run.between = prepared.between;
        run.step = [step = prepared.step, frames] {
            step();
            ++*frames;
        };
        run.operations = [each, frames] {
            return static_cast<double>(*frames) * frame_iterations *
                   static_cast<double>(each.springs + each.solve);
        };
        return run;
    };
    sweeps.push_back(sweep);
}

}  // namespace fulcrum::lab
