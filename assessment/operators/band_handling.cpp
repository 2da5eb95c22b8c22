// SPDX-License-Identifier: Apache-2.0
// Bands, one after another: the left hand grasps and lifts, the right hand divides with the shears. Bleeding
// is clipped at once; smoke and blood are removed by suction.
#include <algorithm>
#include <cmath>
#include <vector>

#include "assessment/operators/behaviour.h"

namespace fulcrum {
namespace {

constexpr double hover = 0.022;                          // m above the place, while approaching
constexpr double open_share = 0.8, closed_share = 0.08;  // of the widest opening
constexpr double shortest_close_s = 0.4;
constexpr double longest_burn_s = 9;
constexpr double press_s = 0.08;              // duration of a button press
constexpr double smoke_that_disturbs = 0.25;  // share of light
constexpr double suck_s = 1.5;
constexpr int clip_attempts = 4;
constexpr double near_enough = 0.012;     // m, of a point that is only passed
constexpr double clear_of_nerve = 0.009;  // m between the blade's line and the nerve's, as planned

enum class Stage : std::uint8_t {
    choose,
    hold_above,
    hold_down,
    hold_close,
    lift,
    cut_above,
    cut_down,
    cut_close,
    burn,
    let_go,
    swap,
    clip_above,
    clip_down,
    clip_close,
    clip_open,
    suck,
    wait
};

class BandHandling : public Behaviour {
  public:
    BandHandling(const Scene& scene, const Skill& skill)
        : skill_(skill), spec_(*scene.bands), reaches_{Reach(skill), Reach(skill)} {
        for (const InstrumentSpec& instrument : scene.instruments)
            jaw_length_[static_cast<int>(instrument.hand)] = instrument.jaw_length;
    }

    void decide(const Perception& seen, Body& body) noexcept override {
        if (seen.display.ended || seen.bands.empty()) return;
        Limb& left = *body.limb[0];
        Limb& right = *body.limb[1];
        if (!begun_) {
            begun_ = true;
            for (Limb* const limb : body.limb) {
                limb->steady(skill_.plane.steadiness);
                open(*limb);
            }
        }
        if (right.time() > release_) right.hold_buttons(0);
        switch (stage_) {
            case Stage::choose:
                choose(seen, body);
                break;
            case Stage::hold_above:
                travel(0, seen, body, Stage::hold_down);
                break;
            case Stage::hold_down:
                descend(0, seen, body, Stage::hold_close, skill_.grip_force);
                break;
            case Stage::hold_close:
                hold_close(seen, body);
                break;
            case Stage::lift:
                if (left.remaining() < 0.03) go(1, cut_node_, body, Stage::cut_above);
                break;
            case Stage::cut_above:
                travel(1, seen, body, Stage::cut_down);
                break;
            case Stage::cut_down:
                descend(1, seen, body, Stage::cut_close, skill_.grip_force);
                break;
            case Stage::cut_close:
                cut_close(seen, body);
                break;
            case Stage::burn:
                burn(seen, body);
                break;
            case Stage::let_go:
                // Jaws open when the pedal is up.
                if (divided_ && right.time() > release_) {
                    divided_ = false;
                    open(right);
                    open(left);
                }
                if (right.time() > until_) {
                    retract(right);
                    retract(left);
                    stage_ = Stage::choose;
                }
                break;
            case Stage::swap:
                swap(seen, body);
                break;
            case Stage::clip_above:
                travel(1, seen, body, Stage::clip_down);
                break;
            case Stage::clip_down:
                descend(1, seen, body, Stage::clip_close, skill_.grip_force);
                break;
            case Stage::clip_close:
                clip_close(seen, body);
                break;
            case Stage::clip_open:
                clip_open(seen, body);
                break;
            case Stage::suck:
                if (right.time() > until_) {
                    right.hold_buttons(0);
                    stage_ = Stage::choose;
                }
                break;
            case Stage::wait:
                if (right.time() > until_) stage_ = Stage::choose;
                break;
        }
        body.gaze = place(seen);
    }

  private:
    /// What is worked on, m.
    Vector3 place(const Perception& seen) const noexcept {
        if (outlet_ >= 0) return seen.outlets[static_cast<std::size_t>(outlet_)].position;
        const auto band = static_cast<std::size_t>(std::max(0, band_));
        const int node = stage_ >= Stage::cut_above ? cut_node_ : hold_node_;
        return seen.bands[band].position[static_cast<std::size_t>(node)];
    }

