// SPDX-License-Identifier: Apache-2.0
// Two hands at the scene of a sheet, or of other tissue, ticked and stepped in one thread; a scope alone
// where the scene has no instruments.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "sim_core/haptics/loop.h"
#include "sim_core/world/parts/sheet/sheet_part.h"
#include "sim_core/world/world.h"
#include "tests/support/force_device.h"
#include "tests/support/support.h"

namespace fulcrum::test {

inline Scene sheet_scene() {
    return load_scene(source_path("assets/scenes/b2_areolar.json"));
}

/// Target pose of one hand.
struct Wish {
    Vector3 tip = Vector3::Zero();  ///< m, patient frame
    bool closed = false, button = false, energy = false, exchange = false;
    double roll = 0;      ///< rad, about the shaft
    bool silent = false;  ///< its device does not answer: the instrument stays where it was
};

struct SheetRig {
    Scene scene;
    World world;
    HapticLoop loop;
    std::vector<TickOutput> outputs;
    Trocar trocar[hand_count];
    DeviceSample last[hand_count];
    Wish wish[hand_count];
    std::optional<Vector3> lens;  ///< of the camera, m, patient frame; none: where it begins
    Vector3 asked[hand_count];    ///< requested tip positions at the last step
    double asked_roll[hand_count] = {0, 0};
    double squeeze[hand_count] = {0, 0};
    std::uint32_t tick = 0;
    std::uint64_t hash = 0;
    StepRecord record;
    std::vector<Event> events;
    /// Of each tick, N: largest change of the force on a hand from the tick before, and the force.
    double worst_change = 0, largest_force = 0;
    Vector3 sent[hand_count] = {Vector3::Zero(), Vector3::Zero()};

    explicit SheetRig(const Scene& chosen = sheet_scene())
        : scene(chosen), world(scene, 1), loop(scene, world), outputs(5) {
        for (int h = 0; h < hand_count; ++h) {
            if (!has(h)) continue;
            trocar[h] = make_trocar(scene.instruments[static_cast<std::size_t>(h)].trocar);
            last[h] = start_sample(scene.instruments[static_cast<std::size_t>(h)].trocar, 0.10);
            const Vector3 middle = scene.sheet ? scene.sheet->centre : Vector3(0, 0.04, -0.01);
            loop.set_device(static_cast<Hand>(h), test::desk_device());
            wish[h].tip = asked[h] = middle + Vector3(h == 0 ? 0.04 : -0.04, 0, 0.05);
        }
    }
    const SheetPart& sheet() const { return *world.find<SheetPart>(); }
    const SheetHand& hand(int h) const { return sheet().state().hands[static_cast<std::size_t>(h)]; }

    bool has(int h) const { return scene.instrument(static_cast<Hand>(h)) != nullptr; }
    DeviceSample camera_sample() const {
        if (!lens) return start_sample(scene.camera->trocar, scene.camera->start_insertion);
        DeviceReading reading;
        reading.handle = handle_for_tip(make_scope(*scene.camera).trocar, *lens);
        return quantise(reading, {});
    }

    void step() {
        for (int i = 0; i < 5; ++i) {
            RigSample input;
            input.tick = ++tick;
            for (int h = 0; h < hand_count; ++h) {
                if (!has(h)) continue;
                DeviceReading reading;
                const Vector3 tip = asked[h] + 0.2 * (i + 1) * (wish[h].tip - asked[h]);
                reading.handle = handle_for_tip(trocar[h], tip);
                reading.roll = asked_roll[h] + 0.2 * (i + 1) * (wish[h].roll - asked_roll[h]);
                // Fingers take 40 ms.
                squeeze[h] = std::clamp(squeeze[h] + (wish[h].closed ? 0.025 : -0.025), 0.0, 1.0);
                reading.jaw = 1 - squeeze[h];
                reading.grip = 8 * squeeze[h];
                reading.buttons =
                    static_cast<std::uint16_t>((wish[h].button ? button_primary : button_none) |
                                               (wish[h].energy ? button_energy : button_none) |
                                               (wish[h].exchange ? button_exchange : button_none));
                reading.present = !wish[h].silent;
                input.hand[h] = last[h] = quantise(reading, last[h]);
            }
            if (scene.camera) input.camera = camera_sample();
            outputs[static_cast<std::size_t>(i)] = loop.tick(input);
            for (int h = 0; h < hand_count; ++h) {
                const Vector3& force = outputs[static_cast<std::size_t>(i)].device_force[h];
                worst_change = std::max(worst_change, (force - sent[h]).norm());
                largest_force = std::max(largest_force, force.norm());
                sent[h] = force;
            }
        }
        for (int h = 0; h < hand_count; ++h) {
            asked[h] = wish[h].tip;
            asked_roll[h] = wish[h].roll;
        }
        record = world.step(outputs.data(), outputs.size());
        hash = hash * 31 + record.state_hash;
        loop.adopt(world.local_models());
        const WorldSnapshot& snapshot = world.snapshot();
        for (std::int32_t e = 0; e < snapshot.event_count; ++e)
            events.push_back(snapshot.events[static_cast<std::size_t>(e)]);
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) step();
    }
    /// Moves a tip in a straight line at a speed (m/s), the other hand still.
    void go(int h, const Vector3& to, double speed) {
        const Vector3 from = wish[h].tip;
        const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / (speed * 0.005))));
        for (int i = 1; i <= count; ++i) {
            wish[h].tip = from + (static_cast<double>(i) / count) * (to - from);
            step();
        }
    }
    int count(EventKind kind) const {
        int sum = 0;
        for (const Event& event : events) sum += event.kind == kind ? 1 : 0;
        return sum;
    }
    /// Position of the left tip for which the middle of its jaws is at the given point.
    Vector3 tip_for(const Vector3& jaws) const {
        Vector3 tip = jaws;
        for (int i = 0; i < 20; ++i)
            tip = jaws + 0.5 * scene.instruments[0].jaw_length * (tip - trocar[0].position).normalized();
        return tip;
    }
    /// Left jaws grasp the flap edge at x (m along the line from the middle) and move it by `displacement`.
    void hold_flap(double x, const Vector3& displacement) {
        hold_at(x, 0.45 * scene.sheet->width, displacement);
    }
    void hold_at(double x, double y, const Vector3& displacement) {
        const Vector3 place = scene.sheet->centre + x * scene.sheet->along + y * scene.sheet->across;
        go(0, tip_for(place + Vector3(0, 0, 0.02)), 0.2);
        go(0, tip_for(place + Vector3(0, 0, 0.001)), 0.1);
        steps(5);
        wish[0].closed = true;
        steps(20);
        go(0, tip_for(place + displacement), 0.05);
    }
};

}  // namespace fulcrum::test
