// SPDX-License-Identifier: Apache-2.0
// A simulated hand at the product's own loop and world: it presses the bowel from above and from the side,
// and comes to rest. What is recorded and simulated does not depend on the device.
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/haptics/loop.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/world.h"
#include "tests/support/force_device.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

/// A hand that holds the left handle of B1 with an arm, or follows a given path.
struct HandInWorld {
    explicit HandInWorld(double rate)
        : scene(scene_at(rate)),
          world(scene, 1),
          loop(scene, world),
          outputs(static_cast<std::size_t>(scene.ticks_per_step)),
          pivot(make_trocar(scene.instrument(Hand::left)->trocar)) {}

    static Scene scene_at(double rate) {
        Scene scene = load_scene(test::source_path("assets/scenes/b1_bowel.json"));
        scene.ticks_per_step = static_cast<int>(std::lround(rate * scene.step_period()));
        scene.tick_rate = static_cast<int>(rate);
        return scene;
    }
    /// One tick with the handle at a place in the trocar's frame.
    const TickOutput& tick(const Vector3& handle, std::uint32_t flags = 0) {
        const auto slot = static_cast<std::size_t>(ticks % static_cast<std::uint32_t>(scene.ticks_per_step));
        RigSample input;
        input.tick = ++ticks;
        input.flags = flags;
        for (const InstrumentSpec& spec : scene.instruments)
            input.hand[static_cast<int>(spec.hand)] = start_sample(spec.trocar, spec.start_insertion);
        if (scene.camera) input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
        DeviceReading reading;
        reading.handle = handle;
        input.hand[0] = last = quantise(reading, last);
        outputs[slot] = loop.tick(input);
        if (slot + 1 == outputs.size()) {
            const StepRecord record = world.step(outputs.data(), outputs.size());
            hash = hash * 31 + record.state_hash;
            loop.adopt(world.local_models());
        }
        return outputs[slot];
    }
    /// The middle of the bowel, and the direction from it to the trocar.
    Vector3 centre() const {
        const std::vector<Vector3>& nodes = world.find<BowelPart>()->state().nodes;
        std::size_t nearest = 1;
        for (std::size_t n = 1; n + 1 < nodes.size(); ++n) {
            if ((nodes[n] - pivot.position).norm() < (nodes[nearest] - pivot.position).norm()) nearest = n;
        }
        along = (nodes[nearest + 1] - nodes[nearest - 1]).normalized();
        return nodes[nearest];
    }

    Scene scene;
    World world;
    HapticLoop loop;
    std::vector<TickOutput> outputs;
    Trocar pivot;
    DeviceSample last;
    std::uint32_t ticks = 0;
    std::uint64_t hash = 0;
    mutable Vector3 along = Vector3::UnitX();
};

struct Rest {
    double speed = 0, force = 0, largest = 0;  // m/s at the end; N sent at the end, and largest
    bool bounded = true;
};

// From 8 mm outside the surface the arm pulls the tip to 5 mm inside it.
Rest press(double rate, bool from_the_side, double mass) {
    HandInWorld at(rate);
    at.loop.set_device(Hand::left, test::desk_device());
    const Vector3 centre = at.centre(), up = (at.pivot.position - centre).normalized();
    const Vector3 out = from_the_side ? Vector3(at.along.cross(up).normalized()) : up;
    const Vector3 tip = centre + 0.024 * out, aim = centre + 0.011 * out;
    Vector3 handle = handle_for_tip(at.pivot, tip), velocity = Vector3::Zero();
    const Vector3 start = handle, wanted = handle_for_tip(at.pivot, aim);
    const double dt = 1 / rate;
    const auto ticks = static_cast<int>(2.5 * rate);
    Rest rest;
    for (int tick = 0; tick < ticks; ++tick) {
        const TickOutput& output = at.tick(handle);
        const Vector3 force = at.pivot.rotation.transpose() * output.device_force[0];
        for (int part = 0; part < 10; ++part) {
            velocity += 0.1 * dt / mass * (force + 300 * (wanted - handle) - 3.5 * velocity);
            handle += 0.1 * dt * velocity;
        }
        rest.largest = std::max(rest.largest, force.norm());
        rest.bounded = rest.bounded && handle.allFinite() && (handle - start).norm() < 0.05;
        if (!rest.bounded) return rest;
        if (tick > ticks - static_cast<int>(0.2 * rate)) rest.speed = std::max(rest.speed, velocity.norm());
        rest.force = force.norm();
    }
    return rest;
}

