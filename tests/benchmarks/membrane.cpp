// SPDX-License-Identifier: Apache-2.0
// Size sweep of the membrane, 500 to 50,000 nodes: a frame of each integrator and its parts (springs, a
// multigrid cycle, building its levels), the update after a cut; with time per node and operations of each
// part, which all grow linearly.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "sim_core/lab/membrane_reference.h"
#include "sim_core/membrane/membrane_system.h"

namespace fulcrum {
namespace {

int side_of(const benchmark::State& bench) {
    return static_cast<int>(std::lround(std::sqrt(static_cast<double>(bench.range(0)))));
}

void count(benchmark::State& bench, const Membrane& membrane, const MembraneScratch& scratch) {
    const double nodes = membrane.vertices();
    const MembraneScratch::Operations operations = scratch.operations();
    bench.counters["solve_operations_per_node"] = static_cast<double>(operations.solve) / nodes;
    bench.counters["build_operations_per_node"] = static_cast<double>(operations.build) / nodes;
    bench.counters["springs_per_node"] = static_cast<double>(operations.springs) / nodes;
    bench.counters["time_per_node"] = benchmark::Counter(
        nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void frame(benchmark::State& bench, MembraneIntegrator integrator) {
    lab::HeldSheet sheet(side_of(bench));
    MembraneScratch scratch = sheet.membrane.make_scratch(0.005);
    MembraneState state = sheet.membrane.make_state();
    MembraneSolve solve;
    solve.integrator = integrator;
    solve.iterations = integrator == MembraneIntegrator::global_local ? 8 : 0;
    solve.tolerance = integrator == MembraneIntegrator::implicit ? 1e-6 : 0;
    solve.most_substeps = 100000;
    int frames = 0;
    for (auto _ : bench) {
        bench.PauseTiming();
        sheet.move_edge(++frames);
        bench.ResumeTiming();
        sheet.membrane.step(state, sheet.inputs, 0.005, scratch, solve);
    }
    count(bench, sheet.membrane, scratch);
}
void frame_global_local(benchmark::State& bench) {
    frame(bench, MembraneIntegrator::global_local);
}
void frame_implicit(benchmark::State& bench) {
    frame(bench, MembraneIntegrator::implicit);
}
void frame_symplectic(benchmark::State& bench) {
    frame(bench, MembraneIntegrator::symplectic);
}

void part_springs(benchmark::State& bench) {
    lab::HeldSheet sheet(side_of(bench));
    MembraneScratch scratch = sheet.membrane.make_scratch(0.005);
    MembraneState state = sheet.membrane.make_state();
    sheet.membrane.step(state, sheet.inputs, 0.005, scratch);
    auto& data = scratch.data();
    for (auto _ : bench)
        benchmark::DoNotOptimize(membrane_detail::potential(sheet.membrane.tables(), data,
                                                            data.position.data(), data.gradient.data()));
    count(bench, sheet.membrane, scratch);
}

void part_solve(benchmark::State& bench) {
    lab::HeldSheet sheet(side_of(bench));
    MembraneScratch scratch = sheet.membrane.make_scratch(0.005);
    auto& data = scratch.data();
    for (auto _ : bench) {
        bench.PauseTiming();
        std::fill(data.direction.begin(), data.direction.end(),
                  all_lanes(1));  // otherwise it decays to denormals
        bench.ResumeTiming();
        data.multigrid.solve(data.direction.data());
    }
    count(bench, sheet.membrane, scratch);
}

void part_build(benchmark::State& bench) {
    lab::HeldSheet sheet(side_of(bench));
    MembraneScratch scratch = sheet.membrane.make_scratch(0.005);
    MembraneState state = sheet.membrane.make_state();
    MembraneSolve solve;
    solve.iterations = 1;
    double dt = 0.005;
    for (auto _ : bench) sheet.membrane.step(state, sheet.inputs, dt *= 0.999, scratch, solve);
    count(bench, sheet.membrane, scratch);
}

// One frame in which 20 consecutive springs are cut: the additional cost over membrane frame_global_local.
void frame_with_cut(benchmark::State& bench) {
    lab::HeldSheet sheet(side_of(bench));
    MembraneScratch scratch = sheet.membrane.make_scratch(0.005);
    MembraneState state = sheet.membrane.make_state();
    MembraneSolve solve;
    solve.iterations = 8;
    std::size_t next = 0;
    for (auto _ : bench) {
        for (int i = 0; i < 20; ++i) state.cut[next++ % state.cut.size()] = 1;
        ++state.topology;
        sheet.membrane.step(state, sheet.inputs, 0.005, scratch, solve);
    }
    bench.counters["updates"] =
        static_cast<double>(scratch.updates()) / static_cast<double>(bench.iterations());
    bench.counters["builds"] = scratch.builds();
}

void build(benchmark::State& bench) {
    for (auto _ : bench) {
        lab::HeldSheet sheet(side_of(bench));
        benchmark::DoNotOptimize(sheet.membrane.bytes());
    }
}

BENCHMARK(frame_global_local)
    ->Arg(500)
    ->Arg(1000)
    ->Arg(5000)
    ->Arg(20000)
    ->Arg(50000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(part_springs)
    ->Arg(500)
    ->Arg(1000)
    ->Arg(5000)
    ->Arg(20000)
    ->Arg(50000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(part_solve)->Arg(500)->Arg(1000)->Arg(5000)->Arg(20000)->Arg(50000)->Unit(benchmark::kMicrosecond);
BENCHMARK(frame_implicit)->Arg(500)->Arg(1000)->Arg(5000)->Unit(benchmark::kMicrosecond);
BENCHMARK(frame_symplectic)->Arg(500)->Arg(1000)->Arg(5000)->Unit(benchmark::kMicrosecond);
BENCHMARK(part_build)->Arg(500)->Arg(1000)->Arg(5000)->Arg(20000)->Arg(50000)->Unit(benchmark::kMicrosecond);
BENCHMARK(frame_with_cut)->Arg(1000)->Arg(5000)->Arg(20000)->Iterations(20)->Unit(benchmark::kMicrosecond);
BENCHMARK(build)->Arg(1000)->Arg(5000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fulcrum

BENCHMARK_MAIN();
