// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "assessment/operators/behaviour.h"

namespace fulcrum {
namespace {

constexpr double clearance = 0.004;  // m, kept from spheres that are not to be touched
constexpr int most_detours = 3;
constexpr double parked_within = 0.02;  // m
constexpr double press_step_s = 0.25;   // between adjustments of the pressing force

class Targeting : public Behaviour {
  public:
    Targeting(const Scene& scene, const Skill& skill) : skill_(skill), reaches_{Reach(skill), Reach(skill)} {
        stiffness_ = scene.targets ? scene.targets->stiffness : 600;
        for (const InstrumentSpec& spec : scene.instruments)
            tip_radius_[static_cast<int>(spec.hand)] = spec.tip_radius;
    }

    void decide(const Perception& seen, Body& body) noexcept override {
        const std::vector<TargetSphere>& targets = body.eyes->targets();
        const int wanted = seen.display.active_target;
        if (wanted < 0 || static_cast<std::size_t>(wanted) >= targets.size()) return;
        const TargetSphere& target = targets[static_cast<std::size_t>(wanted)];
        const int hand = static_cast<int>(target.hand);
        Limb* limb = body.limb[hand];
        if (limb == nullptr) return;
        Reach& reach = reaches_[hand];
        body.gaze = target.centre;

        if (wanted != target_) {
            target_ = wanted;
            const double depth = skill_.touch_force / stiffness_;
            reach_ = target.radius + tip_radius_[hand] - depth;
            press_time_ = 0;
            const double choice = skill_.choice_s * limb->random().uniform(0.6, 1.4);
            detours_ = 0;
            parking_[hand] = false;
            set_out(*limb, target, targets, reach, body.view, choice);
        }
        if (on_detour_ && (limb->destination() - via_).norm() < 0.012 && limb->remaining() < 0.12) {
            set_out(*limb, target, targets, reach, body.view, 0.0);
        }
        park(1 - hand, seen, body);
        reach.update(*limb, seen.tip[hand]);
        if (!on_detour_ && reach.started()) reach.follow(goal(target, 0));

        // On the sphere: press with this hand's usual force, using the displayed force.
        if (!on_detour_ && reach.arrived() && limb->time() > press_time_) {
            const double force = seen.display.force[hand];
            const double error = std::clamp((skill_.touch_force - force) / stiffness_, -0.003, 0.0008);
            if (force > 2 * skill_.touch_force || force < 0.3 * skill_.touch_force)
                reach_ =
                    std::clamp(reach_ - 0.6 * error, 0.5 * target.radius, target.radius + tip_radius_[hand]);
            press_time_ = limb->time() + press_step_s;
            reach.follow(goal(target, 0));
        }
    }

  private:
    // The hand that is not needed returns to its start.
    void park(int hand, const Perception& seen, Body& body) noexcept {
        Limb* limb = body.limb[hand];
        if (limb == nullptr) return;
        const Vector3 home =
            limb->trocar().position + limb->spec().start_insertion * limb->trocar().rotation.col(2);
        const Vector3 from = limb->destination();
        const bool begins = !parking_[hand] && (from - home).norm() > parked_within;
        const bool leg_done = parking_[hand] && legs_[hand] > 0 && limb->remaining() < 0.12 &&
                              (from - park_via_[hand]).norm() < 0.012;
        if (begins) legs_[hand] = most_detours;
        if (begins || leg_done) {
            parking_[hand] = true;
            const TargetSphere place{home, 0, static_cast<Hand>(hand)};
            const Vector3 via = way_round(from, place, body.eyes->targets(), hand);
            const bool direct = (via - from).norm() < 1e-6;
            legs_[hand] = direct ? 0 : legs_[hand] - 1;
            park_via_[hand] = direct ? home : via;
            reaches_[hand].start(*limb, park_via_[hand], body.view, 0.02, 0.0, 8);
        }
        if (parking_[hand]) reaches_[hand].update(*limb, seen.tip[hand]);
    }

    // Starts the next movement: to the target, or to a point that avoids an obstacle.
    void set_out(Limb& limb, const TargetSphere& target, const std::vector<TargetSphere>& targets,
                 Reach& reach, const Vector3& view, double delay) noexcept {
        const int hand = static_cast<int>(target.hand);
        const Vector3 from = limb.destination();
        via_ = way_round(from, target, targets, hand);
        on_detour_ = detours_++ < most_detours && (via_ - from).norm() > 1e-6;
        approach_ = (from - target.centre).normalized();
        if (on_detour_) {
            reach.start(limb, via_, view, 0.02, delay);
        } else {
            reach.start(limb, goal(target, skill_.target.standoff), view, target.radius, delay);
        }
    }

    Vector3 goal(const TargetSphere& target, double standoff) const noexcept {
        return target.centre + (reach_ + standoff) * approach_;
    }

    /// The next point of a path that avoids the other spheres: the target, or a point next to the sphere that
    /// is in the way.
    Vector3 way_round(const Vector3& from, const TargetSphere& target,
                      const std::vector<TargetSphere>& targets, int hand) const noexcept {
        const Vector3 way = target.centre - from;
        const double length = way.norm();
        if (length < 1e-6) return from;
        const Vector3 along = way / length;
        double first = length;
        Vector3 via = from;
        for (const TargetSphere& other : targets) {
            const double reach = other.radius + tip_radius_[hand] + clearance;
            if ((other.centre - target.centre).norm() < 1e-9) continue;
            const double at = (other.centre - from).dot(along);
            if (at <= 0.001 || at >= length - target.radius || at >= first) continue;
            Vector3 beside = from + at * along - other.centre;
            const double distance = beside.norm();
            if (distance >= reach) continue;
            // Past it on the side where the way already leads, towards the trocar's side when it leads
            // straight through.
            if (distance < 1e-4) beside = Vector3(0, 0, 1) - along.z() * along;
            first = at;
            beside.normalize();
            // Off the sphere that was just touched: back out before going round.
            const Vector3 back = from - other.centre;
            if (back.norm() < reach) beside = (beside + 0.8 * back.normalized()).normalized();
            via = other.centre + 1.6 * reach * beside;
        }
        return via;
    }

    Skill skill_;
    Reach reaches_[hand_count];
    double tip_radius_[hand_count] = {0.0025, 0.0025};
    double stiffness_ = 600;
    int target_ = -1;
    bool on_detour_ = false, parking_[hand_count] = {false, false};
    int detours_ = 0, legs_[hand_count] = {0, 0};
    Vector3 park_via_[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    Vector3 approach_ = Vector3::UnitZ(), via_ = Vector3::Zero();
    double reach_ = 0, press_time_ = 0;
};

}  // namespace

std::unique_ptr<Behaviour> make_targeting(const TaskDefinition& /*task*/, const Scene& scene,
                                          const Skill& skill) {
    return std::make_unique<Targeting>(scene, skill);
}

}  // namespace fulcrum
