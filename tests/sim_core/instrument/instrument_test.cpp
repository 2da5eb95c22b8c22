// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/instrument.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.141592653589793;

InstrumentModel slanted_grasper() {
    InstrumentSpec spec;
    spec.trocar.position = Vector3(0.06, 0.12, 0.10);
    spec.trocar.direction = Vector3(-0.3, -0.7, -0.6);
    spec.trocar.up = Vector3(0, 0, 1);
    return make_instrument(spec, 1e-3);
}

DeviceSample sample_at(const Vector3& handle, double roll = 0, double jaw = 0, double grip = 0) {
    DeviceReading reading;
    reading.handle = handle;
    reading.roll = roll;
    reading.jaw = jaw;
    reading.grip = grip;
    return quantise(reading, DeviceSample{});
}

TEST(Trocar, FrameIsRightHandedWithYUp) {
    const Trocar trocar = slanted_grasper().trocar;
    EXPECT_NEAR((trocar.rotation.transpose() * trocar.rotation - Matrix3::Identity()).norm(), 0, 1e-14);
    EXPECT_NEAR(trocar.rotation.determinant(), 1.0, 1e-14);
    EXPECT_GT(trocar.rotation.col(1).z(), 0.5);
    EXPECT_NEAR(trocar.rotation.col(2).dot(Vector3(-0.3, -0.7, -0.6).normalized()), 1.0, 1e-14);
    TrocarSpec degenerate;
    degenerate.direction = Vector3::Zero();
    degenerate.up = Vector3(0, 0, 3);
    EXPECT_NEAR(make_trocar(degenerate).rotation.determinant(), 1.0, 1e-14);
}

TEST(Instrument, TipIsMirroredAndScaledByTheLeverArm) {
    const InstrumentModel model = slanted_grasper();
    const Vector3 handle(0, 0, -0.24);  // 0.10 m inside
    const ToolKinematics straight = tool_pose(model, sample_at(handle));
    EXPECT_NEAR(straight.insertion, 0.10, 1e-9);
    EXPECT_NEAR((straight.tip - model.trocar.position - 0.10 * model.trocar.rotation.col(2)).norm(), 0, 1e-9);
    // 1 mm of the hand to one side moves the tip to the other side by insertion over handle length.
    const ToolKinematics moved = tool_pose(model, sample_at(handle + Vector3(1e-3, 0, 0)));
    const Vector3 local = model.trocar.rotation.transpose() * (moved.tip - straight.tip);
    EXPECT_NEAR(local.x(), -1e-3 * 0.10 / 0.24, 5e-8);
    EXPECT_NEAR(local.y(), 0, 1e-9);
    // In by 1 mm is deeper by 1 mm.
    const ToolKinematics deeper = tool_pose(model, sample_at(handle + Vector3(0, 0, 1e-3)));
    EXPECT_NEAR(deeper.insertion, 0.101, 1e-9);
}

TEST(Instrument, HandleForTipIsTheInverse) {
    const InstrumentModel model = slanted_grasper();
    Random random(2);
    for (int trial = 0; trial < 100; ++trial) {
        const Vector3 local(random.uniform(-0.08, 0.08), random.uniform(-0.08, 0.08),
                            random.uniform(0.05, 0.2));
        const Vector3 target = model.trocar.position + model.trocar.rotation * local;
        const ToolKinematics tool = tool_pose(model, sample_at(handle_for_tip(model.trocar, target)));
        EXPECT_LT((tool.tip - target).norm(), 5e-7);  // the device's counts of 0.1 um, over the lever
        EXPECT_NEAR((tool.rotation.col(2) - tool.axis).norm(), 0, 1e-12);
        EXPECT_NEAR(tool.rotation.determinant(), 1.0, 1e-12);
    }
}

