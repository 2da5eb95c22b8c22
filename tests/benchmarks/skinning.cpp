// SPDX-License-Identifier: Apache-2.0
// Skinning and force filter: the product's reference workloads under Google Benchmark.
#include <benchmark/benchmark.h>

#include "sim_core/bowel/display_skin.h"
#include "sim_core/contact/force_filter.h"
#include "sim_core/lab/bench.h"
#include "sim_core/lab/contact_run.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/lab/yardstick.h"

namespace {

void run_workload(benchmark::State& state, const fulcrum::lab::Workload& workload) {
    const auto prepared = workload.prepare();
    for (auto _ : state) prepared.step();
    if (prepared.error) state.counters["error"] = prepared.error().value_or(0.0);
    state.counters["bytes"] = static_cast<double>(prepared.bytes);
}

void filter_force(benchmark::State& state) {
    const auto mesh = fulcrum::lab::make_tube(0.9, 400, 48, fulcrum::lab::plain_radius(0.016));
    const auto adjacency = fulcrum::build_adjacency(mesh);
    const auto view = fulcrum::view_of(mesh, adjacency);
    fulcrum::FilterOptions options;
    options.mode = static_cast<fulcrum::FilterMode>(state.range(0));
    fulcrum::FilteredForce result;
    std::int32_t vertex = 5000;
    for (auto _ : state) {
        fulcrum::filter_force(view, vertex, fulcrum::TipBox{}, options, result);
        benchmark::DoNotOptimize(result);
        vertex = 5000 + (vertex + 7) % 1000;
    }
}
BENCHMARK(filter_force)->DenseRange(0, 3);

// 2,000 to 200,000 vertices: time a vertex is the counter.
void size_sweep(benchmark::State& state) {
    const auto run = fulcrum::lab::build_contact_run_of(static_cast<int>(state.range(0)));
    const fulcrum::DisplaySkin display(*run->skin);
    std::vector<fulcrum::RingFrame> frames(run->rings.size());
    for (std::size_t r = 0; r < frames.size(); ++r) frames[r] = run->rings[r].frame;
    std::vector<float> ring_floats(12 * frames.size()),
        positions(3 * static_cast<std::size_t>(run->skin->vertices()));
    for (auto _ : state) display.evaluate(frames.data(), ring_floats.data(), positions.data(), nullptr);
    state.counters["vertices"] = run->skin->vertices();
    state.counters["s_per_vertex"] = benchmark::Counter(
        run->skin->vertices(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(size_sweep)->RangeMultiplier(10)->Range(4000, 400000);

void yardstick(benchmark::State& state) {
    double sum = 0.0;
    for (auto _ : state) sum += fulcrum::lab::time_yardstick_us();
    state.counters["yardstick_us"] = sum / static_cast<double>(state.iterations());
}
BENCHMARK(yardstick);

}  // namespace

int main(int argc, char** argv) {
    std::vector<fulcrum::lab::Workload> workloads;
    fulcrum::lab::add_skinning_workloads(workloads);
    for (const auto& workload : workloads) {
        benchmark::RegisterBenchmark(workload.name.c_str(),
                                     [&workload](benchmark::State& state) { run_workload(state, workload); });
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
