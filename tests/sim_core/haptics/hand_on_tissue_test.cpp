// SPDX-License-Identifier: Apache-2.0
// A simulated hand at the product's own loop and world: it presses wall, bowel and sheet with the tip and
// pulls a band that its jaws hold, through the lever, with an arm and without. It comes to rest and gets back
// no energy. Local models of the tissues at every insertion: lab/hand_lever_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim_core/haptics/loop.h"
#include "sim_core/instrument/moving_hand.h"
#include "sim_core/world/parts/bands/bands_part.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/parts/sheet/sheet_part.h"
#include "sim_core/world/world.h"
#include "tests/support/force_device.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

enum class PressedTissue { wall, bowel, sheet, band };
constexpr const char* pressed_names[] = {"Wall", "Bowel", "Sheet", "Band"};
constexpr const char* pressed_scenes[] = {"b1_bowel", "b1_bowel", "b2_areolar", "b3_bands"};

/// The left hand of a scene, put somewhere tick by tick; the right one stays where it begins.
struct LeftHandOnTissue {
    explicit LeftHandOnTissue(PressedTissue tissue)
        : scene(load_scene(test::source_path(std::string("assets/scenes/") +
                                             pressed_scenes[static_cast<int>(tissue)] + ".json"))),
          world(scene, 5),
          loop(scene, world),
          outputs(static_cast<std::size_t>(scene.ticks_per_step)),
          spec(*scene.instrument(Hand::left)),
          pivot(make_trocar(spec.trocar)),
          tip(pivot.position + spec.start_insertion * pivot.rotation.col(2)) {
        loop.set_device(Hand::left, test::desk_device());
    }
    /// The force on the hand, N, trocar's frame, with the handle at a place in that frame.
    Vector3 tick(const Vector3& handle) {
        RigSample input;
        input.tick = ++ticks;
        for (const InstrumentSpec& other : scene.instruments)
            input.hand[static_cast<int>(other.hand)] = start_sample(other.trocar, other.start_insertion);
        if (scene.camera) input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
        DeviceReading reading;
        reading.handle = handle;
        reading.jaw = jaw;
        reading.grip = grip;
        input.hand[0] = last = quantise(reading, last);
        const std::size_t slot = (ticks - 1) % outputs.size();
        outputs[slot] = loop.tick(input);
        const Vector3 force = pivot.rotation.transpose() * outputs[slot].device_force[0];
        if (slot + 1 == outputs.size()) {
            world.step(outputs.data(), outputs.size());
            loop.adopt(world.local_models());
        }
        return force;
    }
    /// In a straight line.
    void go(const Vector3& to, int count) {
        const Vector3 from = tip;
        for (int i = 1; i <= count; ++i) {
            tip = from + static_cast<double>(i) / count * (to - from);
            tick(handle_for_tip(pivot, tip));
        }
    }
    Vector3 tip_for_jaws(const Vector3& place) const {
        return place + 0.5 * spec.jaw_length * (place - pivot.position).normalized();
    }
    Scene scene;
    World world;
    HapticLoop loop;
    std::vector<TickOutput> outputs;
    const InstrumentSpec& spec;
    Trocar pivot;
    Vector3 tip;  ///< m, where go() brought it
    double jaw = 0, grip = 0;
    DeviceSample last;
    std::uint32_t ticks = 0;
};

/// Brings the tip just before the tissue, or the band into the jaws; the direction in which it is to be
/// moved.
Vector3 approach(LeftHandOnTissue& at, PressedTissue tissue) {
    constexpr double before = 1e-4;  // m
    const double radius = at.spec.tip_radius;
    if (tissue == PressedTissue::wall) {
        const CavityPoint wall = at.world.wall()->closest(at.tip, 0.2);
        EXPECT_GE(wall.triangle, 0);
        at.go(wall.position + (radius + before) * wall.normal, 500);
        return -wall.normal;
    }
    if (tissue == PressedTissue::bowel) {
        const std::vector<Vector3>& nodes = at.world.find<BowelPart>()->state().nodes;
        const Vector3 node =
            *std::min_element(nodes.begin() + 1, nodes.end() - 1, [&](const Vector3& a, const Vector3& b) {
                return (a - at.pivot.position).norm() < (b - at.pivot.position).norm();
            });
        const Vector3 up = (at.pivot.position - node).normalized();
        at.go(node + (at.scene.bowel->outer_radius + radius + before) * up, 500);
        return -up;
    }
    at.jaw = 0.8 * at.spec.jaw_opening;
    if (tissue == PressedTissue::sheet) {
        const Vector3 up = Vector3::UnitZ();
        at.go(at.scene.sheet->centre + 0.02 * up, 300);
        at.go(at.scene.sheet->centre + (radius + before + 1e-3) * up, 300);
        return -up;
    }
    constexpr std::size_t band = 2;
    const Vector3 middle = at.world.find<BandsPart>()->strand(band).position[strand_segments / 2];
    at.go(at.tip_for_jaws(middle + Vector3(0, 0, 0.02)), 300);
    at.go(at.tip_for_jaws(middle), 300);
    at.jaw = 0.05;
    at.grip = 6;
    at.go(at.tip, 50);
    EXPECT_TRUE(at.world.snapshot().grasps[0].held) << "the jaws hold the band";
    return Vector3::UnitZ();
}

