// SPDX-License-Identifier: Apache-2.0
// Smoke or blood hide what is worked on: a hand exchanges its blade for suction, sucks where it stands, and
// takes the blade again.
#pragma once

#include <algorithm>

#include "assessment/operators/limb.h"
#include "assessment/operators/perception.h"

namespace fulcrum {

class SuctionTurn {
  public:
    explicit SuctionTurn(double reaction_s) : reaction_s_(reaction_s) {}

    bool wanted(const Perception& seen, const Limb& limb) const noexcept {
        if (limb.spec().exchange.empty() || limb.time() < over_ + least_pause_s) return false;
        if (seen.smoke > smoke_that_disturbs) return true;
        // What goes on bleeding is not stopped by suction: after some turns the work goes on beside it.
        return turns_ < most_turns && std::any_of(seen.outlets.begin(), seen.outlets.end(),
                                                  [](const OutletView& outlet) { return outlet.flow > 0; });
    }
    void begin() noexcept {
        wanted_ = ToolKind::suction;
        ++turns_;
    }
    /// The exchange button until the hand holds what it wants, the pedal while that is suction. True when the
    /// blade is back.
    bool update(const HandToolView& tool, Limb& limb) noexcept {
        if (limb.time() < until_) return false;
        limb.hold_buttons(0);
        if (sucking_) {
            sucking_ = false;
            over_ = limb.time();
            wanted_ = ToolKind::hook;
        }
        if (pressing_) {  // see what the press did before the next
            pressing_ = false;
            until_ = limb.time() + reaction_s_ + 0.1;
            return false;
        }
        if (tool.exchange_left > 0) return false;
        if (tool.kind != wanted_) {
            limb.hold_buttons(button_exchange);
            pressing_ = true;
            until_ = limb.time() + press_s;
            return false;
        }
        if (wanted_ == ToolKind::hook) return true;
        limb.hold_buttons(button_energy);
        sucking_ = true;
        until_ = limb.time() + suck_s;
        return false;
    }

  private:
    static constexpr double smoke_that_disturbs = 0.30;  // share of light
    static constexpr double suck_s = 1.2, least_pause_s = 8;
    static constexpr double press_s = 0.08;  // a button is pressed that long
    double reaction_s_, over_ = -1e9, until_ = 0;
    ToolKind wanted_ = ToolKind::hook;
    static constexpr int most_turns = 2;
    int turns_ = 0;
    bool pressing_ = false, sucking_ = false;
};

}  // namespace fulcrum
