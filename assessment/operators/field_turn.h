// SPDX-License-Identifier: Apache-2.0
// When smoke or blood hides the field, a hand exchanges its blade for suction and removes it, then clips
// vessels that still bleed, and takes the blade again.
#pragma once

#include <algorithm>

#include "assessment/operators/behaviour.h"

namespace fulcrum {

class FieldTurn {
  public:
    explicit FieldTurn(const Skill& skill) : skill_(skill), reach_(skill) {}

    bool wanted(const Perception& seen, const Limb& limb) const noexcept {
        if (limb.spec().exchange.empty() || limb.time() < over_ + least_pause_s) return false;
        // A vessel that still bleeds after several attempts is left, and the work continues.
        return seen.smoke > smoke_that_disturbs || (turns_ < most_turns && worst_outlet(seen) >= 0);
    }
    void begin(const Perception& seen) noexcept {
        outlet_ = worst_outlet(seen);
        turns_ += outlet_ >= 0 ? 1 : 0;
        clips_ = 0;
        wanted_ = InstrumentKind::suction;
        stage_ = Stage::exchange;
    }
    /// True when the blade is back in the hand.
    bool update(const Perception& seen, Body& body, int hand) noexcept {
        Limb& limb = *body.limb[hand];
        const HandToolView& tool = seen.tools[hand];
        switch (stage_) {
            case Stage::exchange:
                if (!exchanged(tool, limb)) return false;
                if (wanted_ == InstrumentKind::hook) {
                    over_ = limb.time();
                    return true;
                }
                if (wanted_ == InstrumentKind::clip_applier) open(limb);
                if (outlet_ >= 0)
                    go(seen, body, limb, hover, Stage::above);
                else
                    work(limb);
                return false;
            case Stage::above:
                if (near(seen, hand, limb, hover, 8)) go(seen, body, limb, 0, Stage::down);
                return false;
            case Stage::down:
                if (near(seen, hand, limb, 0, 3)) work(limb);
                return false;
            case Stage::work:
                if (limb.time() >= until_) judge(seen, body, tool, limb);
                return false;
        }
        return false;
    }

  private:
    enum class Stage : std::uint8_t { exchange, above, down, work };
    static constexpr double smoke_that_disturbs = 0.30;  // share of light
    static constexpr double suck_s = 1.2, close_s = 0.5, least_pause_s = 8;
    static constexpr double press_s = 0.08;  // a button is pressed that long
    static constexpr double hover = 0.015;   // m off the wall, on the way to a bleeding point
    static constexpr double off = 0.002;     // m off the wall, of a mouth or jaws at work
    static constexpr double open_share = 0.8, closed_share = 0.05, clip_grip = 4;  // jaws; N
    static constexpr int most_turns = 4, most_clips = 3;

    /// Presses the exchange button until the hand holds the wanted instrument.
    bool exchanged(const HandToolView& tool, Limb& limb) noexcept {
        if (limb.time() < until_) return false;
        limb.hold_buttons(0);
        if (pressing_) {  // see what the press did before the next
            pressing_ = false;
            until_ = limb.time() + skill_.reaction_s + 0.1;
            return false;
        }
        if (tool.exchange_left > 0) return false;
        if (tool.kind == wanted_) return true;
        limb.hold_buttons(button_exchange);
        pressing_ = true;
        until_ = limb.time() + press_s;
        return false;
    }
    /// A point in front of the bleeding, along the shaft.
    Vector3 place(const Perception& seen, const Limb& limb, double away) const noexcept {
        const Vector3& point = seen.outlets[static_cast<std::size_t>(outlet_)].position;
        return point + (off + away) * (limb.trocar().position - point).normalized();
    }
    void go(const Perception& seen, const Body& body, Limb& limb, double away, Stage next) noexcept {
        reach_.start(limb, place(seen, limb, away), body.view, away > 0 ? 0.015 : 0.006, 0, 3);
        stage_ = next;
    }
    bool near(const Perception& seen, int hand, Limb& limb, double away, double patience) noexcept {
        const Vector3 goal = place(seen, limb, away);
        reach_.follow(goal);
        reach_.update(limb, seen.tip[hand]);
        return reach_.arrived() || (reach_.corrections() > 0 && limb.remaining() < 0.05 &&
                                    (limb.destination() - goal).norm() < patience * skill_.tolerance);
    }
    /// The pedal of the suction, or the jaws of the applier.
    void work(Limb& limb) noexcept {
        stage_ = Stage::work;
        if (wanted_ == InstrumentKind::suction) {
            limb.hold_buttons(button_energy);
            until_ = limb.time() + suck_s;
        } else {
            limb.jaws(closed_share * limb.spec().jaw_opening, clip_grip);
            until_ = limb.time() + close_s + skill_.reaction_s;
        }
    }
    void judge(const Perception& seen, Body& body, const HandToolView& tool, Limb& limb) noexcept {
        limb.hold_buttons(0);
        const int bleeding = worst_outlet(seen);
        open(limb);
        const bool clip = bleeding >= 0 && tool.clips_left > 0 && clips_ < most_clips;
        if (wanted_ == InstrumentKind::clip_applier && clip) {  // next to it, or another one
            ++clips_;
            outlet_ = bleeding;
            go(seen, body, limb, hover, Stage::above);
            return;
        }
        if (outlet_ >= 0)
            limb.carry(hover * (limb.trocar().position - limb.destination()).normalized(),
                       0.4 * skill_.duration_scale);
        wanted_ =
            wanted_ == InstrumentKind::suction && clip ? InstrumentKind::clip_applier : InstrumentKind::hook;
        outlet_ = wanted_ == InstrumentKind::clip_applier ? bleeding : -1;
        until_ = limb.time();
        stage_ = Stage::exchange;
    }
    static void open(Limb& limb) noexcept { limb.jaws(open_share * limb.spec().jaw_opening, 0); }

    Skill skill_;
    Reach reach_;
    Stage stage_ = Stage::exchange;
    InstrumentKind wanted_ = InstrumentKind::hook;
    double over_ = -1e9, until_ = 0;
    int outlet_ = -1, turns_ = 0, clips_ = 0;
    bool pressing_ = false;
};

}  // namespace fulcrum