TEST(HandInWorld, SettlesOnTheBowelFromAboveAndFromTheSide) {
    for (const double rate : {1000.0, 1200.0}) {
        for (const bool side : {false, true}) {
            for (const double mass : {0.05, 0.5}) {
                const Rest rest = press(rate, side, mass);
                EXPECT_TRUE(rest.bounded) << rate << " " << side << " " << mass;
                EXPECT_LT(rest.speed, 0.002) << rate << " " << side << " " << mass;
                EXPECT_GT(rest.force, 0.02) << "it presses; " << rate << " " << side << " " << mass;
                EXPECT_LE(rest.largest, 3.3 * (1 + 1e-9));
            }
        }
    }
}

TEST(HandInWorld, TheDeviceChangesNothingThatIsRecordedOfTheTissue) {
    std::vector<TickSample> samples[2];
    std::uint64_t hashes[2] = {0, 0};
    double sent[2] = {0, 0};
    for (int with = 0; with < 2; ++with) {
        HandInWorld at(1000);
        if (with == 1) at.loop.set_device(Hand::left, test::desk_device());
        const Vector3 centre = at.centre(), up = (at.pivot.position - centre).normalized();
        for (int tick = 0; tick < 400; ++tick) {
            const double depth = 0.024 - 0.00003 * tick;
            const TickOutput& output = at.tick(handle_for_tip(at.pivot, centre + depth * up));
            sent[with] = std::max(sent[with], output.device_force[0].norm());
            TickSample sample = output.sample;
            for (HandSample& hand : sample.hand) {
                std::fill(std::begin(hand.device_force), std::end(hand.device_force), 0);
                hand.flags = static_cast<std::uint16_t>(hand.flags & ~static_cast<unsigned>(hand_clamped));
            }
            samples[with].push_back(sample);
        }
        hashes[with] = at.hash;
    }
    EXPECT_EQ(sent[0], 0) << "no device: nothing is sent";
    EXPECT_GT(sent[1], 0.1);
    EXPECT_EQ(hashes[0], hashes[1]);
    for (std::size_t i = 0; i < samples[0].size(); ++i)
        ASSERT_EQ(std::memcmp(&samples[0][i], &samples[1][i], sizeof(TickSample)), 0) << i;
}

// With the limits that the loop gives each hand: no force jumps at a hand that is on tissue when an attempt
// begins or is resumed.
TEST(HandInWorld, TheForceRisesFromZeroAtTheStartAndAfterAPause) {
    HandInWorld at(1000);
    at.loop.set_device(Hand::left, test::ideal_device());
    const Vector3 centre = at.centre(), up = (at.pivot.position - centre).normalized();
    const Vector3 pressing = handle_for_tip(at.pivot, centre + 0.011 * up);
    constexpr int ramp = 300;
    constexpr double swapped = 0.02;  // N, by which a new model may be off until the difference has decayed
    const auto expect_ramp = [&](const char* when) {
        double pressed = 0, sent = 0;
        for (int n = 1; n <= ramp + 50; ++n) {
            const TickOutput& output = at.tick(pressing);
            const std::int32_t* force = output.sample.hand[0].force;
            pressed = sample_force_unit * Vector3(force[0], force[1], force[2]).norm();
            sent = output.device_force[0].norm();
            const double share = std::min(1.0, n / static_cast<double>(ramp));
            ASSERT_LE(sent, 1.05 * share * pressed + swapped) << when << ", tick " << n;
        }
        EXPECT_GT(pressed, 0.1) << when;
        EXPECT_GT(sent, 0.8 * pressed) << when;
    };
    expect_ramp("at the start");
    for (int n = 0; n < 100; ++n) at.tick(pressing, rig_paused);
    ASSERT_EQ(at.tick(pressing, rig_paused).device_force[0], Vector3(Vector3::Zero()));
    expect_ramp("after the pause");
}

