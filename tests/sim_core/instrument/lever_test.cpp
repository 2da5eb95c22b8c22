// SPDX-License-Identifier: Apache-2.0
// The lever at the trocar against finite differences of virtual work.
#include "sim_core/instrument/lever.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <vector>

namespace fulcrum {
namespace {

using Long = Eigen::Matrix<long double, 3, 1>;

struct PointLoad {
    Vector3 arm, force;
};

Vector3 any_vector(double size) {
    const auto component = [&] {
        return size * (*rc::gen::resize(100, rc::gen::inRange(-1000000, 1000001))) * 1e-6;
    };
    const double x = component(), y = component(), z = component();
    return {x, y, z};
}

Vector3 any_handle() {
    const Vector3 direction = any_vector(1);
    RC_PRE(direction.norm() > 0.1);
    const double length = 0.01 + 0.3 * (*rc::gen::resize(100, rc::gen::inRange(0, 1000001))) * 1e-6;
    return length * direction.normalized();
}

std::vector<PointLoad> any_loads() {
    std::vector<PointLoad> loads;
    const int count = *rc::gen::inRange(1, 6);
    for (int i = 0; i < count; ++i) loads.push_back({any_vector(0.3), any_vector(10)});
    return loads;
}

ToolLoad sum_of(const std::vector<PointLoad>& loads) {
    ToolLoad sum;
    for (const PointLoad& load : loads) sum.add(load.arm, load.force);
    return sum;
}

// The place of a point of the instrument after its handle went from `from` to `to`: turned about the trocar
// by the smallest rotation between the two directions, then moved along the shaft.
Long carried(const Long& from, const Long& to, const Long& arm) {
    const Long u = from / from.norm(), w = to / to.norm();
    const Long axis = u.cross(w);
    const Long turned = arm + axis.cross(arm) + axis.cross(axis.cross(arm)) / (1 + u.dot(w));
    return turned + (to.norm() - from.norm()) * w;
}

long double work(const std::vector<PointLoad>& loads, const Vector3& handle, const Long& step) {
    const Long from = handle.cast<long double>();
    long double sum = 0;
    for (const PointLoad& load : loads) {
        const Long arm = load.arm.cast<long double>();
        sum += load.force.cast<long double>().dot(carried(from, from + step, arm) - arm);
    }
    return sum;
}

RC_GTEST_PROP(Lever, ForceAtTheHandIsTheGradientOfVirtualWork, ()) {
    const Vector3 handle = any_handle();
    const std::vector<PointLoad> loads = any_loads();
    const Vector3 force = load_at_hand(handle, sum_of(loads)).force;
    const long double h = 1e-7L;
    for (int i = 0; i < 3; ++i) {
        const Long step = h * Long::Unit(i);
        const long double slope = (work(loads, handle, step) - work(loads, handle, -step)) / (2 * h);
        RC_ASSERT(std::abs(static_cast<double>(slope) - force[i]) <= 1e-8 * std::max(1.0, force.norm()));
    }
}

RC_GTEST_PROP(Lever, TorqueIsTheWorkOfATurnAboutTheShaft, ()) {
    const Vector3 handle = any_handle();
    const std::vector<PointLoad> loads = any_loads();
    const Vector3 axis = -handle.normalized();
    double power = 0;
    for (const PointLoad& load : loads) power += load.force.dot(axis.cross(load.arm));
    RC_ASSERT(std::abs(load_at_hand(handle, sum_of(loads)).torque - power) <= 1e-12 * (1 + std::abs(power)));
}

RC_GTEST_PROP(Lever, MatrixIsTheChangeOfForceWhenSpringsFollowTheInstrument, ()) {
    const Vector3 handle = any_handle();
    const std::vector<PointLoad> loads = any_loads();
    ToolMatrix matrix;
    std::vector<Matrix3> springs;
    for (const PointLoad& load : loads) {
        const Vector3 n = load.force;  // any symmetric matrix
        springs.emplace_back(n * n.transpose() + Matrix3::Identity());
        matrix.add(springs.back(), load.arm);
    }
    const Vector3 motion = any_vector(1);
    // Springs at rest: the force after a small motion is -K times it, and the lever's own change does not
    // count.
    std::vector<PointLoad> answer = loads;
    const Vector3 u = handle.normalized();
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const Vector3 moved = u * u.dot(motion) + u.cross(motion).cross(loads[i].arm) / handle.norm();
        answer[i].force = springs[i] * moved;
    }
    const Vector3 expected = load_at_hand(handle, sum_of(answer)).force;
    const Vector3 found = matrix.at_hand(handle) * motion;
    RC_ASSERT((found - expected).norm() <= 1e-11 * (1 + expected.norm()));
}

TEST(Lever, MirrorsWhatActsAcrossTheTipAndKeepsWhatActsAlongIt) {
    const Vector3 handle(0, 0, 0.08);
    ToolLoad load;
    load.add(Vector3(0, 0, -0.24), Vector3(2, 0, 5));
    const HandLoad felt = load_at_hand(handle, load);
    EXPECT_NEAR((felt.force - Vector3(-6, 0, 5)).norm(), 0, 1e-12);
    EXPECT_NEAR(felt.torque, 0, 1e-15);
    // A push at a jaw next to the shaft turns it.
    ToolLoad at_jaw;
    at_jaw.add(Vector3(0.01, 0, -0.24), Vector3(0, 3, 0));
    EXPECT_NEAR(load_at_hand(handle, at_jaw).torque, -0.03, 1e-15);
    ToolMatrix wall;
    wall.add(800 * Vector3::UnitX() * Vector3::UnitX().transpose(), Vector3(0, 0, -0.24));
    EXPECT_NEAR(wall.at_hand(handle)(0, 0), 800 * 9, 1e-9);
}

TEST(Lever, GivesZeroWhereNoHandCanBe) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1e308;
    ToolLoad load;
    load.add(Vector3(0, 0, -0.2), Vector3(1, 2, 3));
    ToolMatrix matrix;
    matrix.add(800 * Matrix3::Identity(), Vector3(0, 0, -0.2));
    for (const Vector3& handle : {Vector3(0, 0, 0), Vector3(0, 0, 1e-9), Vector3(nan, 0, 0.1)}) {
        EXPECT_EQ(load_at_hand(handle, load).force, Vector3(Vector3::Zero()));
        EXPECT_EQ(load_at_hand(handle, load).torque, 0);
        EXPECT_EQ(matrix.at_hand(handle), Matrix3(Matrix3::Zero()));
    }
    ToolLoad broken;
    broken.add(Vector3(0, 0, -0.2), Vector3(nan, 0, 0));
    EXPECT_EQ(load_at_hand(Vector3(0, 0, 0.1), broken).force, Vector3(Vector3::Zero()));
    ToolLoad overflowing;
    overflowing.add(Vector3(0, 0, -huge), Vector3(huge, 0, 0));
    EXPECT_TRUE(load_at_hand(Vector3(0, 0, 0.1), overflowing).force.allFinite());
}

}  // namespace
}  // namespace fulcrum
