// SPDX-License-Identifier: Apache-2.0
// Rings on a tray: one hand takes and lifts a ring, the other takes it in the air and puts it around a peg of
// its own side.
#include <algorithm>
#include <cmath>
#include <vector>

#include "assessment/operators/behaviour.h"

namespace fulcrum {
namespace {

constexpr double hover = 0.015;                           // m above the place of a grasp, while approaching
constexpr double above_pegs = 0.010;                      // m between a carried ring and the pegs' tops
constexpr double handover_height = 0.016;                 // m above the pegs' tops
constexpr double tip_above_tube = 0.001;                  // m: the jaws close around the tube near their tips
constexpr double peg_inside = 0.4;                        // of its height: there a ring is let go
constexpr double open_share = 0.85, closed_share = 0.12;  // of the widest opening
constexpr double shortest_close_s = 0.35;                 // time for the jaws to close
constexpr double carry_speed = 3;                         // times the speed at which tissue is moved
constexpr double both_hold_s = 0.25;                      // longer than the goal asks: seen, then let go
constexpr int attempts_at_a_tube = 3, attempts_at_a_peg = 3;
constexpr double laid_height = 0.0008;  // m above the tray, of a ring that is laid down to be taken again
constexpr double anticipation = 0.25;   // largest share of handovers in which the giving hand opens too early
constexpr double longest_wait_s = 1.5;  // for a ring to count
constexpr double longest_stage_s = 12;  // then the hand begins again

enum class Stage : std::uint8_t {
    choose,
    approach,
    descend,
    close,
    lift,
    present,
    other_approach,
    other_descend,
    other_close,
    hand_over,
    carry,
    centre,
    lower,
    let_go
};

class ObjectHandling : public Behaviour {
  public:
    ObjectHandling(const TaskDefinition& task, const Scene& scene, const Skill& skill)
        : skill_(skill), goals_(task.goals), reaches_{Reach(skill), Reach(skill)} {
        peg_height_ = scene.objects->peg_height;
        tray_ = scene.objects->centre;
    }

    void decide(const Perception& seen, Body& body) noexcept override {
        if (seen.display.ended || seen.display.goal < 0 ||
            static_cast<std::size_t>(seen.display.goal) >= goals_.size() || seen.objects.empty())
            return;
        if (seen.display.goal != goal_) begin_goal(seen.display.goal, body);
        Limb& limb = *body.limb[mover_];
        if (ring_ >= 0 && lost(seen, limb.time())) give_up(seen, body);
        switch (stage_) {
            case Stage::choose:
                choose(seen, body);
                break;
            case Stage::approach:
            case Stage::other_approach:
                approach(seen, body);
                break;
            case Stage::descend:
            case Stage::other_descend:
                descend(seen, body);
                break;
            case Stage::close:
            case Stage::other_close:
                close(seen, body);
                break;
            case Stage::lift:
                if (limb.remaining() <= 0) begin_reach(body, Stage::present, handover_tip(seen), 0.012, 6);
                break;
            case Stage::present:
                if (reached(seen, body, handover_tip(seen))) begin_other(seen, body);
                break;
            case Stage::hand_over:
                hand_over(seen, body);
                break;
            case Stage::carry:
                if (reached(seen, body, tip_for_ring(seen, over_peg(body))))
                    begin_reach(body, Stage::centre, tip_for_ring(seen, over_peg(body)), 0.004, 2.5);
                break;
            case Stage::centre:
                if (reached(seen, body, tip_for_ring(seen, over_peg(body)))) begin_lowering(seen, body);
                break;
            case Stage::lower:
                lower(seen, body);
                break;
            case Stage::let_go:
                let_go(body);
                break;
        }
        if (ring_ >= 0) body.gaze = seen.objects[ring()].position;
    }

  private:
    void begin_goal(int goal, Body& body) noexcept {
        goal_ = goal;
        giver_ = static_cast<int>(goals_[static_cast<std::size_t>(goal)].hand);
        mover_ = giver_;
        ring_ = -1;
        for (int hand = 0; hand < hand_count; ++hand) open(*body.limb[hand]);
        enter(Stage::choose, *body.limb[mover_]);
    }

