// SPDX-License-Identifier: Apache-2.0
// Hand over hand along the bowel, one hand lifts and holds it, one rests on it.
#include <algorithm>
#include <cmath>
#include <vector>

#include "assessment/operators/behaviour.h"
#include "assessment/operators/bowel_grasp.h"
#include "sim_core/geometry/closest_point.h"

namespace fulcrum {
namespace {

constexpr double hover = 0.020;  // m above the place of a grasp, while approaching
constexpr double jaw_clearance =
    0.003;  // m from the wall to the shaft's axis when the jaws close: the shaft does not press
constexpr double deeper = 0.0015;  // m nearer at every further attempt
constexpr int attempts_at_a_place = 4;
constexpr double sideways = 0.008;                        // m along the bowel after that
constexpr double tent_height = 0.007;                     // m by which a new grasp is lifted to test it
constexpr double lift_margin = 0.006;                     // m above the required height
constexpr double open_share = 0.85, closed_share = 0.12;  // of the widest opening
constexpr double before_frontier = 0.004, beyond_frontier = 0.018;  // m along the bowel
constexpr double shaft_clearance = 0.011;                    // m between the shafts' axes on a planned path
constexpr double way_tolerance = 0.015;                      // m from a point that is only passed
constexpr double shortest_close_s = 0.35;                    // time for the jaws to close
constexpr double press_step_m = 0.0004, press_step_s = 0.3;  // of a tip that palpates
constexpr double grip_reserve = 1.5;  // grip force divided by the force that the load needs

/// Where the tip's sphere touches the wall of a tube `radius` m thick, on the side that the shaft comes from.
Vector3 tip_on_tube(const Limb& limb, const LinePoint& point, double radius) noexcept {
    const Vector3 out = limb.trocar().position - point.position;
    const Vector3 side = (out - out.dot(point.tangent) * point.tangent).normalized();
    return point.position + (radius + limb.spec().tip_radius) * side;
}

enum class Stage : std::uint8_t { choose, travel, descend, close, tent, let_go, raise, palpate };

class BowelHandling : public Behaviour {
  public:
    BowelHandling(const TaskDefinition& task, const Scene& scene, const Skill& skill)
        : skill_(skill), goals_(task.goals), reaches_{Reach(skill), Reach(skill)} {
        radius_ = scene.bowel->outer_radius;
        const int tissue = scene.tissue_index(scene.bowel->tissue);
        if (tissue >= 0) friction_ = scene.tissues[static_cast<std::size_t>(tissue)].friction;
    }

    void decide(const Perception& seen, Body& body) noexcept override {
        if (seen.display.ended || seen.display.goal < 0 ||
            static_cast<std::size_t>(seen.display.goal) >= goals_.size())
            return;
        const Goal& goal = goals_[static_cast<std::size_t>(seen.display.goal)];
        if (seen.display.goal != goal_) begin_goal(seen, body);
        Limb& limb = *body.limb[mover_];
        notice_losses(seen, body);
        switch (stage_) {
            case Stage::choose:
                choose(goal, seen, body);
                break;
            case Stage::travel:
                travel(seen, body);
                break;
            case Stage::descend:
                descend(seen, body);
                break;
            case Stage::close:
                close(seen, body);
                break;
            case Stage::tent:
                if (limb.remaining() <= 0.02) finish_grasp(goal, body);
                break;
            case Stage::let_go:
                if (limb.time() > until_) {
                    retract(*body.limb[mover_]);
                    if (clear_away_) retract(*body.limb[1 - mover_]);
                    clear_away_ = false;
                    stage_ = Stage::choose;
                }
                break;
            case Stage::raise:
                raise(goal, seen, body);
                break;
            case Stage::palpate:
                palpate(seen, body);
                break;
        }
        hold_gently(seen, body);
        body.gaze = line_point(seen.nodes, body.eyes->arc_lengths(), place_).position;
    }

  private:
    void begin_goal(const Perception& seen, Body& body) noexcept {
        // A new goal begins with free hands.
        goal_ = seen.display.goal;
        for (int hand = 0; hand < hand_count; ++hand) {
            open(*body.limb[hand]);  // also a hand that has closed and does not see its grasp yet
            holds_[hand] = false;
        }
        holder_ = -1;
        attempts_ = 0;
        shift_ = 0;
        stage_ = goal_ == 0 ? Stage::choose : Stage::let_go;
        until_ = body.limb[mover_]->time() + 0.4;
        clear_away_ = goal_ > 0;
    }

    // The tissue has slipped: the hand opens and grasps the same place again.
    void notice_losses(const Perception& seen, Body& body) noexcept {
        for (int hand = 0; hand < hand_count; ++hand) {
            if (!holds_[hand] || seen.grasps[hand].held || body.limb[hand]->time() < believe_[hand]) continue;
            holds_[hand] = false;
            open(*body.limb[hand]);
            if (holder_ == hand) holder_ = -1;
            if (hand == mover_ || holder_ < 0) {
                if (stage_ == Stage::tent || stage_ == Stage::raise) retract(*body.limb[hand]);
                stage_ = Stage::choose;
            }
        }
    }

