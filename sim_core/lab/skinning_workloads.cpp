// SPDX-License-Identifier: Apache-2.0
// Reference workloads skin_20k and skin_50k: the whole display surface from one set of ring frames
// (docs/QUALITY.md).
#include <algorithm>
#include <cmath>
#include <memory>

#include "sim_core/bowel/display_skin.h"
#include "sim_core/lab/bench.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/lab/size_sweep.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {

constexpr double length = 0.9, mean_radius = 0.016, spacing = 0.016;

struct SkinningRun {
    std::unique_ptr<BowelSkin> skin;
    std::unique_ptr<DisplaySkin> display;
    std::vector<RingFrame> frames;
    std::vector<float> ring_floats, positions, normals;
};

// A quarter turn over the whole length plus a twist, so that no ring keeps its rest frame.
RingFrame deformed_frame(double s) {
    const double bend_radius = 2.0 * length / 3.14159265358979323846;
    double sine = 0.0, cosine = 1.0, twist_sine = 0.0, twist_cosine = 1.0;
    math::sin_cos(s / bend_radius, sine, cosine);
    math::sin_cos(2.0 * s, twist_sine, twist_cosine);
    const Vector3 normal(-sine, cosine, 0.0), binormal(0.0, 0.0, 1.0);
    RingFrame frame;
    frame.position = Vector3(bend_radius * sine, bend_radius * (1.0 - cosine), 0.0);
    frame.rotation.col(0) = twist_cosine * normal + twist_sine * binormal;
    frame.rotation.col(1) = -twist_sine * normal + twist_cosine * binormal;
    frame.rotation.col(2) = Vector3(cosine, sine, 0.0);
    return frame;
}

std::shared_ptr<SkinningRun> build(int vertices) {
    auto run = std::make_shared<SkinningRun>();
    // Near-equilateral triangles: sections and circle in the ratio of length to circumference.
    const double around = std::sqrt(vertices * 2.0 * 3.14159265358979323846 * mean_radius / length);
    const int circle = static_cast<int>(std::lround(around));
    const int sections = vertices / circle - 1;
    TriangleMesh mesh = make_tube(length, sections, circle, haustral_radius(mean_radius));
    const SphereChain spheres = sample_spheres(length, spacing, [](double) { return mean_radius; });
    Cage cage = build_cage(mesh, length, spheres);
    run->skin = std::make_unique<BowelSkin>(std::move(mesh), std::move(cage));
    run->display = std::make_unique<DisplaySkin>(*run->skin);
    run->frames.resize(static_cast<std::size_t>(run->skin->rings()));
    ring_frames(run->skin->cage(), deformed_frame, run->frames.data());
    run->ring_floats.resize(12 * run->frames.size());
    run->positions.resize(3 * static_cast<std::size_t>(run->skin->vertices()));
    run->normals.resize(run->positions.size());
    return run;
}

// Largest distance from the double path, m.
double worst_error(const SkinningRun& run) {
    std::vector<Vector3> exact(static_cast<std::size_t>(run.skin->vertices()));
    skin_all(*run.skin, run.frames.data(), exact.data());
    double worst = 0.0;
    for (std::size_t v = 0; v < exact.size(); ++v) {
        const Vector3 drawn(run.positions[3 * v], run.positions[3 * v + 1], run.positions[3 * v + 2]);
        worst = std::max(worst, (drawn - exact[v]).norm());
    }
    return worst;
}

Workload skinning(const char* name, int vertices, double budget_mg, bool with_normals) {
    Workload workload;
    workload.name = name;
    workload.budget_mg = budget_mg;
    workload.prepare = [vertices, with_normals] {
        const std::shared_ptr<SkinningRun> run = build(vertices);
        Workload::Prepared prepared;
        prepared.step = [run, with_normals] {
            run->display->evaluate(run->frames.data(), run->ring_floats.data(), run->positions.data(),
                                   with_normals ? run->normals.data() : nullptr);
        };
        prepared.error = [run]() -> std::optional<double> { return worst_error(*run); };
        prepared.error_unit = "m from the double path";
        prepared.bytes = run->display->bytes();
        return prepared;
    };
    return workload;
}

}  // namespace

void add_skinning_workloads(std::vector<Workload>& workloads) {
    workloads.push_back(skinning("skin_20k", 20000, 25.0, false));
    workloads.push_back(skinning("skin_50k", 50000, 60.0, false));
    workloads.push_back(skinning("skin_20k_with_normals", 20000, 50.0, true));
    workloads.push_back(skinning("skin_50k_with_normals", 50000, 120.0, true));
}

void add_skinning_sweeps(std::vector<SweepCase>& sweeps) {
    SweepCase sweep;
    sweep.model = "surface, skinning";
    sweep.element = "vertex";
    sweep.operation = "bytes of weights read";
    sweep.sizes = {2000, 6300, 20000, 63000, 200000};
    sweep.prepare = [](int vertices) {
        const std::shared_ptr<SkinningRun> skinned = build(vertices);
        const auto calls = std::make_shared<double>(0);
        SweepRun run;
        run.elements = skinned->skin->vertices();
        run.step = [skinned, calls] {
            skinned->display->evaluate(skinned->frames.data(), skinned->ring_floats.data(),
                                       skinned->positions.data(), nullptr);
            ++*calls;
        };
        run.operations = [skinned, calls] { return *calls * static_cast<double>(skinned->display->bytes()); };
        return run;
    };
    sweep.warm_up = sweep.counted = 2;
    sweeps.push_back(sweep);
}

}  // namespace fulcrum::lab
