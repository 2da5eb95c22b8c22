// SPDX-License-Identifier: Apache-2.0
// The product's own bowel, with its folds and taeniae, in its cage.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/bowel/display_skin.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

TEST(AnatomySkin, BindsTheGeneratedBowel) {
    using Clock = std::chrono::steady_clock;
    for (const std::uint64_t seed : {1u, 2u}) {
        BowelParameters parameters;
        parameters.seed = seed;
        BowelShape shape = make_bowel(parameters, PelvisParameters{});
        const auto begin = Clock::now();
        const SphereChain spheres = sample_spheres(shape.length, 0.016, shape.radius);
        Cage cage = build_cage(shape.surface, shape.length, spheres);
        const auto caged = Clock::now();
        const BowelSkin skin(std::move(shape.surface), std::move(cage));
        const auto bound = Clock::now();
        const DisplaySkin display(skin);
        const auto end = Clock::now();
        const auto ms = [](Clock::duration d) {
            return std::chrono::duration<double, std::milli>(d).count();
        };
        std::printf(
            "seed %d: %d vertices, %d rings, clearance %.2f mm; cage %.0f ms, bind %.0f ms, display %.0f ms, "
            "%.1f MB\n",
            static_cast<int>(seed), skin.vertices(), skin.rings(), 1e3 * skin.cage().clearance,
            ms(caged - begin), ms(bound - caged), ms(end - bound), 1e-6 * static_cast<double>(skin.bytes()));
        EXPECT_GT(skin.cage().clearance, 0.0001);
        const auto rest = test::rest_frames(skin.cage());
        double worst = 0.0;
        for (std::size_t v = 0; v < skin.rows().size(); ++v) {
            worst = std::max(worst, (skin_vertex(skin.rows()[v], rest) - skin.rest().vertices[v]).norm());
        }
        EXPECT_LE(worst, 1e-10);
        const double volume = enclosed_volume(skin.rest().vertices, skin.rest().triangles);
        std::vector<Vector3> positions(static_cast<std::size_t>(skin.vertices()));
        const double gap = skin.cage().arc_lengths[2] - skin.cage().arc_lengths[1];
        skin_all(skin, test::bent_frames(skin.cage(), 0.048).data(), positions.data());
        const double bent = enclosed_volume(positions, skin.rest().triangles) / volume - 1.0;
        skin_all(skin, test::twisted_frames(skin.cage(), 10.0 * 3.14159265358979323846 / 180.0 / gap).data(),
                 positions.data());
        const double twisted = enclosed_volume(positions, skin.rest().triangles) / volume - 1.0;
        std::printf("  volume in a bend of 48 mm %.3f %%, at 10 degrees a ring gap %.3f %%\n", 100.0 * bent,
                    100.0 * twisted);
        EXPECT_LE(std::abs(bent), 0.02);
        EXPECT_LE(std::abs(twisted), 0.01);
    }
}

}  // namespace
}  // namespace fulcrum