    void choose(const Perception& seen, Body& body) noexcept {
        Limb& right = *body.limb[1];
        open(*body.limb[0]);
        open(right);
        const InstrumentKind kind = seen.tools[1].kind;
        const int bleeding = worst_outlet(seen);
        if (bleeding >= 0) {
            outlet_ = bleeding;
            attempts_ = 0;
            if (seen.tools[1].clips_left <= 0) outlet_ = -1;  // no clips left: continue
        } else {
            outlet_ = -1;
        }
        if (outlet_ >= 0) {
            wanted_ = InstrumentKind::clip_applier;
            if (kind != wanted_ || seen.tools[1].exchange_left > 0) {
                stage_ = Stage::swap;
                return;
            }
            go_to_outlet(seen, body);
            return;
        }
        band_ = -1;
        for (std::size_t b = 0; b < seen.bands.size() && band_ < 0; ++b) {
            if (!seen.bands[b].divided()) band_ = static_cast<int>(b);
        }
        if (band_ < 0) {
            band_ = 0;
            stage_ = Stage::wait;
            until_ = right.time() + 0.5;
            return;
        }
        wanted_ = InstrumentKind::harmonic;
        if (kind != wanted_ || seen.tools[1].exchange_left > 0) {
            stage_ = Stage::swap;
            return;
        }
        plan_band(seen, body);
        go(0, hold_node_, body, Stage::hold_above, skill_.choice_s * right.random().uniform(0.6, 1.4));
    }

    /// Where to hold and where to divide: an operator with foresight divides on the side away from the nerve.
    void plan_band(const Perception& seen, Body& body) noexcept {
        Random& random = body.limb[1]->random();
        const BandView& band = seen.bands[static_cast<std::size_t>(band_)];
        static constexpr int near_root = 4, near_end = 8;
        const auto away = [&](int node) {
            double least = 1;
            for (const Vector3& point : seen.nerve) {
                const Vector3 apart = point - band.position[static_cast<std::size_t>(node)];
                least = std::min(least, std::sqrt(apart.x() * apart.x() + apart.y() * apart.y()));
            }
            return least;
        };
        cut_node_ = near_root;
        const bool looks = random.uniform() < skill_.foresight;
        if (looks && away(near_root) < clear_of_nerve && away(near_end) > away(near_root))
            cut_node_ = near_end;
        hold_node_ = cut_node_ == near_root ? 9 : 3;
    }

    void go(int hand, int node, Body& body, Stage next, double delay = 0) noexcept {
        node_[hand] = node;
        stage_ = next;
        started_[hand] = false;
        delay_ = delay;
        open(*body.limb[hand]);
    }

    Vector3 goal(int hand, const Perception& seen, const Body& body) const noexcept {
        const Limb& limb = *body.limb[hand];
        Vector3 target;
        if (outlet_ >= 0 && hand == 1) {
            target = seen.outlets[static_cast<std::size_t>(outlet_)].position +
                     Vector3(0, 0, 0.003 - 0.001 * attempts_);
        } else {
            target =
                seen.bands[static_cast<std::size_t>(band_)].position[static_cast<std::size_t>(node_[hand])];
        }
        return target + 0.5 * jaw_length_[hand] * (target - limb.trocar().position).normalized();
    }

    void travel(int hand, const Perception& seen, Body& body, Stage next) noexcept {
        Limb& limb = *body.limb[hand];
        Reach& reach = reaches_[hand];
        const Vector3 above = goal(hand, seen, body) + Vector3(0, 0.004, hover);
        if (!started_[hand]) {
            reach.start(limb, above, body.view, 0.015, delay_, 4);
            started_[hand] = true;
        }
        reach.follow(above);
        reach.update(limb, seen.tip[hand]);
        if (!reach.started()) return;
        if (reach.arrived() ||
            ((limb.destination() - above).norm() < near_enough && limb.remaining() < 0.1)) {
            stage_ = next;
            reach.start(limb, goal(hand, seen, body), body.view, 0.008, 0, 2.5);
        }
    }

    void descend(int hand, const Perception& seen, Body& body, Stage next, double grip) noexcept {
        Limb& limb = *body.limb[hand];
        Reach& reach = reaches_[hand];
        reach.follow(goal(hand, seen, body));
        reach.update(limb, seen.tip[hand]);
        if (!reach.arrived()) return;
        stage_ = next;
        limb.jaws(closed_share * limb.spec().jaw_opening,
                  std::max(2.0, grip + skill_.grip_spread * limb.random().normal()));
        until_ = limb.time() + std::max(shortest_close_s, skill_.dwell_s) + skill_.reaction_s + 0.05;
    }

    void hold_close(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[0];
        if (limb.time() < until_) return;
        if (seen.grasps[0].held && seen.grasps[0].patch == band_) {
            stage_ = Stage::lift;
            const double lift = (0.001 + 0.003 * skill_.traction.band * skill_.comfortable_force) *
                                limb.random().uniform(0.8, 1.2);
            limb.carry(Vector3(0, 0, lift), std::max(0.3, lift / skill_.lift_speed));
            return;
        }
        miss(limb, body);
    }

