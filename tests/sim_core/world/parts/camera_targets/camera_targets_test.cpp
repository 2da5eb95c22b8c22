// SPDX-License-Identifier: Apache-2.0
// Cups to look into with an angled scope: each can be framed, what the lens touches is reported.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/instrument/framing.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/world/parts/camera_targets/camera_targets_layout.h"
#include "sim_core/world/world.h"
#include "tests/support/allocation_count.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr double degree = 0.017453292519943295;

Scene scene() {
    return load_scene(test::source_path("assets/scenes/a1_camera.json"));
}

/// The reading of a scope whose lens is at a place.
DeviceSample scope_at(const Scene& scene, const Vector3& lens, double post, double head = 0) {
    DeviceReading reading;
    reading.handle = handle_for_tip(make_scope(*scene.camera).trocar, lens);
    reading.roll = post;
    reading.jaw = head;
    return quantise(reading, {});
}

TEST(CameraTargets, EachIsFramedFromItsPlaceAndLevelOnceTheCameraHeadIsTurned) {
    const Scene a1 = scene();
    const ScopeModel scope = make_scope(*a1.camera);
    const Vector3 up(0, 0, 1);
    double largest_horizon = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const World world(a1, seed);
        const CameraTargetsView& view = world.snapshot().camera_targets;
        ASSERT_EQ(view.targets.size(), 12U);
        for (const CameraTarget& target : view.targets) {
            const CameraPose pose = scope_pose(scope, scope_at(a1, target.eye, target.post));
            const Framing framing = frame_of(pose, target.ball, view.distance, up);
            EXPECT_LT(framing.off_centre, 0.01 * degree);
            EXPECT_NEAR(framing.size, 1, 1e-4);
            EXPECT_TRUE(view.looks_into(target, pose.position));
            largest_horizon = std::max(largest_horizon, std::abs(framing.horizon));
            const CameraPose level =
                scope_pose(scope, scope_at(a1, target.eye, target.post, -framing.horizon));
            const Framing turned = frame_of(level, target.ball, view.distance, up);
            EXPECT_LT(std::abs(turned.horizon), 1e-5);
            EXPECT_NEAR(turned.off_centre, framing.off_centre, 1e-6);
        }
    }
    // Without the camera head the task would ask for nothing.
    EXPECT_GT(largest_horizon, 10 * degree);
}

TEST(CameraTargets, LightPostAwayFromItsPlaceHidesTheBall) {
    const Scene a1 = scene();
    const ScopeModel scope = make_scope(*a1.camera);
    const World world(a1, 3);
    const CameraTargetsView& view = world.snapshot().camera_targets;
    for (const CameraTarget& target : view.targets) {
        const CameraPose turned = scope_pose(scope, scope_at(a1, target.eye, target.post + 180 * degree));
        EXPECT_GT(frame_of(turned, target.ball, view.distance, Vector3(0, 0, 1)).off_centre, 40 * degree);
        EXPECT_FALSE(in_view(turned, target.ball));
    }
}

TEST(CameraTargets, AreSeenThroughTheMouthOnly) {
    const World world(scene(), 5);
    const CameraTargetsView& view = world.snapshot().camera_targets;
    for (const CameraTarget& target : view.targets) {
        const Vector3 aside = target.axis.unitOrthogonal();
        EXPECT_TRUE(view.looks_into(target, target.ball + 0.05 * target.axis));
        EXPECT_FALSE(view.looks_into(target, target.ball - 0.05 * target.axis));
        EXPECT_FALSE(view.looks_into(target, target.ball + 0.05 * aside));
        // The edge of the mouth: atan(cup_radius / cup_depth) off the axis.
        const double rim = view.cup_radius / view.cup_depth;
        EXPECT_TRUE(view.looks_into(target, target.ball + 0.05 * (target.axis + 0.98 * rim * aside)));
        EXPECT_FALSE(view.looks_into(target, target.ball + 0.05 * (target.axis + 1.02 * rim * aside)));
    }
}

