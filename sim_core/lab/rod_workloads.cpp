// SPDX-License-Identifier: Apache-2.0
// The rod's reference workloads (docs/FORMATS.md, lab bench): the cold cantilever and the warm frame.
#include <algorithm>
#include <cmath>
#include <memory>

#include "sim_core/lab/bench.h"
#include "sim_core/lab/elastica.h"
#include "sim_core/lab/reference_rod.h"
#include "sim_core/lab/size_sweep.h"
#include "sim_core/rod/rod_system.h"

namespace fulcrum::lab {
namespace {

double work_of(const RodScratch& scratch) {
    const RodScratch::Data& data = scratch.data();
    return static_cast<double>(data.joint_evaluations + data.block_factors);
}

/// qL^3/EI = 10 from straight, default settings.
struct ColdRod : RestingRod {
    RodState start = state;
    RodReport report;
    explicit ColdRod(const RodSpec& spec) : RestingRod(spec) {
        const double length = spec.length;
        inputs.gravity.z() = -10 * rod.bending_stiffness() / (length * length * length) / spec.linear_density;
    }
    void move() {}
    void solve() {
        state = start;
        report = rod.solve(state, inputs, scratch);
    }
};

std::shared_ptr<ColdRod> cold_rod(int segments, MaterialLaw law) {
    RodSpec spec = cantilever_spec(segments);
    spec.law = law;
    return std::make_shared<ColdRod>(spec);
}

/// Error: tip against the extensible elastica.
Workload::Prepared prepare_cold() {
    const auto bench = cold_rod(96, MaterialLaw::linear);
    Workload::Prepared prepared;
    prepared.step = [bench] { bench->solve(); };
    prepared.bytes = bench->rod.bytes() + bench->scratch.bytes();
    prepared.error = [bench] {
        const double length = bench->rod.length();
        Cantilever cantilever;
        cantilever.bending_stiffness = bench->rod.bending_stiffness();
        cantilever.axial_stiffness = bench->rod.axial_stiffness();
        cantilever.distributed = 10.0 * cantilever.bending_stiffness / (length * length * length);
        const CantileverTip tip = solve_cantilever(cantilever);
        const Vector3& last = bench->state.nodes.back();
        return std::optional<double>(std::hypot(last.x() - tip.x, last.z() - tip.z) / length);
    };
    prepared.error_unit = "tip, L; against the extensible elastica";
    return prepared;
}

/// Both ends held, a grasped node moving back and forth at 50 mm/s, 5 ms frames.
struct WarmRod : RestingRod {
    RodReport report;
    Vector3 home = Vector3::Zero();
    double travelled = 0, direction = 1, worst = 0;
    explicit WarmRod(const RodSpec& spec) : RestingRod(spec) {
        inputs.gravity.z() = -9.81;
        rod.solve(state, inputs, scratch);
        home = grasp(0.5 * spec.length).target;
    }
    void move() {
        travelled += direction * 0.05 * 0.005;
        if (std::abs(travelled) > 0.03) direction = -direction;
        inputs.grasps[0].target = home + Vector3(0, 0.6, 0.8) * travelled;
    }
    void solve() {
        report = rod.solve(state, inputs, scratch);
        worst = std::max(worst, report.residual);
    }
};

std::shared_ptr<WarmRod> warm_rod(int segments, MaterialLaw law) {
    RodSpec spec = cantilever_spec(segments);
    spec.law = law;
    spec.ends[0] = spec.ends[1] = RodEnd::held;
    return std::make_shared<WarmRod>(spec);
}

Workload::Prepared prepare_warm(int segments) {
    const auto bench = warm_rod(segments, MaterialLaw::linear);
    Workload::Prepared prepared;
    prepared.between = [bench] { bench->move(); };
    prepared.step = [bench] { bench->solve(); };
    prepared.bytes = bench->rod.bytes() + bench->scratch.bytes();
    prepared.error = [bench] { return std::optional<double>(bench->worst); };
    prepared.error_unit = "worst free residual over max(external, reactions)";
    return prepared;
}

template <class Made>
void add_sweep(std::vector<SweepCase>& sweeps, const char* model, Made make) {
    SweepCase sweep;
    sweep.model = model;
    sweep.element = "segment";
    sweep.operation = "joints evaluated and rows of blocks factored";
    sweep.sizes = {16, 32, 64, 128, 256, 512, 1024};
    sweep.prepare = [make](int segments) {
        const auto bench = make(segments);
        SweepRun run;
        run.elements = segments;
        run.between = [bench] { bench->move(); };
        run.step = [bench] { bench->solve(); };
        run.operations = [bench] { return work_of(bench->scratch); };
        return run;
    };
    sweeps.push_back(sweep);
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

void add_rod_sweeps(std::vector<SweepCase>& sweeps) {
    for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::exp2}) {
        const bool linear = law == MaterialLaw::linear;
        add_sweep(sweeps, linear ? "rod, warm frame" : "rod of EXP2, warm frame",
                  [law](int segments) { return warm_rod(segments, law); });
        add_sweep(sweeps, linear ? "rod, cold" : "rod of EXP2, cold",
                  [law](int segments) { return cold_rod(segments, law); });
    }
}

}  // namespace fulcrum::lab