    void cut_close(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[1];
        if (limb.time() < until_) return;
        if (seen.grasps[1].held && seen.grasps[1].patch == band_) {
            stage_ = Stage::burn;
            limb.hold_buttons(button_energy);
            release_ = limb.time() + longest_burn_s;
            until_ = release_;
            return;
        }
        miss(limb, body);
    }

    // Nothing between the jaws: open, back off, choose again.
    void miss(Limb& limb, Body& body) noexcept {
        open(limb);
        stage_ = Stage::let_go;
        until_ = std::max(body.limb[1]->time(), limb.time()) + skill_.dwell_s;
    }

    void burn(const Perception& seen, Body& body) noexcept {
        Limb& right = *body.limb[1];
        if (!seen.bands[static_cast<std::size_t>(band_)].divided() && right.time() < until_) return;
        // A hesitant operator keeps the pedal down a little longer.
        release_ = right.time() + 0.15 * skill_.hesitation;
        stage_ = Stage::let_go;
        until_ = release_ + 0.5 * skill_.dwell_s + 0.2;
        divided_ = true;
    }

    void go_to_outlet(const Perception& /*seen*/, Body& body) noexcept {
        go(1, 0, body, Stage::clip_above, skill_.choice_s * body.limb[1]->random().uniform(0.4, 1.0));
    }

    // Presses the exchange button until the hand holds the wanted instrument.
    void swap(const Perception& seen, Body& body) noexcept {
        Limb& right = *body.limb[1];
        if (right.time() < until_swap_) return;
        const HandToolView& tool = seen.tools[1];
        if (tool.exchange_left > 0) return;
        if (tool.kind == wanted_) {
            stage_ = Stage::choose;
            return;
        }
        if (tool.kind == InstrumentKind::suction && seen.smoke > smoke_that_disturbs &&
            sucked_ < right.time()) {
            stage_ = Stage::suck;
            right.hold_buttons(button_energy);
            release_ = until_ = right.time() + suck_s;
            sucked_ = right.time() + 10;
            return;
        }
        right.hold_buttons(button_exchange);
        release_ = right.time() + press_s;
        until_swap_ = right.time() + press_s + skill_.reaction_s + 0.1;
    }

    void clip_close(const Perception& seen, Body& body) noexcept {
        Limb& right = *body.limb[1];
        if (right.time() < until_) return;
        const bool stopped = outlet_ < 0 || seen.outlets[static_cast<std::size_t>(outlet_)].flow <= 0;
        open(right);
        attempts_ = stopped ? 0 : attempts_ + 1;
        stage_ = Stage::clip_open;
        until_ = right.time() + skill_.dwell_s;
        stopped_ = stopped;
    }

    void clip_open(const Perception& seen, Body& body) noexcept {
        Limb& right = *body.limb[1];
        if (right.time() < until_) return;
        if (!stopped_ && attempts_ < clip_attempts && seen.tools[1].clips_left > 0) {
            reaches_[1].start(right, goal(1, seen, body), body.view, 0.008, 0, 2.5);
            stage_ = Stage::clip_down;
            return;
        }
        retract(right);
        outlet_ = -1;
        stage_ = Stage::choose;
    }

    void open(Limb& limb) noexcept { limb.jaws(open_share * limb.spec().jaw_opening, 0); }
    void retract(Limb& limb) noexcept {
        const Vector3 out = (limb.trocar().position - limb.destination()).normalized();
        limb.carry(0.012 * out + Vector3(0, 0, 0.010), 0.4 * skill_.duration_scale);
    }

    Skill skill_;
    BandsSpec spec_;
    Reach reaches_[hand_count];
    double jaw_length_[hand_count] = {0.016, 0.014};
    Stage stage_ = Stage::choose;
    InstrumentKind wanted_ = InstrumentKind::harmonic;
    bool begun_ = false, stopped_ = false, started_[hand_count] = {false, false};
    bool divided_ = false;  // the held tissue is divided: the jaws wait for the pedal
    int band_ = 0, outlet_ = -1, hold_node_ = 9, cut_node_ = 4, node_[hand_count] = {9, 4}, attempts_ = 0;
    double until_ = 0, until_swap_ = 0, release_ = 0, delay_ = 0, sucked_ = 0;
};

}  // namespace

std::unique_ptr<Behaviour> make_band_handling(const TaskDefinition& /*task*/, const Scene& scene,
                                              const Skill& skill) {
    return std::make_unique<BandHandling>(scene, skill);
}

}  // namespace fulcrum
