// SPDX-License-Identifier: Apache-2.0
// Reference workloads spheres_cavity and spheres_self (docs/QUALITY.md) on the reference chain of
// collision_run.h: 200 spheres that touch the wall of 20,480 triangles and each other, moved by 0.25 mm per
// frame. spheres_cavity computes closest point and depth of each sphere, spheres_self every touching pair
// with normal and depth, both without projection; spheres_project does all of it with projection and
// residual, as in a world step.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/lab/bench.h"
#include "sim_core/lab/collision_run.h"
#include "sim_core/lab/size_sweep.h"

namespace fulcrum::lab {
namespace {

std::shared_ptr<CollisionRun> build(bool with_cavity) {
    CollisionRunOptions options;
    options.with_cavity = with_cavity;
    return make_collision_run(options);
}

// Largest difference of a depth from brute force over all triangles, over a few steps.
double worst_depth(CollisionRun& run) {
    const CavityModel& cavity = *run.cavity;
    double worst = 0;
    for (int k = 0; k < 4; ++k) {
        for (int skip = 0; skip < 7; ++skip) run.advance();
        run.collision->depths(run.now().data(), run.lists, run.depths.data());
        for (std::size_t i = 0; i < run.depths.size(); ++i) {
            double nearest2 = std::numeric_limits<double>::infinity();
            for (const CavityTriangle& t : cavity.triangles()) {
                const Vector3 foot = closest_point_on_triangle(run.now()[i], t.a, t.b, t.c).position;
                nearest2 = std::min(nearest2, (run.now()[i] - foot).squaredNorm());
            }
            const double exact = CollisionRun::radius - std::sqrt(nearest2);
            if (exact < -run.collision->options().contact_margin) continue;  // apart: no depth was asked for
            worst = std::max(worst, std::abs(run.depths[i].depth - exact));
        }
    }
    return worst;
}

// Difference of the deepest overlap of a pair from brute force over all pairs; infinity if their number
// differs.
double worst_pair_depth(CollisionRun& run) {
    const SphereCollisionOptions& options = run.collision->options();
    double worst = 0;
    for (int k = 0; k < 4; ++k) {
        for (int skip = 0; skip < 7; ++skip) run.advance();
        run.collision->touching_pairs(run.now().data(), run.lists, run.contacts);
        double deepest = 0;
        int count = 0;
        const int spheres = run.collision->spheres();
        const double radius = CollisionRun::radius;
        for (int i = 0; i < spheres; ++i) {
            for (int j = i + 1; j < spheres; ++j) {
                if ((j - i) * CollisionRun::spacing < options.rest_exclusion * radius) continue;
                const double distance =
                    (run.now()[static_cast<std::size_t>(i)] - run.now()[static_cast<std::size_t>(j)]).norm();
                if (distance < 2 * radius + options.contact_margin) ++count;
                deepest = std::max(deepest, 2 * radius - distance);
            }
        }
        if (count != run.contacts.pair_count) return std::numeric_limits<double>::infinity();
        worst = std::max(worst, std::abs(deepest - run.contacts.deepest_pair));
    }
    return worst;
}

/// Closest points and pairs of one frame.
SweepRun prepare_sweep(int spheres, int level) {
    CollisionRunOptions options;
    options.spheres = spheres;
    options.bowl_level = level;
    options.frames = 30;
    const std::shared_ptr<CollisionRun> run = make_collision_run(options);
    SweepRun sweep;
    sweep.between = [run] { run->advance(); };
    sweep.step = [run] {
        run->collision->depths(run->now().data(), run->lists, run->depths.data());
        run->collision->touching_pairs(run->now().data(), run->lists, run->contacts);
    };
    sweep.operations = [run] {
        const CollisionCounts& counts = run->lists.counts_so_far;
        return static_cast<double>(counts.packets + counts.triangles + counts.listed +
                                   run->lists.pairs.rows_seen);
    };
    return sweep;
}

}  // namespace

void add_collision_workloads(std::vector<Workload>& workloads) {
    Workload cavity;
    cavity.name = "spheres_cavity";
    cavity.budget_mg = 25;
    cavity.prepare = [] {
        const auto run = build(true);
        Workload::Prepared prepared;
        prepared.between = [run] { run->advance(); };
        prepared.step = [run] { run->collision->depths(run->now().data(), run->lists, run->depths.data()); };
        prepared.error = [run]() -> std::optional<double> { return worst_depth(*run); };
        prepared.error_unit = "m from brute force";
        prepared.bytes = run->collision->bytes() + run->cavity->bytes();
        return prepared;
    };
    workloads.push_back(cavity);

    Workload self;
    self.name = "spheres_self";
    self.budget_mg = 2;
    self.prepare = [] {
        const auto run = build(false);
        Workload::Prepared prepared;
        prepared.between = [run] { run->advance(); };
        prepared.step = [run] {
            run->collision->touching_pairs(run->now().data(), run->lists, run->contacts);
        };
        prepared.error = [run]() -> std::optional<double> { return worst_pair_depth(*run); };
        prepared.error_unit = "m from brute force";
        prepared.bytes = run->collision->bytes();
        return prepared;
    };
    workloads.push_back(self);

    Workload project;
    project.name = "spheres_project";  // contacts, projection and residual together: what a world step calls
    project.budget_mg = 0;
    project.prepare = [] {
        const auto run = build(true);
        Workload::Prepared prepared;
        prepared.between = [run] { run->advance(); };
        prepared.step = [run] { run->collision->collide(run->now().data(), run->lists, run->contacts); };
        prepared.error = [run]() -> std::optional<double> {
            return std::max(run->contacts.residual_cavity, run->contacts.residual_pair);
        };
        prepared.error_unit = "m left after projection";
        prepared.bytes = run->collision->bytes() + run->cavity->bytes();
        return prepared;
    };
    workloads.push_back(project);
}

void add_collision_sweeps(std::vector<SweepCase>& sweeps) {
    SweepCase spheres;
    spheres.model = "collision, the bowl growing with the chain";
    spheres.element = "sphere";
    spheres.operation =
        "packets of eight triangles looked at or listed, triangles measured, rows of eight spheres";
    spheres.sizes = {50, 200, 800};
    spheres.prepare = [](int count) {
        SweepRun run = prepare_sweep(count, count < 100 ? 4 : (count < 400 ? 5 : 6));
        run.elements = count;
        return run;
    };
    spheres.warm_up = 12;
    spheres.counted = 60;
    sweeps.push_back(spheres);
    SweepCase triangles = spheres;
    triangles.model = "collision of 200 spheres, the bowl ever finer";
    triangles.element = "triangle";
    triangles.sizes = {1280, 5120, 20480, 81920, 327680};
    triangles.prepare = [](int count) {
        int level = 0;
        for (int n = 20; n < count; n *= 4) ++level;
        SweepRun run = prepare_sweep(200, level);
        run.elements = count;
        return run;
    };
    sweeps.push_back(triangles);
}

}  // namespace fulcrum::lab