// Along the shaft the hand feels what the tip gives; across it the force is turned round and multiplied by
// the lever.
TEST(HandInWorld, FeelsTheTipThroughTheTrocar) {
    HandInWorld at(1000);
    at.loop.set_device(Hand::left, test::ideal_device());
    const Vector3 centre = at.centre(), up = (at.pivot.position - centre).normalized();
    const Vector3 side = at.along.cross(up).normalized();
    const Vector3 place = centre + 0.013 * (up + 0.6 * side).normalized();
    const TickOutput* output = nullptr;
    for (int tick = 0; tick < 800; ++tick) output = &at.tick(handle_for_tip(at.pivot, place));
    const HandSample& sample = output->sample.hand[0];
    const Vector3 force = -sample_force_unit * Vector3(sample.force[0], sample.force[1], sample.force[2]);
    ASSERT_GT(force.norm(), 0.1);
    const Vector3 axis = output->contact[0].tool.axis;
    const double insertion = output->contact[0].tool.insertion;
    const double lever = insertion / (at.pivot.shaft_length - insertion);
    const Vector3 felt = output->device_force[0];
    const double along = force.dot(axis);
    const Vector3 across = force - along * axis;
    EXPECT_NEAR(felt.dot(axis), along, 0.02 * force.norm() + 2e-3);
    EXPECT_NEAR((felt - felt.dot(axis) * axis + lever * across).norm(), 0,
                0.06 * lever * force.norm() + 2e-3);
}

/// Both hands of A2, far from its spheres; `apart`: m between the axes of the shafts where they cross. Ends
/// with both at rest.
const TickOutput& cross_shafts(HapticLoop& loop, World& world, double apart) {
    const Scene& scene = world.scene();
    constexpr double beyond[hand_count] = {0.06, 0.02};  // m of each shaft beyond the crossing
    const Vector3 crossing(0, 0.085, 0.06);
    const Trocar pivot[hand_count] = {make_trocar(scene.instrument(Hand::left)->trocar),
                                      make_trocar(scene.instrument(Hand::right)->trocar)};
    const Vector3 between =
        (crossing - pivot[0].position).cross(crossing - pivot[1].position).normalized();  // right to left
    std::vector<TickOutput> outputs(static_cast<std::size_t>(scene.ticks_per_step));
    constexpr std::uint32_t ticks = 800;
    DeviceSample last[hand_count];
    const TickOutput* output = nullptr;
    for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
        const double now = apart + std::max(0.0, 0.02 - 1e-4 * tick);
        RigSample input;
        input.tick = tick;
        input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
        for (int h = 0; h < hand_count; ++h) {
            const Vector3 through = crossing + (h == 0 ? 0.5 : -0.5) * now * between;
            const Vector3 along = (through - pivot[h].position).normalized();
            DeviceReading reading;
            reading.handle = handle_for_tip(pivot[h], through + beyond[h] * along);
            input.hand[h] = last[h] = quantise(reading, last[h]);
        }
        const std::size_t slot = (tick - 1) % outputs.size();
        output = &loop.tick(input);
        outputs[slot] = *output;
        if (slot + 1 != outputs.size()) continue;
        world.step(outputs.data(), outputs.size());
        loop.adopt(world.local_models());
    }
    const ToolKinematics tool[hand_count] = {output->contact[0].tool, output->contact[1].tool};
    const Vector3 away = tool[1].axis.cross(tool[0].axis).normalized();
    const Vector3 normal = away.dot(between) > 0 ? away : Vector3(-away);
    const double distance = normal.dot(pivot[0].position - pivot[1].position);
    const double newton = 800 * std::max(0.0, 0.005 - distance);  // shafts of 2.5 mm, 800 N/m
    for (int h = 0; h < hand_count; ++h) {
        const double inside = tool[h].insertion - beyond[h];
        const double outside = pivot[h].shaft_length - tool[h].insertion;
        // Pushed away from the other shaft, the lever turns it round.
        const Vector3 expected = (h == 0 ? -1 : 1) * newton * inside / outside * normal;
        EXPECT_NEAR((output->device_force[h] - expected).norm(), 0, 0.005 * expected.norm()) << h;
        const HandSample& sample = output->sample.hand[h];
        EXPECT_EQ(sample.force[0] * sample.force[0] + sample.force[1] * sample.force[1] +
                      sample.force[2] * sample.force[2],
                  0)
            << "no tissue feels it";
        EXPECT_EQ(sample.tissue, -1);
    }
    return *output;
}

// The other instrument is felt at the hand as tissue is: through the lever, each hand by its own.
TEST(HandInWorld, FeelsTheOtherInstrumentThroughTheTrocar) {
    const Scene scene = load_scene(test::source_path("assets/scenes/a2_targets.json"));
    for (const double apart : {0.004, 0.0045, 0.02}) {
        World world(scene, 1);
        HapticLoop loop(scene, world);
        for (const Hand hand : {Hand::left, Hand::right}) loop.set_device(hand, test::ideal_device());
        const TickOutput& output = cross_shafts(loop, world, apart);
        EXPECT_EQ(output.device_force[0].norm() > 0.3, apart == 0.004) << apart;
    }
}

}  // namespace
}  // namespace fulcrum
