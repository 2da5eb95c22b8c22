// SPDX-License-Identifier: Apache-2.0
// Size sweep of the cut's topology: a step of 2 mm on sheets of 10,000 to 100,000 triangles with the same
// edges (flat: what a step touches does not depend on the size), and the search for pieces, which is linear.
#include <benchmark/benchmark.h>

#include "sim_core/lab/cut_run.h"

namespace fulcrum {
namespace {

void step(benchmark::State& bench) {
    lab::CutRun run(static_cast<int>(bench.range(0)));
    for (int i = 0; i < 50; ++i) {
        run.advance_blade();
        run.cut();
    }
    std::int64_t met = 0;
    for (auto _ : bench) {
        bench.PauseTiming();
        run.advance_blade();
        bench.ResumeTiming();
        met += run.cut().met;
    }
    bench.counters["triangles_met"] = static_cast<double>(met) / static_cast<double>(bench.iterations());
    bench.counters["rolled_back"] = static_cast<double>(run.mesh.rolled_back());
    bench.counters["bytes"] = static_cast<double>(run.mesh.bytes());
}

void pieces(benchmark::State& bench) {
    lab::CutRun run(static_cast<int>(bench.range(0)));
    for (int i = 0; i < 50; ++i) {
        run.advance_blade();
        run.cut();
    }
    for (auto _ : bench) benchmark::DoNotOptimize(run.mesh.find_pieces());
}

void save(benchmark::State& bench) {
    lab::CutRun run(static_cast<int>(bench.range(0)));
    CutState state = run.mesh.state();
    for (auto _ : bench) {
        state = run.mesh.state();
        benchmark::DoNotOptimize(&state);
    }
}

BENCHMARK(step)->Arg(10000)->Arg(30000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(pieces)->Arg(10000)->Arg(30000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(save)->Arg(10000)->Arg(100000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace fulcrum

BENCHMARK_MAIN();