struct HandAtRest {
    double largest_way = 0, last_way = 0;      // m from where it ended: at all, in the last half second
    double largest_force = 0, last_force = 0;  // N
    double returned = 0, put_in = 0;           // J
    bool bounded = true;
};

HandAtRest press_tissue(PressedTissue tissue, double mass, bool arm) {
    LeftHandOnTissue at(tissue);
    const Vector3 direction = approach(at, tissue);
    // The force is at its full share before the hand is let go: no spring becomes stiffer in its hand.
    at.go(at.tip, 400);
    MovingHand moving;
    moving.hand.mass = mass;
    moving.hand.arm = arm;
    moving.place = handle_for_tip(at.pivot, at.tip);
    const Vector3 begun = moving.place;
    const bool soft = tissue == PressedTissue::sheet;
    if (arm) {
        moving.wanted = handle_for_tip(at.pivot, at.tip + (soft ? 0.008 : 0.003) * direction);
    } else {
        moving.rail = (handle_for_tip(at.pivot, at.tip + 1e-3 * direction) - begun).normalized();
        moving.push = (soft ? 0.1 : 0.3) * moving.rail;
    }
    // Without an arm only the device's damping stops a heavy hand: on a band, the softest, by a tenth a
    // second.
    const int heavy = tissue == PressedTissue::band ? 60000 : 12000;
    const int ticks = !arm && mass > 0.1 ? heavy : 3000;
    std::vector<Vector3> path;
    path.reserve(static_cast<std::size_t>(ticks));
    HandAtRest rest;
    for (int i = 0; i < ticks; ++i) {
        const Vector3 force = at.tick(moving.place);
        moving.step(force, 1e-3);
        rest.largest_force = std::max(rest.largest_force, force.norm());
        rest.last_force = force.norm();
        rest.returned = std::max(rest.returned, moving.given - moving.lost);
        rest.put_in = std::max(rest.put_in, -moving.given);
        path.push_back(moving.place);
        rest.bounded = moving.place.allFinite() && (moving.place - begun).norm() < 0.05;
        if (!rest.bounded) return rest;
    }
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double way = (path[i] - path.back()).norm();
        rest.largest_way = std::max(rest.largest_way, way);
        if (i + 500 >= path.size()) rest.last_way = std::max(rest.last_way, way);
    }
    return rest;
}

class HandOnTissue : public testing::TestWithParam<PressedTissue> {};

TEST_P(HandOnTissue, ComesToRestThroughTheLeverAndGetsNoEnergy) {
    // Of what it had put in. A wall does not move; other tissue is simulated in steps of its own.
    const double share = GetParam() == PressedTissue::wall ? 1e-3 : 1e-2;
    const double floor = GetParam() == PressedTissue::wall ? 1e-6 : 1e-5;  // J
    for (const double mass : {0.05, 0.5}) {
        for (const bool arm : {false, true}) {
            const HandAtRest rest = press_tissue(GetParam(), mass, arm);
            SCOPED_TRACE(std::string(pressed_names[static_cast<int>(GetParam())]) + ", " +
                         std::to_string(mass) + " kg" + (arm ? ", with an arm" : ""));
            ASSERT_TRUE(rest.bounded);
            EXPECT_GT(rest.last_force, 0.02) << "it presses or pulls";
            EXPECT_LE(rest.largest_force, 3.3 * (1 + 1e-9));
            EXPECT_GT(rest.largest_way, 1e-4) << "m";
            EXPECT_LT(rest.last_way, std::max(0.1 * rest.largest_way, 5e-5)) << "m, of " << rest.largest_way;
            EXPECT_GT(rest.put_in, 0);
            EXPECT_LE(rest.returned, floor + share * rest.put_in) << "J, of " << rest.put_in;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Tissues, HandOnTissue,
                         testing::Values(PressedTissue::wall, PressedTissue::bowel, PressedTissue::sheet,
                                         PressedTissue::band),
                         [](const auto& of) { return pressed_names[static_cast<int>(of.param)]; });

}  // namespace
}  // namespace fulcrum
