// SPDX-License-Identifier: Apache-2.0
// Size sweep of the cut's topology: a step of 2 mm on sheets of 10,000 to 100,000 triangles with equal edges
// (flat: what a step touches does not depend on the size), and the search for pieces, which is linear; a step
// through the bowel's wall.
#include <benchmark/benchmark.h>
#include <utility>

#include "sim_core/lab/cut_run.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/world.h"
#include "tests/support/support.h"

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

// A step of 2 mm along the wall of the bowel as made by scissors in the world: surface, invariants, rows of
// the new vertices, detached pieces; with (1) or without the data for the window.
void bowel_wall(benchmark::State& bench) {
    World world(load_scene(test::source_path("assets/scenes/bowel_enterotomy.json")), 1);
    BowelCut& cut = *world.find<BowelPart>()->cut();
    const BowelSkin& skin = world.find<BowelPart>()->skin();
    const RingFrame* const frames = world.find<BowelPart>()->ring_frames();
    StateList::Values uncut;
    StateList saving(uncut);
    cut.list_state(saving);
    WorldSnapshot snapshot = world.snapshot();
    // Lines along the bowel, from vertex to vertex of the generator's rings of 48.
    constexpr int around = 48, first_ring = 100, steps = 150, lines = 3;
    int next = 0;
    for (auto _ : bench) {
        bench.PauseTiming();
        if (next == lines * steps) {
            StateList restoring(std::as_const(uncut));
            cut.list_state(restoring);
            next = 0;
        }
        const int from = 1 + (first_ring + next % steps) * around + 7 * (next / steps), to = from + around;
        const auto now = [&](int v) { return skin_vertex(skin.rows()[static_cast<std::size_t>(v)], frames); };
        BladeStep blade;
        blade.from = now(from);
        blade.to = now(to);
        blade.from -= 0.0003 * (blade.to - blade.from).normalized();
        const Vector3& rest = skin.rest_normals()[static_cast<std::size_t>(from)];
        const Matrix3& turn = frames[skin.rows()[static_cast<std::size_t>(from)].first_ring + 1].rotation;
        blade.normal = turn * Vector3(rest.y(), rest.z(), rest.x());
        blade.width = world.scene().bowel->blade_width;
        blade.depth = 0.003;
        blade.root = *skin.adjacency().triangles_of(from).begin();
        ++next;
        cut.forget_events();
        snapshot.event_count = 0;
        bench.ResumeTiming();
        benchmark::DoNotOptimize(cut.cut(blade, frames, 1, 1));
        if (bench.range(0) == 1) cut.fill_snapshot(snapshot);
    }
    bench.counters["rolled_back"] = static_cast<double>(cut.skin().surface().rolled_back());
    bench.counters["bytes"] = static_cast<double>(cut.bytes());
}

BENCHMARK(bowel_wall)->Arg(0)->Arg(1)->Iterations(400)->Unit(benchmark::kMicrosecond);
BENCHMARK(step)->Arg(10000)->Arg(30000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(pieces)->Arg(10000)->Arg(30000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(save)->Arg(10000)->Arg(100000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace fulcrum

BENCHMARK_MAIN();
