// SPDX-License-Identifier: Apache-2.0
// The product's reference workloads under Google Benchmark. The untimed part of a workload (the motion of
// hand and world) is excluded with manual timing. Size sweeps: `fulcrum lab bench --sweep`.
#pragma once

#include <benchmark/benchmark.h>

#include <chrono>
#include <vector>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/yardstick.h"

namespace fulcrum {

inline void run_workload(benchmark::State& state, const lab::Workload& workload) {
    using Clock = std::chrono::steady_clock;
    const lab::Workload::Prepared prepared = workload.prepare();
    for (auto _ : state) {
        if (prepared.between) prepared.between();
        const auto begin = Clock::now();
        prepared.step();
        state.SetIterationTime(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    if (prepared.error) state.counters["error"] = prepared.error().value_or(0.0);
    state.counters["bytes"] = static_cast<double>(prepared.bytes);
}

inline void yardstick(benchmark::State& state) {
    double sum = 0.0;
    for (auto _ : state) sum += lab::time_yardstick_us();
    state.counters["yardstick_us"] = sum / static_cast<double>(state.iterations());
}

/// main() of a program that runs these workloads, the yardstick, and any other benchmarks that it has
/// registered.
inline int run_benchmarks(int argc, char** argv, const std::vector<lab::Workload>& workloads) {
    for (const lab::Workload& workload : workloads) {
        benchmark::RegisterBenchmark(workload.name.c_str(), [&workload](benchmark::State& state) {
            run_workload(state, workload);
        })->UseManualTime();
    }
    benchmark::RegisterBenchmark("yardstick", yardstick);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}

}  // namespace fulcrum