TEST(CameraTargets, LensThatTouchesACupIsReportedOnceForEachContact) {
    const Scene a1 = scene();
    World world(a1, 7);
    const CameraTarget target = world.snapshot().camera_targets.targets[0];
    int contacts = 0;
    std::uint32_t tick = 0;
    const auto hold = [&](const Vector3& lens, int steps) {
        std::vector<TickOutput> outputs(static_cast<std::size_t>(a1.ticks_per_step));
        for (int step = 0; step < steps; ++step) {
            for (TickOutput& output : outputs) {
                output.input.tick = output.sample.tick = tick++;
                output.input.camera = scope_at(a1, lens, target.post);
            }
            world.step(outputs.data(), outputs.size());
            const WorldSnapshot& now = world.snapshot();
            for (int i = 0; i < now.event_count; ++i)
                contacts += now.events[static_cast<std::size_t>(i)].kind == EventKind::lens_contact ? 1 : 0;
        }
    };
    hold(target.eye, 20);
    EXPECT_EQ(contacts, 0);
    hold(target.mouth, 20);
    EXPECT_EQ(contacts, 1);
    hold(target.eye, 20);
    hold(target.mouth, 20);
    EXPECT_EQ(contacts, 2);
}

/// Steps of a scope that circles in front of the cups.
std::vector<std::vector<TickOutput>> circling(const Scene& a1, const CameraTarget& target, int steps) {
    std::vector<std::vector<TickOutput>> all;
    std::uint32_t tick = 0;
    for (int step = 0; step < steps; ++step) {
        std::vector<TickOutput> outputs(static_cast<std::size_t>(a1.ticks_per_step));
        for (TickOutput& output : outputs) {
            output.input.tick = output.sample.tick = tick++;
            const double share = 0.5 + 0.5 * std::sin(0.002 * tick);
            output.input.camera = scope_at(a1, (1 - share) * target.eye + share * target.mouth, target.post);
        }
        all.push_back(outputs);
    }
    return all;
}

TEST(CameraTargets, SavedWorldContinuesBitForBitInTheSameAndInANewWorld) {
    const Scene a1 = scene();
    World world(a1, 7);
    const auto steps = circling(a1, world.snapshot().camera_targets.targets[0], 1200);
    for (std::size_t i = 0; i < 400; ++i) world.step(steps[i].data(), steps[i].size());
    const std::shared_ptr<const World::Saved> saved = world.save();
    std::vector<std::uint64_t> hashes;
    int contacts = 0;
    const auto contacts_in = [](const World& one) { return one.snapshot().event_count; };
    for (std::size_t i = 400; i < steps.size(); ++i) {
        world.step(steps[i].data(), steps[i].size());
        hashes.push_back(world.hash());
        contacts += contacts_in(world);
    }
    EXPECT_GT(contacts, 0);
    World fresh(a1, 7);
    for (World* one : {&world, &fresh}) {
        one->restore(*saved);
        int again = 0;
        for (std::size_t i = 400; i < steps.size(); ++i) {
            one->step(steps[i].data(), steps[i].size());
            ASSERT_EQ(one->hash(), hashes[i - 400]) << i;
            again += contacts_in(*one);
        }
        EXPECT_EQ(again, contacts);
    }
}

TEST(CameraTargets, StepAllocatesNothing) {
    const Scene a1 = scene();
    World world(a1, 7);
    const auto steps = circling(a1, world.snapshot().camera_targets.targets[0], 800);
    for (std::size_t i = 0; i < 50; ++i) world.step(steps[i].data(), steps[i].size());
    EXPECT_EQ(test::allocations_in([&] {
                  for (std::size_t i = 50; i < steps.size(); ++i)
                      world.step(steps[i].data(), steps[i].size());
              }),
              0U);
}

