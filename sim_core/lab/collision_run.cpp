// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/collision_run.h"

#include <cmath>

#include "sim_core/lab/reference_cavity.h"

namespace fulcrum::lab {
namespace {

constexpr double a_frame = 0.050 * 0.005;  // m along the line
constexpr double pitch = 0.02625;          // m from turn to turn
constexpr double clearance = 0.0135;       // m from the coil to the smooth bowl

}  // namespace

std::unique_ptr<CollisionRun> make_collision_run(CollisionRunOptions options) {
    auto run = std::make_unique<CollisionRun>();
    constexpr double two_pi = 6.283185307179586;
    const double scale = std::sqrt(options.spheres / 200.0);
    const Vector3 half_axes = scale * Vector3(0.075, 0.0535, 0.0535);
    const double coil_radius = half_axes.y() - clearance;
    const double width = options.spheres * CollisionRun::spacing * pitch / (two_pi * coil_radius);
    SphereChainShape chain;
    for (int i = 0; i < options.spheres; ++i) {
        chain.arc_lengths.push_back(i * CollisionRun::spacing);
        chain.radii.push_back(CollisionRun::radius);
    }
    options.collision.pair_capacity = 32 * options.spheres;
    options.collision.near_row_capacity = 64 * options.spheres;
    const TriangleMesh bowl = make_bowl(half_axes, options.bowl_level, 0.02);
    if (options.with_cavity) run->cavity = std::make_unique<CavityModel>(bowl, FreeSide::behind);
    run->collision = std::make_unique<SphereCollision>(run->cavity.get(), chain, options.collision);
    run->lists = run->collision->make_lists();
    run->contacts = run->collision->make_contacts();
    run->depths.resize(static_cast<std::size_t>(options.spheres));

    const CavityModel wall(bowl, FreeSide::behind);
    options.collision.projection_iterations = 12;
    const SphereCollision settle(&wall, chain, options.collision);
    SphereCollision::Lists lists = settle.make_lists();
    SphereContacts contacts = settle.make_contacts();
    for (int k = 0; k < 2 * options.frames; ++k) {
        const int there = k < options.frames ? k : 2 * options.frames - k;
        const std::vector<Vector3> coiled =
            coil(options.spheres, CollisionRun::spacing, coil_radius, width, a_frame * there);
        settle.collide(coiled.data(), lists, contacts);
        run->centres.push_back(lists.projected);
    }
    return run;
}

}  // namespace fulcrum::lab