    std::size_t ring() const noexcept { return static_cast<std::size_t>(ring_); }
    void enter(Stage stage, const Limb& limb) noexcept {
        stage_ = stage;
        entered_ = limb.time();
    }
    bool holds(const Perception& seen, int hand) const noexcept {
        return seen.grasps[hand].held && seen.grasps[hand].body == HeldBody::object &&
               seen.grasps[hand].patch == ring_;
    }
    Hand target_side() const noexcept { return giver_ == 0 ? Hand::right : Hand::left; }

    /// What ought to be held is not any more, or a stage does not come to its end.
    bool lost(const Perception& seen, double now) const noexcept {
        if (now - entered_ > longest_stage_s) return true;
        if (now - entered_ < skill_.reaction_s + 0.1) return false;
        switch (stage_) {
            case Stage::lift:
            case Stage::present:
            case Stage::other_approach:
            case Stage::other_descend:
            case Stage::other_close:
                return !holds(seen, giver_);
            case Stage::carry:
            case Stage::centre:
            case Stage::lower:
                return !holds(seen, 1 - giver_);
            default:
                return false;
        }
    }

    // Everything is let go of and both hands go out of the way.
    void give_up(const Perception& seen, Body& body) noexcept {
        for (int hand = 0; hand < hand_count; ++hand) {
            if (!seen.grasps[hand].held && body.limb[hand]->jaw() > 0.5 * body.limb[hand]->spec().jaw_opening)
                continue;
            open(*body.limb[hand]);
            retract(*body.limb[hand]);
        }
        mover_ = giver_;
        ring_ = -1;
        enter(Stage::choose, *body.limb[mover_]);
    }

    // The nearest ring that does not count yet, and the peg for it. One that lies around a peg of the target
    // side and does not count is taken last: it has to be brought back and handed over once more.
    void choose(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        if (limb.remaining() > 0) return;
        const std::vector<PegView>& pegs = body.eyes->tray().pegs;
        bool taken[2 * ObjectsSpec::most] = {};
        double nearest = 1e9;
        int found = -1;
        for (std::size_t i = 0; i < seen.objects.size(); ++i) {
            const ObjectView& object = seen.objects[i];
            if (object.peg >= 0) taken[static_cast<std::size_t>(object.peg)] = true;
            if ((seen.display.rings_placed >> i & 1U) != 0) continue;
            double away = (object.position - limb.destination()).norm();
            if (object.peg >= 0 && pegs[static_cast<std::size_t>(object.peg)].side == target_side()) {
                if (limb.time() - entered_ < longest_wait_s) continue;  // it may be coming to rest
                away += 1;
            }
            if (away >= nearest) continue;
            nearest = away;
            found = static_cast<int>(i);
        }
        if (found < 0) return;
        ring_ = found;
        peg_ = -1;
        const std::int32_t own = seen.objects[ring()].peg;
        if (own >= 0) taken[static_cast<std::size_t>(own)] = false;
        laying_ = false;
        // The peg farthest from the taking hand's own instrument first: no placed ring is in the way.
        double farthest = -1;
        for (std::size_t i = 0; i < pegs.size(); ++i) {
            if (pegs[i].side != target_side() || taken[i]) continue;
            const double away = (pegs[i].foot - body.limb[1 - giver_]->trocar().position).norm();
            if (away <= farthest) continue;
            farthest = away;
            peg_ = static_cast<int>(i);
        }
        if (peg_ < 0) return;
        choose_tube(seen, body);
        open(limb);
        const double delay = skill_.choice_s * limb.random().uniform(0.6, 1.4);
        begin_reach(body, Stage::approach, above(seen, body), 0.015, 4, delay);
    }

    // The tube whose middle is nearest to where this hand's shaft comes from.
    void choose_tube(const Perception& seen, const Body& body) noexcept {
        const std::vector<Vector3>& corners = body.eyes->tray().corners;
        const ObjectView& object = seen.objects[ring()];
        const Vector3 from = (body.limb[mover_]->trocar().position - object.position).normalized();
        double best = -1e9;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vector3 middle = 0.5 * (corners[k] + corners[(k + 1) % corners.size()]);
            double use = (object.rotation * middle).dot(from);
            if (mover_ != giver_ && seen.grasps[giver_].held)  // away from the other jaws
                use += 0.5 * (object.position + object.rotation * middle - seen.grasps[giver_].point).norm();
            if (use <= best) continue;
            best = use;
            tube_ = middle;
        }
    }

