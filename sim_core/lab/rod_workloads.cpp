// SPDX-License-Identifier: Apache-2.0
// The rod's reference workloads (docs/FORMATS.md, lab bench): the cold cantilever and the warm frame.
#include <cmath>
#include <memory>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/elastica.h"
#include "sim_core/rod/rod.h"

namespace fulcrum::lab {
namespace {

/// qL^3/EI = 10 from straight, default settings; error: tip against the extensible elastica.
Workload::Prepared prepare_cold() {
    struct Clamped {
        std::unique_ptr<Rod> rod;
        RodState start, state;
        RodScratch scratch;
        RodInputs inputs;
        RodReport report;
        explicit Clamped(int segments) {
            RodSpec spec;
            spec.segments = segments;
            spec.length = 0.4;
            spec.outer_radius = 0.015;
            spec.inner_radius = 0;
            spec.ends[0] = RodEnd::clamped;
            spec.ends[1] = RodEnd::free;
            spec.linear_density = 1.0;
            rod = std::make_unique<Rod>(spec);
            const double load =
                10.0 * rod->bending_stiffness() / (spec.length * spec.length * spec.length);  // N/m
            inputs.gravity = Vector3(0, 0, -load / spec.linear_density);
            start = rod->make_state();
            state = start;
            inputs.ends[0] = start.ends[0];
            inputs.ends[1] = start.ends[1];
            scratch = rod->make_scratch(1, 1, 1, 1);
        }
        void solve() {
            state = start;
            report = rod->solve(state, inputs, scratch);
        }
    };
    auto bench = std::make_shared<Clamped>(96);
    Workload::Prepared prepared;
    prepared.step = [bench] { bench->solve(); };
    prepared.bytes = bench->rod->bytes() + bench->scratch.bytes();
    prepared.error = [bench] {
        Cantilever cantilever;
        cantilever.bending_stiffness = bench->rod->bending_stiffness();
        cantilever.axial_stiffness = bench->rod->axial_stiffness();
        cantilever.distributed = 10.0 * cantilever.bending_stiffness / (0.4 * 0.4 * 0.4);
        const CantileverTip tip = solve_cantilever(cantilever);
        const Vector3& last = bench->state.nodes.back();
        return std::optional<double>(std::hypot(last.x() - tip.x, last.z() - tip.z) / 0.4);
    };
    prepared.error_unit = "tip, L; against the extensible elastica";
    return prepared;
}

/// Both ends held, a grasped node moving to and fro at 50 mm/s, 5 ms frames.
Workload::Prepared prepare_warm(int segments) {
    struct Frame {
        std::unique_ptr<Rod> rod;
        RodState state;
        RodScratch scratch;
        RodInputs inputs;
        RodReport report;
        Vector3 home;
        double travelled = 0, direction = 1, worst = 0;
    };
    auto bench = std::make_shared<Frame>();
    RodSpec spec;
    spec.segments = segments;
    spec.length = 0.4;
    spec.outer_radius = 0.015;
    spec.inner_radius = 0;
    spec.ends[0] = spec.ends[1] = RodEnd::held;
    bench->rod = std::make_unique<Rod>(spec);
    bench->state = bench->rod->make_state();
    bench->inputs.gravity = Vector3(0, 0, -9.81);
    bench->inputs.ends[0] = bench->state.ends[0];
    bench->inputs.ends[1] = bench->state.ends[1];
    bench->scratch = bench->rod->make_scratch(1, 1, 1, 1);
    bench->rod->solve(bench->state, bench->inputs, bench->scratch);
    RodGrasp grasp;
    grasp.s = 0.5 * spec.length;
    grasp.target = bench->rod->wall_point(bench->state, grasp.s, grasp.offset);
    bench->home = grasp.target;
    bench->inputs.grasps.push_back(grasp);
    Workload::Prepared prepared;
    prepared.between = [bench] {
        bench->travelled += bench->direction * 0.05 * 0.005;
        if (std::abs(bench->travelled) > 0.03) bench->direction = -bench->direction;
        bench->inputs.grasps[0].target = bench->home + Vector3(0, 0.6, 0.8) * bench->travelled;
    };
    prepared.step = [bench] {
        bench->report = bench->rod->solve(bench->state, bench->inputs, bench->scratch);
        bench->worst = std::max(bench->worst, bench->report.residual);
    };
    prepared.bytes = bench->rod->bytes() + bench->scratch.bytes();
    prepared.error = [bench] { return std::optional<double>(bench->worst); };
    prepared.error_unit = "worst free residual over max(external, reactions)";
    return prepared;
}

}  // namespace

void add_rod_workloads(std::vector<Workload>& workloads) {
    Workload cold;
    cold.name = "rod_cold";
    cold.budget_mg = 40;
    cold.prepare = prepare_cold;
    workloads.push_back(cold);
    for (const int segments : {50, 128}) {
        Workload warm;
        warm.name = "rod_warm_" + std::to_string(segments);
        warm.budget_mg = segments == 50 ? 10 : 30;
        warm.samples = 1000;
        warm.prepare = [segments] { return prepare_warm(segments); };
        workloads.push_back(warm);
    }
}

}  // namespace fulcrum::lab
