// SPDX-License-Identifier: GPL-3.0-or-later
// A DeviceRig on pages of memory that the test writes and reads.
#pragma once

#include <memory>

#include "app/live/device_rig.h"
#include "database/scoring/loaded_task.h"

namespace fulcrum::app::program_test {

/// Hands that do not move.
class RestingRig : public Rig {
  public:
    void read(std::uint32_t tick, RigSample& sample) override {
        sample.tick = tick;
        for (DeviceSample& hand : sample.hand) {
            hand.handle[0] = 77;
            hand.buttons = keys;
            hand.roll = roll;
        }
        sample.camera.handle[0] = 77;
        sample.camera.jaw = head;
    }
    void write_force(Hand, const Vector3&) override {}
    bool has_force(Hand) const override { return false; }
    double damping(Hand) const override { return -1; }
    std::uint16_t keys = button_none;
    std::int32_t roll = 0, head = 0;
};

struct OnPages {
    SharedPage<StatePage> state = SharedPage<StatePage>::create("test", true);
    SharedPage<CommandPage> command = SharedPage<CommandPage>::create("test", false);
    DeviceFacts facts;
    Scene scene = load_task_and_scene("A2").scene;
    DevicePose pose[device_slots];
    std::shared_ptr<RestingRig> others = std::make_shared<RestingRig>();
    std::unique_ptr<DeviceRig> rig;
    RigSample sample;
    std::uint32_t tick = 0;

    OnPages() {
        facts.slot[0] = facts.slot[1] = true;
        ForceOutput force;
        force.damping = 0.5;
        force.peak = 3.3;
        facts.force[0] = force;
        rig = std::make_unique<DeviceRig>(nullptr, *state.get(), *command.get(), facts, scene, others,
                                          SlotUse{}, 0.4);
        for (DevicePose& one : pose) {
            one.present = 1;
            one.jaw = 1;
        }
    }
    void publish() {
        for (int i = 0; i < device_slots; ++i) {
            ++pose[i].sequence;
            state->pose[i].write(pose[i]);
        }
    }
    void read() {
        if (overseen) ++state->overseer_time;
        rig->read(++tick, sample);
    }
    bool overseen = true;
    Vector3 handle(int hand) const {
        const auto& counts = sample.hand[hand].handle;
        return device_length_unit * Vector3(counts[0], counts[1], counts[2]);
    }
};

}  // namespace fulcrum::app::program_test
