// SPDX-License-Identifier: Apache-2.0
// Collision: spheres in a cavity and among themselves: the product's reference workloads under Google
// Benchmark. The untimed part of a workload (the hand and the world moving on) is kept out of the time by
// hand.
#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/collision_run.h"
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

// Size sweeps: spheres with the bowl that holds them, and the bowl's triangles alone. Time and operations of
// one element are the counters.
void size_sweep(benchmark::State& state, int spheres, int level) {
    fulcrum::lab::CollisionRunOptions options;
    options.spheres = spheres;
    options.bowl_level = level;
    options.frames = 30;
    const auto run = fulcrum::lab::make_collision_run(options);
    fulcrum::lab::CollisionWork work;
    for (auto _ : state) {
        work = fulcrum::lab::measure_collision_work(*run, 60);
        state.SetIterationTime(1e-6 * work.time_us);
    }
    state.counters["triangles"] = static_cast<double>(run->cavity->triangles().size());
    state.counters["us_per_sphere"] = work.time_us / spheres;
    state.counters["operations"] = work.operations();
    state.counters["operations_per_sphere"] = work.operations() / spheres;
}

void yardstick(benchmark::State& state) {
    double sum = 0.0;
    for (auto _ : state) sum += fulcrum::lab::time_yardstick_us();
    state.counters["yardstick_us"] = sum / static_cast<double>(state.iterations());
}
BENCHMARK(yardstick);

}  // namespace

int main(int argc, char** argv) {
    std::vector<fulcrum::lab::Workload> workloads;
    fulcrum::lab::add_collision_workloads(workloads);
    for (const auto& workload : workloads) {
        benchmark::RegisterBenchmark(workload.name.c_str(), [&workload](benchmark::State& state) {
            run_workload(state, workload);
        })->UseManualTime();
    }
    const int sizes[][2] = {{50, 4}, {200, 5}, {800, 6}, {200, 3}, {200, 4}, {200, 6}, {200, 7}};
    for (const auto& size : sizes) {
        const std::string name =
            "size_sweep/spheres:" + std::to_string(size[0]) + "/level:" + std::to_string(size[1]);
        benchmark::RegisterBenchmark(
            name.c_str(), [&size](benchmark::State& state) { size_sweep(state, size[0], size[1]); })
            ->UseManualTime()
            ->Iterations(5);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