    Vector3 place_for_tip(const Perception& seen, const Body& body) const noexcept {
        const ObjectView& object = seen.objects[ring()];
        const Vector3 middle = object.position + object.rotation * tube_;
        const Limb& limb = *body.limb[mover_];
        if (mover_ == giver_) return middle + Vector3(0, 0, tip_above_tube);
        const Vector3 axis = (middle - limb.trocar().position).normalized();
        return middle + 0.25 * limb.spec().jaw_length * axis;
    }
    Vector3 above(const Perception& seen, const Body& body) const noexcept {
        const Vector3 place = place_for_tip(seen, body);
        if (mover_ == giver_) return place + Vector3(0, 0, hover);
        return place + (hover + body.limb[mover_]->spec().jaw_length) *
                           (body.limb[mover_]->trocar().position - place).normalized();
    }

    void begin_reach(Body& body, Stage stage, const Vector3& goal, double width, double patience,
                     double delay = 0) noexcept {
        Limb& limb = *body.limb[mover_];
        enter(stage, limb);
        reaches_[mover_].start(limb, goal, body.view, width, delay, patience);
    }
    bool reached(const Perception& seen, Body& body, const Vector3& goal) noexcept {
        Reach& reach = reaches_[mover_];
        reach.follow(goal);
        reach.update(*body.limb[mover_], seen.tip[mover_]);
        return reach.started() && reach.arrived();
    }

    void approach(const Perception& seen, Body& body) noexcept {
        if (!reached(seen, body, above(seen, body))) return;
        begin_reach(body, mover_ == giver_ ? Stage::descend : Stage::other_descend, place_for_tip(seen, body),
                    0.006, 2.5);
    }

    void descend(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        const bool there = reached(seen, body, place_for_tip(seen, body));
        const bool pressed = seen.display.force[mover_] > skill_.comfortable_force;
        if (pressed) limb.stop();
        if (!there && !pressed) return;
        limb.jaws(closed_share * limb.spec().jaw_opening,
                  std::max(1.5, skill_.grip_force + skill_.grip_spread * limb.random().normal()));
        until_ = limb.time() + std::max(shortest_close_s, skill_.dwell_s) + skill_.reaction_s + 0.05;
        enter(mover_ == giver_ ? Stage::close : Stage::other_close, limb);
        // Who does not wait to see the other jaws closed opens while they still close.
        if (mover_ != giver_ && limb.random().uniform() < anticipation * (1 - skill_.foresight))
            open(*body.limb[giver_]);
    }

    void close(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        if (limb.time() < until_) return;
        if (!holds(seen, mover_)) {
            open(limb);
            retract(limb);
            if (++attempts_ >= attempts_at_a_tube) {
                attempts_ = 0;
                give_up(seen, body);
            } else if (mover_ == giver_) {
                enter(Stage::choose, limb);
            } else {
                begin_reach(body, Stage::other_approach, above(seen, body), 0.012, 4,
                            skill_.dwell_s + 0.35 * skill_.duration_scale);
            }
            return;
        }
        attempts_ = 0;
        if (mover_ == giver_) {
            const double height = peg_height_ + above_pegs;
            limb.carry(Vector3(0, 0, height), height / (carry_speed * skill_.lift_speed));
            enter(Stage::lift, limb);
        } else {
            until_ = limb.time() + both_hold_s + skill_.reaction_s + 0.5 * skill_.dwell_s;
            enter(Stage::hand_over, limb);
        }
    }

    /// Tip of the moving hand so that the held ring's middle comes to a place.
    Vector3 tip_for_ring(const Perception& seen, const Vector3& place) const noexcept {
        return seen.tip[mover_] + place - seen.objects[ring()].position;
    }
    Vector3 handover_tip(const Perception& seen) const noexcept {
        return tip_for_ring(seen, tray_ + Vector3(0, 0, peg_height_ + handover_height));
    }
    /// Where a ring is carried to: over its peg, or over the free middle of the tray.
    Vector3 over_peg(const Body& body) const noexcept {
        if (laying_) return tray_ + Vector3(0, 0, peg_height_ + above_pegs);
        return body.eyes->tray().pegs[static_cast<std::size_t>(peg_)].top + Vector3(0, 0, above_pegs);
    }

