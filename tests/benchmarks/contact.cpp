// SPDX-License-Identifier: Apache-2.0
// Tool contact: dynamic point, proxy and patch: the product's reference workloads under Google Benchmark. The
// untimed part of a workload (the hand and the world moving on) is kept out of the time by hand.
#include <benchmark/benchmark.h>

#include <chrono>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/contact_run.h"
#include "sim_core/lab/yardstick.h"

namespace {

void run_workload(benchmark::State& state, const fulcrum::lab::Workload& workload) {
    using Clock = std::chrono::steady_clock;
    const auto prepared = workload.prepare();
    for (auto _ : state) {
        if (prepared.between) prepared.between();
        const auto begin = Clock::now();
        prepared.step();
        state.SetIterationTime(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    if (prepared.error) state.counters["error"] = prepared.error().value_or(0.0);
    state.counters["bytes"] = static_cast<double>(prepared.bytes);
}

// 2,000 to 200,000 vertices: a tick of contact, and the building of a patch.
void size_sweep(benchmark::State& state, bool patch) {
    using Clock = std::chrono::steady_clock;
    const auto run = fulcrum::lab::build_contact_run_of(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        run->prepare_tick(0);
        const auto begin = Clock::now();
        if (patch) {
            run->publish();
        } else {
            run->touch();
        }
        state.SetIterationTime(std::chrono::duration<double>(Clock::now() - begin).count());
        if (patch) run->touch();
    }
    state.counters["vertices"] = run->skin->vertices();
}
BENCHMARK_CAPTURE(size_sweep, tick, false)->RangeMultiplier(10)->Range(4000, 400000)->UseManualTime();
BENCHMARK_CAPTURE(size_sweep, patch, true)->RangeMultiplier(10)->Range(4000, 400000)->UseManualTime();

void yardstick(benchmark::State& state) {
    double sum = 0.0;
    for (auto _ : state) sum += fulcrum::lab::time_yardstick_us();
    state.counters["yardstick_us"] = sum / static_cast<double>(state.iterations());
}
BENCHMARK(yardstick);

}  // namespace

int main(int argc, char** argv) {
    std::vector<fulcrum::lab::Workload> workloads;
    fulcrum::lab::add_contact_workloads(workloads);
    for (const auto& workload : workloads) {
        benchmark::RegisterBenchmark(workload.name.c_str(), [&workload](benchmark::State& state) {
            run_workload(state, workload);
        })->UseManualTime();
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