TEST(Instrument, RollTurnsTheJawsAboutTheShaft) {
    const InstrumentModel model = slanted_grasper();
    const Vector3 handle(0.03, -0.02, -0.22);
    const ToolKinematics before = tool_pose(model, sample_at(handle));
    const ToolKinematics after = tool_pose(model, sample_at(handle, pi / 2));
    EXPECT_NEAR((after.axis - before.axis).norm(), 0, 1e-12);
    EXPECT_NEAR(after.rotation.col(0).dot(before.rotation.col(1)), 1.0, 1e-10);
    const Quaternion turn(after.rotation * before.rotation.transpose());
    EXPECT_NEAR(turn.vec().dot(before.axis), std::sin(pi / 4), 1e-6);  // positive from trocar to tip
}

TEST(Instrument, JawAndGripKeepTheirRanges) {
    const InstrumentModel model = slanted_grasper();
    EXPECT_NEAR(tool_pose(model, sample_at({0, 0, -0.2}, 0, 9.0, 1000.0)).jaw_angle, model.jaw_opening,
                1e-12);
    EXPECT_NEAR(tool_pose(model, sample_at({0, 0, -0.2}, 0, 0.4, 1000.0)).grip, model.grip_limit, 1e-12);
    EXPECT_NEAR(tool_pose(model, sample_at({0, 0, -0.2}, 0, 0.4, 3.5)).grip, 3.5, 1e-3);
}

TEST(Instrument, VelocityIsTheDifferenceOfPoses) {
    const InstrumentModel model = slanted_grasper();
    InstrumentState state;
    ToolKinematics last;
    for (int tick = 0; tick < 50; ++tick) {
        const double t = tick * 1e-3;
        const DeviceSample sample = sample_at(Vector3(0.2 * t, 0.1 * t, -0.22 + 0.05 * t), 2.0 * t);
        const ToolKinematics tool = step_instrument(model, sample, state);
        if (tick == 0) {
            EXPECT_EQ(tool.tip_velocity.norm(), 0);
        } else {
            EXPECT_NEAR((tool.tip_velocity * 1e-3 - (tool.tip - last.tip)).norm(), 0, 1e-15);
            EXPECT_NEAR(tool.angular_velocity.dot(tool.axis), 2.0, 0.01);
        }
        last = tool;
    }
    DeviceSample gone = state.last;
    gone.present = 0;
    EXPECT_EQ(step_instrument(model, gone, state).tip_velocity.norm(), 0);
    // Back somewhere else: no kick.
    EXPECT_EQ(step_instrument(model, sample_at({0.05, 0.05, -0.1}), state).tip_velocity.norm(), 0);
}

TEST(Instrument, AnySampleGivesAFinitePose) {
    const InstrumentModel model = slanted_grasper();
    Random random(9);
    for (int trial = 0; trial < 5000; ++trial) {
        DeviceSample sample;
        for (int i = 0; i < 3; ++i) {
            const int shift = static_cast<int>(random.below(32));
            sample.handle[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(random.bits())) >> shift;
        }
        sample.roll = static_cast<std::int32_t>(static_cast<std::uint32_t>(random.bits()));
        sample.jaw = static_cast<std::int32_t>(static_cast<std::uint32_t>(random.bits()));
        const ToolKinematics tool = tool_pose(model, sample);
        EXPECT_TRUE(tool.tip.allFinite());
        EXPECT_NEAR(tool.axis.norm(), 1.0, 1e-12);
        EXPECT_NEAR(tool.rotation.determinant(), 1.0, 1e-9);
        EXPECT_GE(tool.insertion, least_insertion);
        EXPECT_LE(tool.insertion, model.trocar.shaft_length - handle_clearance + 1e-12);
        EXPECT_EQ(tool.inside, tool.insertion > 0);
        EXPECT_GT(tool.axis.dot(model.trocar.rotation.col(2)), 0.09);  // never out of the body
    }
}

