// SPDX-License-Identifier: Apache-2.0
// Coherent pairs of spheres compared with brute force: which pairs, in what order, how deep; and edge cases.
#include "sim_core/collision/sphere_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

struct Chain {
    std::vector<double> arcs, radii;
};

Chain random_chain(Random& random, int count) {
    Chain chain;
    double arc = 0;
    for (int i = 0; i < count; ++i) {
        chain.arcs.push_back(arc += random.uniform(0.002, 0.010));
        chain.radii.push_back(random.uniform(0.008, 0.016));
    }
    return chain;
}

std::vector<SphereContact> brute(const Chain& chain, const std::vector<Vector3>& centres, double margin) {
    std::vector<SphereContact> pairs;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        for (std::size_t j = i + 1; j < centres.size(); ++j) {
            const double larger = std::max(chain.radii[i], chain.radii[j]);
            if (chain.arcs[j] - chain.arcs[i] < 3.141592653589793 * larger) continue;
            const double gap = (centres[i] - centres[j]).norm() - chain.radii[i] - chain.radii[j];
            if (!(gap < margin)) continue;
            SphereContact pair;
            pair.first = static_cast<std::int32_t>(i);
            pair.second = static_cast<std::int32_t>(j);
            pair.gap = gap;
            pairs.push_back(pair);
        }
    }
    return pairs;
}

TEST(SpherePairs, EqualBruteForceInTheSameOrderForAnyMotion) {
    Random random(8);
    int pairs = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const int count = 1 + static_cast<int>(random.uniform(0, 90));
        const Chain chain = random_chain(random, count);
        const double size = random.uniform(0.02, 0.2), pace = trial % 4 == 0 ? 0.01 : 0.0008;
        const SpherePairs model(chain.arcs, chain.radii, 3.141592653589793, 0.003, 0.001, 1024);
        SpherePairs::Lists lists = model.make_lists();
        std::vector<SphereContact> found(4096);
        std::vector<Vector3> centres(static_cast<std::size_t>(count)), velocities(centres);
        for (std::size_t i = 0; i < centres.size(); ++i) {
            for (int k = 0; k < 3; ++k) {
                centres[i][k] = random.uniform(-size, size);
                velocities[i][k] = random.uniform(-pace, pace);
            }
        }
        for (int step = 0; step < 15; ++step) {
            for (std::size_t i = 0; i < centres.size(); ++i) centres[i] += velocities[i];
            double deepest = -1, expected_deepest = 0;
            const int n = model.find(centres.data(), lists, found.data(), 4096, deepest);
            const std::vector<SphereContact> expected = brute(chain, centres, 0.001);
            ASSERT_EQ(n, static_cast<int>(expected.size()));
            for (std::size_t k = 0; k < expected.size(); ++k) {
                EXPECT_EQ(found[k].first, expected[k].first);
                EXPECT_EQ(found[k].second, expected[k].second);
                EXPECT_NEAR(found[k].gap, expected[k].gap, 1e-15);
                const auto a = static_cast<std::size_t>(found[k].first),
                           b = static_cast<std::size_t>(found[k].second);
                EXPECT_NEAR((centres[a] - centres[b]).normalized().dot(found[k].normal), 1.0, 1e-12);
                expected_deepest = std::max(expected_deepest, -expected[k].gap);
            }
            EXPECT_NEAR(deepest, expected_deepest, 1e-15);
            EXPECT_FALSE(lists.overflow);
            pairs += n;
        }
    }
    EXPECT_GT(pairs, 1000);
}

TEST(SpherePairs, SphereWithRestoredCentreIsFound) {
    const SpherePairs model({0.0, 1.0}, {0.01, 0.01}, 3.14, 0.003, 0.001, 16);
    SpherePairs::Lists lists = model.make_lists();
    SphereContact found[4];
    double deepest = 0;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Vector3 centres[2] = {Vector3(0, 0, 0), Vector3(nan, 0, 0)};
    EXPECT_EQ(model.find(centres, lists, found, 4, deepest), 0);
    centres[1] = Vector3(0.015, 0, 0);
    EXPECT_EQ(model.find(centres, lists, found, 4, deepest), 1);
    EXPECT_NEAR(deepest, 0.005, 1e-15);
    centres[1] = Vector3(std::numeric_limits<double>::infinity(), 0, 0);
    EXPECT_EQ(model.find(centres, lists, found, 4, deepest), 0);
    centres[1] = centres[0];  // coincident centres: the normal must still be a unit vector
    EXPECT_EQ(model.find(centres, lists, found, 4, deepest), 1);
    EXPECT_NEAR(found[0].normal.norm(), 1.0, 1e-15);
}

TEST(SpherePairs, RowOverflowIsReported) {
    const std::vector<double> arcs{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, radii(10, 0.01);
    const SpherePairs model(arcs, radii, 3.14, 0.003, 0.001, 2);
    SpherePairs::Lists lists = model.make_lists();
    SphereContact found[64];
    double deepest = 0;
    const std::vector<Vector3> centres(10, Vector3::Zero());
    EXPECT_GT(model.find(centres.data(), lists, found, 64, deepest), 0);
    EXPECT_TRUE(lists.overflow);
}

}  // namespace
}  // namespace fulcrum
