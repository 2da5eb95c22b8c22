// SPDX-License-Identifier: Apache-2.0
// Reference workloads spheres_cavity and spheres_self (quality.md): 200 spheres in a cavity of 20,480
// triangles.
//
// The spheres are a bowel of 0.9 m and 12.5 mm radius, coiled in 3.6 turns that lie on each other and on the
// wall (191 of the 200 are within 1 mm of it, most touch it: nothing is won by being far). It is drawn along
// its line at 50 mm/s and back: a step of 5 ms moves a sphere by 0.22 to 0.25 mm (p10 to p50; 0.31 mm p99),
// which is the hand's own speed in the rod's warm frame. Every recorded place is first brought out of wall
// and neighbours. spheres_cavity asks for closest point and depth of each sphere, spheres_self for every
// touching pair with normal and depth, both without projection; spheres_project is all of it with projection
// and residual, as a world step calls it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "sim_core/collision/sphere_collision.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/lab/bench.h"
#include "sim_core/lab/reference_cavity.h"

namespace fulcrum::lab {
namespace {

constexpr int spheres = 200, recorded_steps = 60;
constexpr double spacing = 0.0045, radius = 0.0125, a_step = 0.050 * 0.005;

struct CollisionRun {
    std::unique_ptr<CavityModel> cavity;
    std::unique_ptr<SphereCollision> collision;
    SphereCollision::Lists lists;
    SphereContacts contacts;
    std::vector<SphereDepth> depths;
    std::vector<std::vector<Vector3>> centres;  ///< of each recorded step, to and fro
    std::size_t step = 0;

    const std::vector<Vector3>& now() const { return centres[step]; }
    void advance() { step = (step + 1) % centres.size(); }
};

std::shared_ptr<CollisionRun> build(bool with_cavity) {
    auto run = std::make_shared<CollisionRun>();
    SphereChainShape chain;
    for (int i = 0; i < spheres; ++i) {
        chain.arc_lengths.push_back(i * spacing);
        chain.radii.push_back(radius);
    }
    SphereCollisionOptions options;
    options.pair_capacity = 4096;
    options.near_row_capacity = 8192;
    if (with_cavity)
        run->cavity =
            std::make_unique<CavityModel>(make_bowl({0.075, 0.0535, 0.0535}, 5, 0.02), FreeSide::behind);
    run->collision = std::make_unique<SphereCollision>(run->cavity.get(), chain, options);
    run->lists = run->collision->make_lists();
    run->contacts = run->collision->make_contacts();
    run->depths.resize(spheres);
    for (int k = 0; k < 2 * recorded_steps; ++k) {
        const int there = k < recorded_steps ? k : 2 * recorded_steps - k;
        run->centres.push_back(coil(spheres, spacing, 0.040, 0.094, a_step * there));
    }
    // Bowels lie on the wall and on each other: every recorded place is brought out of them first.
    const CavityModel wall(make_bowl({0.075, 0.0535, 0.0535}, 5, 0.02), FreeSide::behind);
    options.projection_iterations = 12;
    const SphereCollision settle(&wall, chain, options);
    SphereCollision::Lists lists = settle.make_lists();
    SphereContacts contacts = settle.make_contacts();
    for (auto& centres : run->centres) {
        settle.collide(centres.data(), lists, contacts);
        centres = lists.projected;
    }
    return run;
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
            const double exact = radius - std::sqrt(nearest2);
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
        for (int i = 0; i < spheres; ++i) {
            for (int j = i + 1; j < spheres; ++j) {
                if ((j - i) * spacing < options.rest_exclusion * radius) continue;
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

}  // namespace fulcrum::lab
