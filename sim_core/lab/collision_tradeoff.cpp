// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/collision_tradeoff.h"

#include <algorithm>
#include <string>

#include "sim_core/lab/collision_run.h"
#include "sim_core/numerics/random.h"

namespace fulcrum::lab {
namespace {

constexpr double push = 0.001;  // m

TradeoffLevel measure(const std::string& family, double margin, int iterations) {
    CollisionRunOptions options;
    options.frames = 20;
    options.collision.list_margin = margin;
    options.collision.projection_iterations = iterations;
    const auto run = make_collision_run(options);
    Random random(7);
    // Each sphere gets the same push at every level and in every frame, so that coherence is not disturbed.
    std::vector<Vector3> pushes(run->depths.size());
    for (Vector3& offset : pushes) {
        for (int k = 0; k < 3; ++k) offset[k] = random.uniform(-push, push);
    }
    std::vector<Vector3> pushed(pushes.size());
    double sum = 0;
    int frames = 0;
    TradeoffLevel level;
    level.level =
        family + ", " + std::to_string(iterations) + (iterations == 1 ? " projection" : " projections");
    level.family = family;
    level.error_unit = "m, deepest overlap left, mean over frames";
    level.time_us = median_time_us(
        10, 60, [&] { run->collision->collide(pushed.data(), run->lists, run->contacts); },
        [&] {
            if (frames++ > 0) sum += std::max(run->contacts.residual_cavity, run->contacts.residual_pair);
            run->advance();
            for (std::size_t i = 0; i < pushed.size(); ++i) pushed[i] = run->now()[i] + pushes[i];
        });
    level.error = sum / (frames - 1);
    return level;
}

}  // namespace

std::vector<TradeoffStudy> collision_tradeoff() {
    TradeoffStudy study;
    study.model = "collision";
    study.reference =
        "no overlap at all: 200 spheres on the wall of 20,480 triangles and on each other, each pushed by up "
        "to 1 mm; "
        "closest points are exact at every level";
    const struct {
        const char* family;
        double margin;
    } lists[] = {{"coherent", 0.003},
                 {"coherent, margin 1 mm", 0.001},
                 {"coherent, margin 6 mm", 0.006},
                 {"brute", 0.0}};
    for (const auto& list : lists) {
        for (const int iterations : {1, 2, 3, 4, 8, 16}) {
            // The margin affects time only: its other values are measured at the standard number of
            // projections.
            const bool named = std::string(list.family) == "coherent" || std::string(list.family) == "brute";
            if (!named && iterations != 3) continue;
            study.levels.push_back(measure(list.family, list.margin, iterations));
        }
    }
    return {study};
}

}  // namespace fulcrum::lab
