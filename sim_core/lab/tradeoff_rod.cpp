// SPDX-License-Identifier: Apache-2.0
// Cost of each level of the rod and of its material, and the error against the reference (docs/THEORY.md,
// section 8).
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "sim_core/lab/elastica.h"
#include "sim_core/lab/reference_rod.h"
#include "sim_core/lab/tradeoff_rooms.h"

namespace fulcrum::lab {
namespace {

struct RodLevel {
    const char* family;
    RodSolve solve;
};

RodSolve solve_of(RodSolve::Level level, int iterations, double tolerance = 1e-6) {
    RodSolve solve;
    solve.level = level;
    solve.iterations = iterations;
    solve.tolerance = tolerance;
    return solve;
}

std::string with_segments(const char* family, int segments) {
    return std::string(family) + ", " + std::to_string(segments) + " segments";
}

TradeoffStudy cold() {
    TradeoffStudy study;
    study.model = "rod";
    study.reference =
        "extensible elastica by shooting: a clamped rod under a dead load qL^3/EI = 10, solved from straight";
    const RodLevel levels[] = {{"linearised", solve_of(RodSolve::Level::linearised, 1)},
                               {"linearised, 16 load steps", solve_of(RodSolve::Level::linearised, 16)},
                               {"newton_k, k = 4", solve_of(RodSolve::Level::newton_k, 4)},
                               {"newton_k, k = 8", solve_of(RodSolve::Level::newton_k, 8)},
                               {"newton", solve_of(RodSolve::Level::newton, 0)}};
    for (const RodLevel& level : levels) {
        for (const int segments : {16, 32, 64, 128, 256}) {
            const Rod rod(cantilever_spec(segments));
            Cantilever reference;
            reference.length = rod.length();
            reference.bending_stiffness = rod.bending_stiffness();
            reference.axial_stiffness = rod.axial_stiffness();
            reference.distributed = 10 * rod.bending_stiffness() / std::pow(rod.length(), 3);
            static const CantileverTip tip = solve_cantilever(reference, 2000);
            const RodState start = rod.make_state();
            RodState state = start;
            RodScratch scratch = rod.make_scratch(1, 1, 1, 1);
            RodInputs inputs;
            inputs.ends[0] = start.ends[0];
            inputs.ends[1] = start.ends[1];
            const Vector3 gravity(0, 0, -reference.distributed / rod.spec().linear_density);
            RodSolve one = level.solve;
            const int parts = one.level == RodSolve::Level::linearised ? one.iterations : 1;
            if (one.level == RodSolve::Level::linearised) one.iterations = 1;
            const auto step = [&] {
                for (int part = 1; part <= parts; ++part) {
                    inputs.gravity = gravity * part / parts;
                    rod.solve(state, inputs, scratch, one);
                }
            };
            TradeoffLevel row;
            row.family = level.family;
            row.level = with_segments(level.family, segments);
            row.time_us = median_time_us(5, 41, step, [&] { state = start; });
            row.error =
                std::hypot(state.nodes.back().x() - tip.x, state.nodes.back().z() - tip.z) / rod.length();
            row.error_unit = "distance of the tip / L";
            study.levels.push_back(row);
        }
    }
    return study;
}

// A bowel held at both ends, its middle moved around at 50 mm/s for a second in frames of 5 ms: shape at the
// end of each tenth of a second.
struct Frames {
    std::vector<Vector3> points;
    double time_us = 0;
};
Frames led_around(int segments, const RodSolve& solve, bool timed) {
    RodSpec spec;
    spec.segments = segments;
    spec.length = 0.9;
    spec.ends[0] = spec.ends[1] = RodEnd::clamped;
    const Rod rod(spec);
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch(1, 1, 1, 1);
    RodInputs inputs;
    inputs.gravity = Vector3(0, 0, -9.81);
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    inputs.ends[1].position.x() -= 0.1;
    // All levels start from the same converged shape.
    for (int i = 1; i <= 20; ++i) {
        inputs.ends[1].position.x() = 0.9 - 0.005 * i;
        rod.solve(state, inputs, scratch);
    }
    RodGrasp grasp;
    grasp.s = 0.41;
    grasp.offset = Vector3(0.015, 0, 0);
    grasp.target = rod.wall_point(state, grasp.s, grasp.offset);
    inputs.grasps.push_back(grasp);
    Frames frames;
    int frame = 0;
    const auto lead = [&] {
        const double angle = 0.6 * frame * 0.005 * 2 * 3.14159265358979323846;
        inputs.grasps[0].target += 0.05 * 0.005 * Vector3(0.3, std::sin(angle), std::cos(angle));
        ++frame;
    };
    constexpr int count = 200;
    const auto step = [&] {
        rod.step(state, inputs, 0.005, scratch, solve);
        if (frame % 20 != 0) return;
        for (int k = 1; k < 18; ++k) frames.points.push_back(rod.frame_at(state, 0.05 * k).frame.position);
    };
    if (timed) {
        frames.points.reserve(10 * 17);
        frames.time_us = median_time_us(0, count, step, lead);
    } else {
        for (int i = 0; i < count; ++i) {
            lead();
            step();
        }
    }
    return frames;
}

TradeoffStudy warm() {
    TradeoffStudy study;
    study.model = "rod_frame";
    study.reference =
        "the same motion with 4 times finer a rod (1024 segments), newton to 1e-9: a bowel of 0.9 m held at "
        "both ends, its middle led around at 50 mm/s in frames of 5 ms";
    const std::vector<Vector3> exact =
        led_around(1024, solve_of(RodSolve::Level::newton, 0, 1e-9), false).points;
    const RodLevel levels[] = {{"linearised", solve_of(RodSolve::Level::linearised, 1)},
                               {"newton_k, k = 2", solve_of(RodSolve::Level::newton_k, 2)},
                               {"newton_k, k = 8", solve_of(RodSolve::Level::newton_k, 8)},
                               {"newton", solve_of(RodSolve::Level::newton, 0)}};
    for (const RodLevel& level : levels) {
        for (const int segments : {16, 32, 64, 128, 256}) {
            const Frames frames = led_around(segments, level.solve, true);
            TradeoffLevel row;
            row.family = level.family;
            row.level = with_segments(level.family, segments);
            row.time_us = frames.time_us;
            for (std::size_t i = 0; i < exact.size(); ++i)
                row.error = std::max(row.error, (frames.points[i] - exact[i]).norm());
            row.error_unit = "m, worst point of the line in a second";
            study.levels.push_back(row);
        }
    }
    return study;
}

TradeoffStudy material() {
    TradeoffStudy study;
    study.model = "material";
    study.reference =
        "EXP2 on a 4 times finer rod (512 segments): a hollow bowel of 0.3 m, clamped, pulled by 1.6 N along "
        "and 0.1 N across its tip (about 20 % stretch)";
    const auto spec_of = [](int segments, MaterialLaw law) {
        RodSpec spec;
        spec.segments = segments;
        spec.length = 0.3;
        spec.ends[0] = RodEnd::clamped;
        spec.law = law;
        // The best line on strains of 0 to 0.20 for EXP2 with 30.0 kPa at rest (docs/THEORY.md, section 1.1).
        spec.young_modulus = law == MaterialLaw::linear ? 32.3e3 : 30.0e3;
        return spec;
    };
    const auto run = [&](int segments, MaterialLaw law, double* time) {
        const Rod rod(spec_of(segments, law));
        const RodState start = rod.make_state();
        RodState state = start;
        RodScratch scratch = rod.make_scratch(1, 1, 1, 1);
        RodInputs inputs;
        inputs.ends[0] = start.ends[0];
        inputs.ends[1] = start.ends[1];
        inputs.nodal_forces.assign(static_cast<std::size_t>(segments) + 1, Vector3::Zero());
        inputs.nodal_forces.back() = Vector3(1.6, 0, -0.1);
        const auto step = [&] { rod.solve(state, inputs, scratch); };
        if (time != nullptr)
            *time = median_time_us(3, 21, step, [&] { state = start; });
        else
            step();
        return Vector3(state.nodes.back());
    };
    const Vector3 exact = run(512, MaterialLaw::exp2, nullptr);
    for (const MaterialLaw law : {MaterialLaw::linear, MaterialLaw::exp2}) {
        for (const int segments : {16, 32, 64, 128}) {
            TradeoffLevel row;
            row.family = law == MaterialLaw::linear ? "linear" : "EXP2";
            row.level = with_segments(row.family.c_str(), segments);
            row.error = (run(segments, law, &row.time_us) - exact).norm() / 0.3;
            row.error_unit = "distance of the tip / L";
            study.levels.push_back(row);
        }
    }
    return study;
}

}  // namespace

std::vector<TradeoffStudy> rod_tradeoff() {
    return {cold(), warm(), material()};
}

}  // namespace fulcrum::lab
