// SPDX-License-Identifier: Apache-2.0
// A world of bands and its haptic loop, with hands at poses set by the test.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim_core/haptics/loop.h"
#include "sim_core/world/parts/bands/bands_part.h"
#include "sim_core/world/world.h"
#include "tests/support/force_device.h"
#include "tests/support/support.h"

namespace fulcrum::test {

inline Scene bands_scene() {
    return load_scene(source_path("assets/scenes/b3_bands.json"));
}

class BandsStage {
  public:
    explicit BandsStage(const Scene& given = bands_scene(), std::uint64_t seed = 5)
        : scene(given),
          world(scene, seed),
          loop(scene, world),
          outputs(static_cast<std::size_t>(scene.ticks_per_step)) {
        for (const InstrumentSpec& spec : scene.instruments) {
            const int hand = static_cast<int>(spec.hand);
            trocar[hand] = make_trocar(spec.trocar);
            tip[hand] = trocar[hand].position + spec.start_insertion * trocar[hand].rotation.col(2);
            jaw[hand] = 0.8 * spec.jaw_opening;
            loop.set_device(spec.hand, test::ideal_device());
        }
    }

    /// One world step with the hands as set.
    void step() {
        for (TickOutput& output : outputs) {
            RigSample input;
            input.tick = ++tick;
            for (int hand = 0; hand < hand_count; ++hand) {
                DeviceReading reading;
                reading.handle = handle_for_tip(trocar[hand], tip[hand]);
                reading.jaw = jaw[hand];
                reading.grip = grip[hand];
                reading.buttons = buttons[hand];
                reading.present = !silent[hand];
                input.hand[hand] = last[hand] = quantise(reading, last[hand]);
            }
            output = loop.tick(input);
        }
        record = world.step(outputs.data(), outputs.size());
        loop.adopt(world.local_models());
    }
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(std::lround(seconds / scene.step_period())); ++i) step();
    }
    /// Moves a tip to a position in a straight line.
    void go(Hand hand, const Vector3& to, double seconds = 0.3) {
        const int h = static_cast<int>(hand);
        const Vector3 from = tip[h];
        const int steps = std::max(1, static_cast<int>(std::lround(seconds / scene.step_period())));
        for (int i = 1; i <= steps; ++i) {
            tip[h] = from + (to - from) * i / steps;
            step();
        }
    }
    /// Tip position for which the middle of the jaws is at a position.
    Vector3 tip_for_jaws(Hand hand, const Vector3& place) const {
        const int h = static_cast<int>(hand);
        const double half = 0.5 * scene.instrument(hand)->jaw_length;
        return place + half * (place - trocar[h].position).normalized();
    }
    void close(Hand hand, double force = 4) {
        jaw[static_cast<int>(hand)] = 0.05;
        grip[static_cast<int>(hand)] = force;
        run(0.05);
    }
    void open(Hand hand) {
        jaw[static_cast<int>(hand)] = 0.8 * scene.instrument(hand)->jaw_opening;
        grip[static_cast<int>(hand)] = 0;
        run(0.05);
    }
    /// Grasps a band with a hand at a fraction of its length from the root.
    void take(Hand hand, std::size_t band, double share) {
        const StrandState& strand = world.find<BandsPart>()->strand(band);
        const Vector3 place = strand.position[static_cast<std::size_t>(std::lround(share * strand_segments))];
        open(hand);
        go(hand, tip_for_jaws(hand, place + Vector3(0, 0, 0.02)));
        go(hand, tip_for_jaws(hand, place));
        close(hand);
    }
    void press(Hand hand, std::uint16_t mask, bool on) {
        std::uint16_t& now = buttons[static_cast<int>(hand)];
        now = static_cast<std::uint16_t>(on ? now | mask : now & ~mask);
    }
    /// Presses the exchange button until the hand holds that instrument and can use it.
    void exchange_to(Hand hand, InstrumentKind kind) {
        open(hand);
        for (int i = 0; i < 8 && field().tools[static_cast<int>(hand)].kind != kind; ++i) {
            press(hand, button_exchange, true);
            step();
            press(hand, button_exchange, false);
            run(scene.bands->exchange_time + 0.05);
        }
    }
    const FieldView& field() const { return world.snapshot().field[0]; }
    const std::vector<BandView>& bands() const { return world.snapshot().bands.bands; }
    const StructuresView& structures() const { return world.snapshot().structures; }
    Vector3 felt(Hand hand) const { return outputs.back().device_force[static_cast<int>(hand)]; }

    Scene scene;
    World world;
    HapticLoop loop;
    std::vector<TickOutput> outputs;
    Trocar trocar[hand_count];
    Vector3 tip[hand_count];
    double jaw[hand_count] = {0, 0}, grip[hand_count] = {0, 0};
    std::uint16_t buttons[hand_count] = {0, 0};
    bool silent[hand_count] = {false, false};  ///< the device does not answer
    DeviceSample last[hand_count];
    StepRecord record;
    std::uint32_t tick = 0;
};

}  // namespace fulcrum::test
