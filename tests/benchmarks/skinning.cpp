// SPDX-License-Identifier: Apache-2.0
// Skinning and force filter: the product's reference workloads under Google Benchmark.
#include "sim_core/bowel/force_filter.h"
#include "sim_core/lab/reference_tube.h"
#include "tests/benchmarks/workloads.h"

namespace {

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

}  // namespace

int main(int argc, char** argv) {
    std::vector<fulcrum::lab::Workload> workloads;
    fulcrum::lab::add_skinning_workloads(workloads);
    return fulcrum::run_benchmarks(argc, argv, workloads);
}
