// SPDX-License-Identifier: Apache-2.0
// The rod's reference workloads, and warm frames of the dynamic level.
#include <cmath>

#include "sim_core/rod/rod.h"
#include "tests/benchmarks/workloads.h"

namespace fulcrum {
namespace {

// A bowed bowel, both ends clamped, its middle carried around at 50 mm/s.
void warm(benchmark::State& bench, int contacts, int tethers) {
    RodSpec spec;
    spec.segments = static_cast<int>(bench.range(0));
    spec.length = 0.9;
    spec.ends[0] = spec.ends[1] = RodEnd::clamped;
    for (int i = 0; i <= spec.segments; ++i) {
        const double u = static_cast<double>(i) / spec.segments;
        spec.rest_nodes.emplace_back(0.25 * std::cos(3.0 * u), 0.25 * std::sin(3.0 * u),
                                     0.02 * std::sin(6 * u));
    }
    const Rod rod(spec);
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs inputs;
    inputs.gravity = Vector3(0, 0, -9.81);
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    for (int i = 0; i < tethers; ++i) {
        RodTether tether;
        tether.s = rod.length() * (0.1 + 0.8 * i / tethers);
        const Vector3 p = rod.wall_point(state, tether.s, tether.offset);
        tether.anchor = 0.3 * p + Vector3(0, 0, 0.05);
        tether.rest_length = 1.15 * (p - tether.anchor).norm();
        tether.stiffness = 15;
        tether.damping = 0.2;
        inputs.tethers.push_back(tether);
    }
    for (int i = 0; i < contacts; ++i) {
        RodContact contact;
        contact.s = rod.length() * (i + 0.5) / contacts;
        contact.point = Vector3(0, 0, -0.06);
        contact.radius = 0.015;
        contact.friction = 0.3;
        inputs.contacts.push_back(contact);
    }
    for (int i = 0; i < 300; ++i) rod.step(state, inputs, 0.005, scratch);
    RodGrasp grasp;
    grasp.s = 0.5 * rod.length();
    grasp.target = rod.wall_point(state, grasp.s, grasp.offset);
    inputs.grasps.push_back(grasp);
    int frame = 0, iterations = 0, unconverged = 0;
    for (auto _ : bench) {
        const double angle = 0.02 * frame++;
        inputs.grasps[0].target += Vector3(0, -std::sin(angle), std::cos(angle)) * 0.00025;
        const RodReport report = rod.step(state, inputs, 0.005, scratch);
        iterations += report.iterations;
        unconverged += !report.converged;
    }
    bench.counters["iterations"] = static_cast<double>(iterations) / frame;
    bench.counters["unconverged"] = unconverged;
}

void warm_dynamic(benchmark::State& bench) {
    warm(bench, 0, 0);
}
void scene_b1(benchmark::State& bench) {
    warm(bench, 60, 24);
}
BENCHMARK(warm_dynamic)->Arg(50)->Arg(128)->Unit(benchmark::kMicrosecond);
BENCHMARK(scene_b1)->Arg(64)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace fulcrum

int main(int argc, char** argv) {
    std::vector<fulcrum::lab::Workload> workloads;
    fulcrum::lab::add_rod_workloads(workloads);
    return fulcrum::run_benchmarks(argc, argv, workloads);
}