    void begin_other(const Perception& seen, Body& body) noexcept {
        mover_ = 1 - giver_;
        choose_tube(seen, body);
        open(*body.limb[mover_]);
        begin_reach(body, Stage::other_approach, above(seen, body), 0.012, 4,
                    0.5 * skill_.choice_s * body.limb[mover_]->random().uniform(0.6, 1.4));
    }

    // Both hold the ring: the giving hand opens and goes away; once that is seen, the other carries it.
    void hand_over(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        Limb& giver = *body.limb[giver_];
        if (limb.time() < until_) return;
        if (giver.jaw() < 0.5 * giver.spec().jaw_opening) {
            open(giver);
            until_ = limb.time() + 0.4 + skill_.reaction_s;
            return;
        }
        if (holds(seen, giver_)) return;
        if (!holds(seen, mover_)) {
            give_up(seen, body);
            return;
        }
        retract(giver);
        begin_reach(body, Stage::carry, tip_for_ring(seen, over_peg(body)), 0.010, 5);
    }

    void begin_lowering(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        const ObjectView& object = seen.objects[ring()];
        // A ring that hangs steeply has to go deeper, until the peg is well inside it.
        const double down = std::max(0.0, object.height - laid_height);
        const double inside = std::max(0.0, object.position.z() - tray_.z() - peg_inside * peg_height_);
        const double way = laying_ ? down : std::min(down, inside);
        limb.carry(Vector3(0, 0, -way), way / (carry_speed * skill_.lift_speed));
        enter(Stage::lower, limb);
    }

    void lower(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        const bool pressed = seen.display.force[mover_] > skill_.comfortable_force;
        if (pressed) limb.stop();
        if (limb.remaining() > -skill_.reaction_s && !pressed) return;
        const ObjectView& object = seen.objects[ring()];
        if (!laying_ && object.peg != peg_) {  // not around the peg: up again, and once more
            const double way = std::max(0.0, peg_height_ + above_pegs - (object.position.z() - tray_.z()));
            limb.carry(Vector3(0, 0, way), std::max(0.2, way / (carry_speed * skill_.lift_speed)));
            laying_ = ++attempts_ >= attempts_at_a_peg;  // it hangs too steeply: laid down, taken again
            begin_reach(body, Stage::centre, tip_for_ring(seen, over_peg(body)), 0.004, 2.5, 0.4);
            return;
        }
        attempts_ = 0;
        open(limb);
        until_ = limb.time() + 0.3 + skill_.dwell_s;
        enter(Stage::let_go, limb);
    }

    void let_go(Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        if (limb.time() < until_) return;
        retract(limb);
        mover_ = giver_;
        ring_ = -1;
        enter(Stage::choose, *body.limb[mover_]);
    }

    void open(Limb& limb) noexcept { limb.jaws(open_share * limb.spec().jaw_opening, 0); }
    void retract(Limb& limb) noexcept {
        const Vector3 out = (limb.trocar().position - limb.destination()).normalized();
        limb.carry(0.025 * out + Vector3(0, 0, 0.008), 0.5 * skill_.duration_scale);
    }

    Skill skill_;
    std::vector<Goal> goals_;
    Reach reaches_[hand_count];
    Vector3 tray_ = Vector3::Zero(), tube_ = Vector3::Zero();
    double peg_height_ = 0.018, until_ = 0, entered_ = 0;
    Stage stage_ = Stage::choose;
    bool laying_ = false;
    int goal_ = -1, giver_ = 0, mover_ = 0, ring_ = -1, peg_ = -1, attempts_ = 0;
};

}  // namespace

std::unique_ptr<Behaviour> make_object_handling(const TaskDefinition& task, const Scene& scene,
                                                const Skill& skill) {
    return std::make_unique<ObjectHandling>(task, scene, skill);
}

}  // namespace fulcrum