CameraSpec umbilical_scope() {
    CameraSpec spec;
    spec.trocar.position = Vector3(0, 0.12, 0.12);
    spec.trocar.direction = Vector3(0, -1, -0.6);
    return spec;
}

TEST(Scope, ThirtyDegreeScopeLooksAwayFromTheLightPost) {
    const ScopeModel scope = make_scope(umbilical_scope());
    const Vector3 shaft = scope.trocar.rotation.col(2);
    const CameraPose level = scope_pose(scope, sample_at({0, 0, -0.28}));
    EXPECT_NEAR(std::acos(view_direction(level).dot(shaft)), scope.angle, 1e-9);
    EXPECT_LT(view_direction(level).z(), shaft.z());             // down
    EXPECT_GT((level.orientation * Vector3::UnitY()).z(), 0.4);  // up is up
    // Light post down: looks up; the horizon stays.
    const CameraPose turned = scope_pose(scope, sample_at({0, 0, -0.28}, pi));
    EXPECT_NEAR(std::acos(view_direction(turned).dot(shaft)), scope.angle, 1e-6);
    EXPECT_GT(view_direction(turned).z(), shaft.z());
    for (int k = 0; k < 12; ++k) {
        const CameraPose pose = scope_pose(scope, sample_at({0, 0, -0.28}, 2 * pi * k / 12));
        EXPECT_NEAR((pose.position - level.position).norm(), 0, 1e-12);
        EXPECT_GT((pose.orientation * Vector3::UnitY()).dot(scope.trocar.rotation.col(1)), 0.8) << k;
        EXPECT_NEAR(pose.orientation.norm(), 1.0, 1e-12);
    }
}

TEST(Scope, PointsInsideTheRoundImageAreInView) {
    const ScopeModel scope = make_scope(umbilical_scope());
    const CameraPose camera = scope_pose(scope, sample_at({0.02, 0.03, -0.27}, 0.8));
    const Vector3 forward = view_direction(camera);
    EXPECT_TRUE(in_view(camera, camera.position + 0.05 * forward));
    EXPECT_FALSE(in_view(camera, camera.position - 0.05 * forward));
    EXPECT_FALSE(in_view(camera, camera.position + 0.001 * forward));
    for (int k = 0; k < 16; ++k) {
        const double around = 2 * pi * k / 16;
        for (const double part : {0.98, 1.02}) {
            const double off = part * 0.5 * camera.field_of_view;
            const Vector3 local(std::sin(off) * std::cos(around), std::sin(off) * std::sin(around),
                                -std::cos(off));
            EXPECT_EQ(in_view(camera, camera.position + 0.06 * (camera.orientation * local)), part < 1) << k;
        }
    }
    EXPECT_FALSE(in_view(camera, Vector3::Constant(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Instrument, HandHasJawsIfAnyExchangedInstrumentHas) {
    const auto jaws = [](InstrumentKind kind, std::vector<InstrumentKind> exchange) {
        InstrumentSpec spec;
        spec.kind = kind;
        spec.exchange = std::move(exchange);
        const InstrumentModel model = make_instrument(spec, 1e-3);
        const DeviceSample sample = sample_at(Vector3(0, 0, 0.1), 0, 0.5, 2);
        EXPECT_EQ(tool_pose(model, sample).grip > 0, model.has_jaws) << type_of(kind).name;
        return model.has_jaws;
    };
    EXPECT_TRUE(jaws(InstrumentKind::grasper, {}));
    EXPECT_FALSE(jaws(InstrumentKind::hook, {}));
    EXPECT_FALSE(jaws(InstrumentKind::probe, {}));
    EXPECT_FALSE(jaws(InstrumentKind::hook, {InstrumentKind::hook, InstrumentKind::suction}));
    EXPECT_TRUE(jaws(InstrumentKind::hook,
                     {InstrumentKind::hook, InstrumentKind::suction, InstrumentKind::clip_applier}));
}

}  // namespace
}  // namespace fulcrum
