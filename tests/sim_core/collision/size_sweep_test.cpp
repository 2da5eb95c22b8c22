// SPDX-License-Identifier: Apache-2.0
// Work of collision against size, counted: it grows no faster than spheres, and no faster than triangles.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/lab/collision_run.h"

namespace fulcrum::lab {
namespace {

CollisionWork work_of(int spheres, int level) {
    CollisionRunOptions options;
    options.spheres = spheres;
    options.bowl_level = level;
    options.frames = 16;
    return measure_collision_work(*make_collision_run(options), 32);
}

double exponent(double small, double large, double times) {
    return std::log(large / small) / std::log(times);
}

TEST(CollisionSize, WorkGrowsNoFasterThanSpheres) {
    // The bowl grows with the chain: triangles are as large at either size.
    const CollisionWork small = work_of(50, 4), large = work_of(200, 5);
    EXPECT_LE(exponent(small.operations(), large.operations(), 4), 1.05)
        << small.operations() << " " << large.operations();
    EXPECT_GT(small.triangles, 25);
}

TEST(CollisionSize, WorkGrowsSlowerThanTriangles) {
    const CollisionWork small = work_of(100, 3), large = work_of(100, 5);
    EXPECT_LE(exponent(small.operations(), large.operations(), 16), 1.05);
}

}  // namespace
}  // namespace fulcrum::lab