    void choose(const Goal& goal, const Perception& seen, Body& body) noexcept {
        double place = 0;
        palpates_ = goal.kind == GoalKind::palpate;
        if (goal.kind == GoalKind::run_bowel) {
            direction_ = goal.to_m >= goal.from_m ? 1 : -1;
            const double frontier = goal.from_m + direction_ * seen.display.run_covered_m;
            // Without a valid grasp the run resumes at its last position, or a little before it.
            const bool counts =
                holder_ >= 0 && std::abs(direction_ * (holder_place_ - frontier)) < beyond_frontier;
            place = counts ? holder_place_ + direction_ * skill_.bowel.stride
                           : frontier - direction_ * before_frontier;
        } else {
            place = 0.5 * (goal.from_m + goal.to_m);
        }
        place_ = place - direction_ * shift_;
        const LinePoint point = line_point(seen.nodes, body.eyes->arc_lengths(), place_);
        if (palpates_) {
            mover_ = static_cast<int>(goal.hand);
        } else if (holder_ >= 0) {
            mover_ = 1 - holder_;
        } else {
            const auto away = [&](int hand) {
                return (body.limb[hand]->trocar().position - point.position).norm();
            };
            mover_ = away(0) < away(1) ? 0 : 1;
        }
        Limb& limb = *body.limb[mover_];
        if (palpates_) {
            limb.jaws(0, 0);
        } else {
            open(limb);
        }
        depth_ = attempts_ * deeper;
        stage_ = Stage::travel;
        const double delay = skill_.choice_s * limb.random().uniform(0.6, 1.4);
        const Vector3 goal_place = above(seen, body);
        plan_way(limb.destination(), goal_place, body);
        if (way_next_ < way_count_) {
            reaches_[mover_].start(limb, way_[way_next_], body.view, 0.025, delay, 8);
        } else {
            reaches_[mover_].start(limb, goal_place, body.view, 0.015, delay, 4);
        }
    }

    // Straight there, or out along the shaft and round where the instruments would strike each other.
    void plan_way(const Vector3& from, const Vector3& to, Body& body) noexcept {
        way_count_ = way_next_ = 0;
        Limb& limb = *body.limb[mover_];
        if (limb.random().uniform() > skill_.foresight || !strikes(from, to, body)) return;
        const Vector3 pivot = limb.trocar().position;
        for (const double depth : {0.10, 0.075, 0.05}) {
            const Vector3 out = pivot + std::min(depth, (from - pivot).norm()) * (from - pivot).normalized();
            const Vector3 over = pivot + std::min(depth, (to - pivot).norm()) * (to - pivot).normalized();
            if (strikes(from, out, body) || strikes(out, over, body) || strikes(over, to, body)) continue;
            way_[0] = out;
            way_[1] = over;
            way_count_ = 2;
            return;
        }
    }

    // True if the moving shaft comes near the other one when its tip goes straight from one place to another.
    bool strikes(const Vector3& from, const Vector3& to, const Body& body) const noexcept {
        const Limb& limb = *body.limb[mover_];
        const Limb& other = *body.limb[1 - mover_];
        constexpr int steps = 10;
        for (int i = 1; i <= steps; ++i) {
            const Vector3 tip = from + (to - from) * i / steps;
            const SegmentPair pair = closest_points_of_segments(limb.trocar().position, tip,
                                                                other.trocar().position, other.destination());
            if ((pair.on_first - pair.on_second).norm() < shaft_clearance) return true;
        }
        return false;
    }

    void travel(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        Reach& reach = reaches_[mover_];
        const Vector3 goal = above(seen, body);
        if (way_next_ < way_count_) {
            reach.update(limb, seen.tip[mover_]);
            if (!reach.started() || (limb.destination() - way_[way_next_]).norm() > way_tolerance ||
                limb.remaining() > 0.12)
                return;
            ++way_next_;
            if (way_next_ < way_count_) {
                reach.start(limb, way_[way_next_], body.view, 0.025, 0, 8);
            } else {
                reach.start(limb, goal, body.view, 0.015, 0, 4);
            }
            return;
        }
        reach.follow(goal);
        reach.update(limb, seen.tip[mover_]);
        if (reach.arrived() || ((limb.destination() - goal).norm() < 0.006 && limb.remaining() < 0.1 &&
                                reach.corrections() > 0)) {
            stage_ = palpates_ ? Stage::palpate : Stage::descend;
            reach.start(limb, place_for_tip(seen, body), body.view, 0.008, 0.0, 2.5);
        }
    }

    void descend(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        Reach& reach = reaches_[mover_];
        reach.follow(place_for_tip(seen, body));
        reach.update(limb, seen.tip[mover_]);
        const bool pressed = seen.display.force[mover_] > skill_.comfortable_force;
        if (pressed) limb.stop();
        if (!pressed && !reach.arrived()) return;
        stage_ = Stage::close;
        limb.jaws(closed_share * limb.spec().jaw_opening,
                  std::max(1.5, skill_.grip_force + skill_.grip_spread * limb.random().normal()));
        // Jaws close in about a quarter of a second; the result is seen a reaction time later.
        until_ = limb.time() + std::max(shortest_close_s, skill_.dwell_s) + skill_.reaction_s + 0.05;
    }

