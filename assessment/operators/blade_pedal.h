// SPDX-License-Identifier: Apache-2.0
// When the pedal of a blade with energy is down. An operator with foresight activates energy in contact with
// the tissue, in short activations, releases the pedal before the rim, and divides cold near a nerve. An
// operator without foresight presses the pedal while approaching and holds it until the blade is out again.
#pragma once

#include <algorithm>

#include "assessment/operators/limb.h"
#include "assessment/operators/perception.h"

namespace fulcrum {

class BladePedal {
  public:
    /// `energy`: the blade has any.
    BladePedal(const Skill& skill, bool energy) : skill_(skill), energy_(energy) {}

    /// A stroke is planned.
    void plan(Limb& limb) noexcept {
        if (!energy_) return;
        // With a little foresight an operator avoids the nerves, with more also the tissue next to them.
        const double careless = (1 - skill_.plane.care) * (1 - skill_.plane.care);
        waits_ = limb.random().uniform() >= careless;
        spares_ = limb.random().uniform() >= careless * careless;
        late_s_ = waits_ ? 0 : late_by_hesitation_s * skill_.hesitation * limb.random().uniform(0.5, 1.5);
        since_ = -1;
    }
    /// The blade is on its way to the tissue, or presses on it.
    void press(Limb& limb, const Perception& seen, int hand, bool felt) noexcept {
        if (energy_ && (felt || !waits_) && clear(seen, hand)) down(limb);
    }
    /// The blade divides; `left` m of the stroke are to go.
    void stroke(Limb& limb, const Perception& seen, int hand, double left) noexcept {
        if (!energy_) return;
        if (!waits_) {
            clear(seen, hand) ? down(limb) : up(limb);
            return;
        }
        if (since_ >= 0 && limb.time() > since_ + burst_s + rest_s) since_ = -1;
        const bool rests = since_ >= 0 && limb.time() > since_ + burst_s;
        if (left < let_go_before || !seen.display.cutting || !clear(seen, hand) || rests)
            up(limb);
        else
            down(limb);
    }
    /// The blade is drawn back.
    void lift(Limb& limb) noexcept {
        if (!energy_ || !(waits_ || limb.time() > lifted_ + late_s_)) return;
        up(limb);
    }
    void lifted(const Limb& limb) noexcept { lifted_ = limb.time(); }

  private:
    static constexpr double burst_s = 0.8, rest_s = 0.2;  // of an activation, and until the next
    static constexpr double let_go_before = 0.004;        // m of the stroke's end
    static constexpr double late_by_hesitation_s = 0.2;
    static constexpr double from_nerve = 0.012;  // m from the tip to a nerve's axis: nearer is too hot for it
    bool clear(const Perception& seen, int hand) const noexcept {
        return !spares_ || std::none_of(seen.nerve.begin(), seen.nerve.end(), [&](const Vector3& point) {
            return (point - seen.tip[hand]).norm() < from_nerve;
        });
    }
    void down(Limb& limb) noexcept {
        if (since_ < 0) since_ = limb.time();
        limb.hold_buttons(button_energy);
    }
    static void up(Limb& limb) noexcept { limb.hold_buttons(0); }

    Skill skill_;
    bool energy_ = false, waits_ = true, spares_ = true;
    double since_ = -1, lifted_ = 0, late_s_ = 0;
};

}  // namespace fulcrum