/// While the light post is as at the beginning.
TEST(CameraTargets, TipCanBeFollowedWithoutTouchingACupAndIsNeverHidden) {
    const Scene a1 = scene();
    const ScopeModel scope = make_scope(*a1.camera);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const World world(a1, seed);
        const CameraTargetsView& view = world.snapshot().camera_targets;
        const TipPath path = draw_tip_path(*a1.camera_targets, seed);
        double least_of_scope = 1, least_of_sight = 1;  // m, between the outside of a cup and each
        for (double t = 0; t < 40; t += 0.1) {
            const Vector3 tip = path.at(t);
            Vector3 lens = tip - view.distance * scope.trocar.rotation.col(2);
            for (int i = 0; i < 12; ++i)
                lens = tip - view.distance * view_direction(scope_pose(scope, scope_at(a1, lens, 0)));
            for (const CameraTarget& cup : view.targets) {
                const Vector3 bottom = cup.ball - view.ball_radius * cup.axis;
                const auto room = [&](const Vector3& from, const Vector3& to) {
                    const SegmentPair pair = closest_points_of_segments(from, to, bottom, cup.mouth);
                    return (from + pair.s * (to - from) - bottom - pair.t * (cup.mouth - bottom)).norm() -
                           view.cup_radius - view.wall;
                };
                least_of_scope = std::min(least_of_scope, room(scope.trocar.position, lens));
                least_of_sight = std::min(least_of_sight, room(lens, tip));
            }
        }
        EXPECT_GT(least_of_scope, a1.camera_targets->lens_radius) << seed;
        EXPECT_GT(least_of_sight, 0) << seed;
    }
}

TEST(CameraTargets, TipStaysInItsRegionAndBelowItsSpeed) {
    const Scene a1 = scene();
    const CameraTargetsSpec& spec = *a1.camera_targets;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const TipPath path = draw_tip_path(spec, seed);
        for (double t = 0; t < 120; t += 0.05) {
            const Vector3 away = (path.at(t) - spec.tip_centre).cwiseAbs() - spec.tip_extent;
            EXPECT_LE(away.maxCoeff(), 1e-12);
            EXPECT_LE(path.velocity(t).cwiseAbs().maxCoeff(), spec.tip_speed);
            const Vector3 difference = (path.at(t + 1e-4) - path.at(t - 1e-4)) / 2e-4;
            EXPECT_LT((difference - path.velocity(t)).norm(), 1e-8);
        }
    }
}

TEST(CameraTargets, ScenesThatCannotBeAreRefusedWithTheirPlace) {
    std::ifstream file(test::source_path("assets/scenes/a1_camera.json"));
    const nlohmann::json original = nlohmann::json::parse(file);
    const auto place_of = [&](const char* pointer, const nlohmann::json& value) {
        nlohmann::json document = original;
        document[nlohmann::json::json_pointer(pointer)] = value;
        try {
            const Scene changed = parse_scene(document.dump(), "scene.json");
            World world(changed, 1);
        } catch (const InputError& error) {
            return error.place();
        }
        return std::string("accepted");
    };
    EXPECT_EQ(place_of("/camera_targets/ball_radius", 0.008), "1 (/camera_targets/ball_radius)");
    EXPECT_EQ(place_of("/camera_targets/distance", 0.016), "1 (/camera_targets/distance)");
    EXPECT_EQ(place_of("/camera_targets/least_insertion", 0.12), "1 (/camera_targets/least_insertion)");
    EXPECT_EQ(place_of("/camera_targets/tissue", "wood"), "1 (/camera_targets)");
    EXPECT_EQ(place_of("/camera_targets/spacing", 0.09), "/camera_targets/count");
    EXPECT_EQ(place_of("/camera_targets/tip_extent", {0.02, -0.01, 0.01}), "1 (/camera_targets/tip_extent)");
    nlohmann::json mixed = original;
    mixed["objects"] = nlohmann::json::object();
    EXPECT_THROW(parse_scene(mixed.dump(), "scene.json"), InputError);
    nlohmann::json alone = original;
    alone.erase("camera_targets");
    EXPECT_THROW(parse_scene(alone.dump(), "scene.json"), InputError);
    nlohmann::json blind = original;
    blind.erase("camera");
    EXPECT_THROW(parse_scene(blind.dump(), "scene.json"), InputError);
}

}  // namespace
}  // namespace fulcrum