    // Closed jaws on the wall: a little deeper until it is felt, a little less deep where it is pressed.
    void palpate(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        if (limb.time() > until_) {
            const double force = seen.display.force[mover_];
            if (force < 0.5 * skill_.touch_force) depth_ += press_step_m;
            if (force > 1.5 * skill_.touch_force) depth_ -= press_step_m;
            until_ = limb.time() + press_step_s;
        }
        reaches_[mover_].follow(place_for_tip(seen, body));
        reaches_[mover_].update(limb, seen.tip[mover_]);
    }

    void close(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        if (limb.time() < until_) return;
        if (seen.grasps[mover_].held) {
            holds_[mover_] = true;
            believe_[mover_] = limb.time();
            attempts_ = 0;
            shift_ = 0;
            stage_ = Stage::tent;
            limb.carry(Vector3(0, 0, tent_height), tent_height / skill_.lift_speed);
            grasped_place_ = seen.grasps[mover_].arc_length;
            return;
        }
        open(limb);
        if (++attempts_ >= attempts_at_a_place) {
            attempts_ = 0;
            shift_ = shift_ > 0 ? 0 : sideways;
        }
        stage_ = Stage::let_go;
        until_ = limb.time() + skill_.dwell_s;
    }

    // The new grasp holds: the other hand releases and moves ahead, or this one lifts.
    void finish_grasp(const Goal& goal, Body& body) noexcept {
        if (goal.kind == GoalKind::lift_and_hold) {
            stage_ = Stage::raise;
            return;
        }
        const int other = 1 - mover_;
        if (holds_[other]) open(*body.limb[other]);
        holds_[other] = false;
        holder_ = mover_;
        holder_place_ = grasped_place_;
        mover_ = other;
        stage_ = Stage::let_go;
        until_ = body.limb[mover_]->time() + skill_.dwell_s;
    }

    void raise(const Goal& goal, const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[mover_];
        if (limb.remaining() > -skill_.reaction_s) return;  // see what the last movement did before the next
        const double height = seen.display.lift_height_m, force = seen.display.force[mover_];
        const double missing = goal.height_m + lift_margin - height;
        if (missing > 0.5 * lift_margin) {
            const double step = std::clamp(missing, 0.001, 0.012);
            limb.carry(Vector3(0, 0, step), step / skill_.lift_speed);
        } else if (force > 1.5 * skill_.comfortable_force && missing < -0.25 * lift_margin) {
            limb.carry(Vector3(0, 0, -0.0015), 0.0015 / skill_.lift_speed);
        }
    }

    // The grip is as firm as the load requires, and at least as firm as this hand's usual grip.
    void hold_gently(const Perception& seen, Body& body) noexcept {
        for (int hand = 0; hand < hand_count; ++hand) {
            if (!holds_[hand]) continue;
            Limb& limb = *body.limb[hand];
            const double needed = grip_reserve * seen.display.force[hand] / (2 * std::max(0.05, friction_));
            if (needed > limb.grip())
                limb.jaws(closed_share * limb.spec().jaw_opening, std::min(needed, 2.2 * skill_.grip_force));
        }
    }

    void open(Limb& limb) noexcept { limb.jaws(open_share * limb.spec().jaw_opening, 0); }

    void retract(Limb& limb) noexcept {
        const Vector3 out = (limb.trocar().position - limb.destination()).normalized();
        limb.carry(0.012 * out + Vector3(0, 0, 0.008), 0.35 * skill_.duration_scale);
    }

    Vector3 place_for_tip(const Perception& seen, const Body& body) const noexcept {
        const LinePoint point = line_point(seen.nodes, body.eyes->arc_lengths(), place_);
        if (palpates_) return tip_on_tube(*body.limb[mover_], point, radius_ - depth_);
        return tip_beside_tube(*body.limb[mover_], point, radius_ + jaw_clearance - depth_);
    }

    Vector3 above(const Perception& seen, const Body& body) const noexcept {
        return tip_above_tube(*body.limb[mover_], place_for_tip(seen, body), hover);
    }

    Skill skill_;
    std::vector<Goal> goals_;
    Reach reaches_[hand_count];
    double radius_ = 0.016, friction_ = 0.5;
    Stage stage_ = Stage::choose;
    int goal_ = -1, mover_ = 1, holder_ = -1, attempts_ = 0;
    bool clear_away_ = false, palpates_ = false;
    Vector3 way_[2] = {Vector3::Zero(), Vector3::Zero()};
    int way_count_ = 0, way_next_ = 0;
    bool holds_[hand_count] = {false, false};
    double believe_[hand_count] = {0, 0};
    double place_ = 0, grasped_place_ = 0, holder_place_ = 0, direction_ = 1, shift_ = 0, depth_ = 0,
           until_ = 0;
};

}  // namespace

std::unique_ptr<Behaviour> make_bowel_handling(const TaskDefinition& task, const Scene& scene,
                                               const Skill& skill) {
    return std::make_unique<BowelHandling>(task, scene, skill);
}

}  // namespace fulcrum
