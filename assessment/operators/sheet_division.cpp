// SPDX-License-Identifier: Apache-2.0
// One hand grasps the flap and keeps the sheet taut, the other divides it along the marked line. With septa
// behind a rectum, one hand grasps it and lifts it off the sacrum, further down as the dissection proceeds;
// the other divides septum after septum and removes smoke and blood by suction.
#include <algorithm>
#include <cmath>
#include <vector>

#include "assessment/operators/blade_pedal.h"
#include "assessment/operators/bowel_grasp.h"
#include "assessment/operators/field_turn.h"
#include "assessment/operators/plane_sense.h"
#include "assessment/operators/sheet_division_values.h"
#include "assessment/operators/sheet_sight.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

using namespace sheet_division;

enum class Hold : std::uint8_t { choose, travel, descend, close, pull, let_go };
enum class Blade : std::uint8_t { wait, cross, travel, press, stroke, lift, suck };

class SheetDivision : public Behaviour {
  public:
    SheetDivision(const TaskDefinition& task, const Scene& scene, const Skill& skill, std::uint64_t attempt)
        : skill_(skill),
          goals_(task.goals),
          hold_reach_(skill),
          blade_reach_(skill),
          field_(skill),
          plane_(skill.plane, attempt),
          pedal_(skill, scene.structures.has_value()) {
        for (const InstrumentSpec& spec : scene.instruments)
            (spec.cuts() ? cutter_ : holder_) = static_cast<int>(spec.hand);
        for (const Goal& goal : goals_)
            if (goal.kind == GoalKind::divide_line) line_ = goal;
        sight_.cutter = cutter_;
        if (scene.septa) {
            sight_.septa = scene.septa->count;
            sight_.septum = scene.septa->width;
            radius_ = scene.bowel->outer_radius;
        }
        const int tissue = scene.sheet   ? scene.tissue_index(scene.sheet->tissue)
                           : scene.septa ? scene.tissue_index(scene.bowel->tissue)
                                         : -1;
        if (tissue >= 0) friction_ = scene.tissues[static_cast<std::size_t>(tissue)].friction;
    }

    void decide(const Perception& seen, Body& body) noexcept override {
        if (seen.display.ended || seen.display.goal < 0 || seen.line.size() < 2 ||
            static_cast<std::size_t>(seen.display.goal) >= goals_.size())
            return;
        const GoalKind kind = goals_[static_cast<std::size_t>(seen.display.goal)].kind;
        if (blade_ == Blade::wait && sight_.level != sight_.level_of(seen.display.cut_next_m)) {
            sight_.level = sight_.level_of(seen.display.cut_next_m);
            judge_tension(*body.limb[holder_], skill_.traction.error);  // every level is judged again
        }
        const Site site = site_at(seen, body, seen.display.cut_next_m);
        body.gaze = site.point;
        if (kind == GoalKind::let_go) {
            finish(body, site);
            return;
        }
        hold(seen, body);
        divide(seen, body, kind == GoalKind::divide_line);
    }

  private:
    // ---- what is seen ----
    bool of_septa() const noexcept { return sight_.of_septa(); }
    Site site_at(const Perception& seen, const Body& body, double place) const noexcept {
        return sight_.site_at(seen, body, place);
    }
    double place_of(const Perception& seen, const Body& body, const Vector3& point) const noexcept {
        return sight_.place_of(seen, body, point);
    }

    /// Height of the blade's tip over the line, as the hand that moves it knows it, m.
    double level(const Perception& seen, const Body& body, const Limb& limb) const noexcept {
        const Site site = site_at(seen, body, place_of(seen, body, limb.tip()));
        return (limb.tip() - site.point).dot(site.up);
    }

    bool taut(const Perception& seen) const noexcept {
        return std::abs(seen.display.traction_n_m - wanted_) <= skill_.traction.slack * wanted_;
    }

    // ---- the hand that holds ----
    /// The rectum in front of the middle of the septum that is worked on.
    LinePoint rectum(const Perception& seen, const Body& body) const noexcept {
        return line_point(seen.nodes, body.eyes->arc_lengths(), hold_place_);
    }
    /// Where the holding tip closes, and where it stops before that.
    Vector3 tip_to_hold(const Perception& seen, const Body& body, const Site& site,
                        const Limb& limb) const noexcept {
        return of_septa()
                   ? tip_beside_tube(limb, rectum(seen, body), radius_ + jaw_clearance - attempts_ * nearer)
                   : tip_at_rim(site, limb);
    }
    Vector3 tip_before_hold(const Perception& seen, const Body& body, const Site& site,
                            const Limb& limb) const noexcept {
        return of_septa() ? tip_above_tube(limb, tip_to_hold(seen, body, site, limb), lift_hover)
                          : above_rim(site, limb);
    }
    Vector3 tip_at_rim(const Site& site, const Limb& limb) const noexcept {
        const Vector3 middle = site.rim + (beyond_rim - attempts_ * deeper) * site.across;
        return middle + 0.5 * limb.spec().jaw_length * (middle - limb.trocar().position).normalized();
    }
    Vector3 above_rim(const Site& site, const Limb& limb) const noexcept {
        const Vector3 tip = tip_at_rim(site, limb);
        return tip - (0.5 * limb.spec().jaw_length + hover) * (tip - limb.trocar().position).normalized();
    }

    void hold(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[holder_];
        const Site site =
            site_at(seen, body, of_septa() ? (sight_.level + 0.5) * sight_.septum : hold_place_);
        switch (hold_) {
            case Hold::choose: {
                hold_level_ = sight_.level_of(seen.display.cut_next_m);
                hold_place_ = of_septa() ? sight_.arc_in_front(seen, body)
                                         : std::clamp(seen.display.cut_next_m + ahead, 0.1 * line_.length_m,
                                                      0.9 * line_.length_m);
                limb.jaws(open_share * limb.spec().jaw_opening, 0);
                const Site there =
                    site_at(seen, body, of_septa() ? (sight_.level + 0.5) * sight_.septum : hold_place_);
                hold_reach_.start(limb, tip_before_hold(seen, body, there, limb), body.view, 0.015,
                                  skill_.choice_s * limb.random().uniform(0.6, 1.4), 4);
                // Each operator has an individual idea of the right tension, with a new error for every
                // grasp.
                judge_tension(limb, skill_.traction.error);
                hold_ = Hold::travel;
                break;
            }
            case Hold::travel:
                hold_reach_.follow(tip_before_hold(seen, body, site, limb));
                hold_reach_.update(limb, seen.tip[holder_]);
                if (hold_reach_.arrived() ||
                    (hold_reach_.corrections() > 0 && limb.remaining() < 0.1 &&
                     (limb.destination() - tip_before_hold(seen, body, site, limb)).norm() < 0.005)) {
                    hold_ = Hold::descend;
                    hold_reach_.start(limb, tip_to_hold(seen, body, site, limb), body.view, 0.008, 0, 2.5);
                }
                break;
            case Hold::descend:
                hold_reach_.follow(tip_to_hold(seen, body, site, limb));
                hold_reach_.update(limb, seen.tip[holder_]);
                if (seen.display.force[holder_] > 0.5 * skill_.comfortable_force) {
                    limb.stop();
                } else if (!hold_reach_.arrived()) {
                    break;
                }
                limb.jaws(closed_share * limb.spec().jaw_opening,
                          std::max(1.5, skill_.grip_force + skill_.grip_spread * limb.random().normal()));
                until_ = limb.time() + std::max(shortest_close_s, skill_.dwell_s) + skill_.reaction_s + 0.05;
                hold_ = Hold::close;
                break;
            case Hold::close:
                if (limb.time() < until_) break;
                if (seen.grasps[holder_].held) {
                    attempts_ = 0;
                    taken_ = limb.destination();
                    slack_since_ = limb.time();
                    hold_ = Hold::pull;
                } else {
                    ++attempts_;
                    if (attempts_ > 4) attempts_ = -2;
                    let_go(limb);
                }
                break;
            case Hold::pull:
                pull(seen, body, site);
                break;
            case Hold::let_go:
                if (limb.time() > until_ && limb.remaining() <= 0) hold_ = Hold::choose;
                break;
        }
    }

    /// The tension that this hand aims at: in the lower half of the band, where tissue opens and still
    /// yields.
    void judge_tension(Limb& limb, double error) noexcept {
        const double low = line_.traction_low_n_m, share = 0.35;
        const double right = low + share * (line_.traction_high_n_m - low);
        wanted_ = right * std::clamp(math::exp(error * limb.random().normal()), 0.3, 2.5);
        content_since_ = limb.time();
    }

    void let_go(Limb& limb) noexcept {
        limb.jaws(open_share * limb.spec().jaw_opening, 0);
        // Out along the shaft: the rim goes back past the jaws, the tip comes up outside it.
        const Vector3 out = (limb.trocar().position - limb.destination()).normalized();
        limb.carry((0.5 * limb.spec().jaw_length + hover) * out, 0.5 * skill_.duration_scale);
        until_ = limb.time() + skill_.dwell_s;
        hold_ = Hold::let_go;
    }

    void pull(const Perception& seen, Body& body, const Site& site) noexcept {
        Limb& limb = *body.limb[holder_];
        if (!seen.grasps[holder_].held) {  // it slipped, or the cut has freed what was held
            let_go(limb);
            return;
        }
        const double traction = seen.display.traction_n_m, force = seen.display.force[holder_];
        // Held more firmly as the load grows, at least as firmly as this hand is used to.
        const double needed = 1.5 * force / (2 * std::max(0.05, friction_));
        if (needed > limb.grip())
            limb.jaws(closed_share * limb.spec().jaw_opening, std::min(needed, 2.2 * skill_.grip_force));
        if (taut(seen)) slack_since_ = limb.time();
        // Content with it, and the task does not go on: the band that is shown corrects the hand.
        const bool first_goal =
            goals_[static_cast<std::size_t>(seen.display.goal)].kind == GoalKind::take_tension;
        if (!first_goal || !taut(seen)) content_since_ = limb.time();
        if (limb.time() - content_since_ > seconds_to_learn) judge_tension(limb, 0.3 * skill_.traction.error);
        const bool stretched =
            (limb.destination() - taken_).norm() > (of_septa() ? longest_lift : longest_pull) ||
            force > 1.5 * skill_.comfortable_force;
        const bool passed = of_septa() ? sight_.level_of(seen.display.cut_next_m) > hold_level_ + 1
                                       : std::abs(seen.display.cut_next_m - hold_place_) > reach_of_hold;
        const bool vain = limb.time() - slack_since_ > seconds_to_wait;
        const bool slack = traction < wanted_ * (1 - skill_.traction.slack);
        // While the blade presses, traction is not adjusted: this hand waits until the blade is out.
        // In a stroke, an operator who has learned it continues to adjust, and keeps this hold.
        const bool stroking = blade_ == Blade::stroke;
        const bool blade_presses =
            blade_ == Blade::press || (!stroking && seen.display.force[cutter_] > blade_felt);
        if (blade_presses || (stroking && skill_.foresight < 0.5)) {
            slack_since_ = limb.time();
            return;
        }
        if (!stroking && ((slack && stretched) || passed || vain)) {
            let_go(limb);
            return;
        }
        // Wait for the effect of the last movement.
        if (limb.remaining() > -skill_.reaction_s - (of_septa() ? settle_s : 0)) return;
        const double missing = wanted_ - traction;
        if (std::abs(missing) < 0.4 * skill_.traction.slack * wanted_ || (missing > 0 && stretched)) return;
        const double longest = of_septa() ? lift_step : pull_step;
        const double step = std::clamp(longest * missing / (0.35 * wanted_), -longest, longest);
        if (std::abs(step) < (of_septa() ? 0.4 : 1) * least_step) return;
        const Vector3 way = of_septa() ? (0.95 * site.across + 0.3 * site.up).normalized()
                                       : (0.85 * site.across + 0.53 * site.up).normalized();
        if (step < 0 && (limb.destination() - taken_).dot(way) < 0) return;  // no traction any more
        limb.carry(step * way, std::abs(step) / skill_.lift_speed);
    }

    // ---- the hand that cuts ----
    // Next to a septum's rims run the nerves.
    double over_rim() const noexcept { return of_septa() ? over_septum : run_over; }
    // A stroke begins a little before the end of the last: lips of a sheet gape, and a blade set on them
    // takes crumbs.
    double behind() const noexcept { return of_septa() ? 0.001 : 0.0005; }
    double beyond() const noexcept { return of_septa() ? 0.0004 : 0.002; }
    void divide(const Perception& seen, Body& body, bool allowed) noexcept {
        if (of_septa() && seen.display.force[cutter_] > skill_.comfortable_force &&
            (blade_ == Blade::cross || blade_ == Blade::travel || blade_ == Blade::stroke)) {
            lift(seen, body);  // this is not the plane
            return;
        }
        switch (blade_) {
            case Blade::wait:
                wait_with_blade(seen, body, allowed);
                break;
            case Blade::cross:
                cross(seen, body);
                break;
            case Blade::travel:
                travel(seen, body);
                break;
            case Blade::press:
                press(seen, body);
                break;
            case Blade::stroke:
                stroke(seen, body);
                break;
            case Blade::suck:
                if (field_.update(seen, body, cutter_)) blade_ = Blade::wait;
                break;
            case Blade::lift:
                lift_off(seen, body);
                break;
        }
    }

    // Plans the next stroke once the tissue is taut and the field is clear.
    void wait_with_blade(const Perception& seen, Body& body, bool allowed) noexcept {
        Limb& limb = *body.limb[cutter_];
        const double next = seen.display.cut_next_m;
        limb.press(false);
        if (!allowed || (hold_ != Hold::pull && skill_.foresight > limb.random().uniform())) return;
        if (!taut(seen) && limb.time() - asked_ < skill_.foresight * seconds_to_wait) return;
        if (field_.wanted(seen, limb)) {
            field_.begin(seen);
            blade_ = Blade::suck;
            return;
        }
        const double start = sight_.level * sight_.septum;
        from_ = next < start + 1e-6 ? start - over_rim() : next - behind();
        way_ = 1;
        to_ = std::min(next + skill_.line.stroke * limb.random().uniform(0.8, 1.2),
                       (of_septa() ? start + sight_.septum : line_.length_m) + over_rim());
        if (of_septa() && next < start + 1e-6) {
            // The rim itself gives the blade no hold: from a little inside out over it first.
            from_ = start + inside_rim;
            to_ = start - over_rim();
            way_ = -1;
        }
        from_ += misses_ * further_on;
        aside_ = skill_.line.error * limb.random().normal();
        if (of_septa()) {
            aside_ += believed_plane(seen);
            for (Limb* const each : body.limb) each->steady(skill_.plane.steadiness);
        }
        depth_ = blade_depth;
        pedal_.plan(limb);
        const double delay = skill_.choice_s * limb.random().uniform(0.3, 0.7);
        if (of_septa() && sight_.level != crossed_) {
            // From one rim to the other along the plane, not through what lies in front of it.
            crossed_ = sight_.level;
            blade_ = Blade::cross;
            blade_reach_.start(limb, middle(seen, body, limb), body.view, 0.015, delay, 6);
            return;
        }
        blade_ = Blade::travel;
        blade_reach_.start(limb, over(site_at(seen, body, from_), limb, blade_height), body.view, 0.008,
                           delay, 3);
    }

    /// Distance from the plane to where this stroke takes it to be, m, positive towards the rectum.
    double believed_plane(const Perception& seen) noexcept {
        const double opened = seen.display.traction_n_m / line_.traction_low_n_m;
        if (sight_.level != planned_level_) plane_.next_level(opened);
        planned_level_ = sight_.level;
        return plane_.stroke(opened);
    }

    void cross(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[cutter_];
        blade_reach_.follow(middle(seen, body, limb));
        blade_reach_.update(limb, seen.tip[cutter_]);
        if (!blade_reach_.started() || (limb.destination() - middle(seen, body, limb)).norm() > near_enough ||
            limb.remaining() > 0.12)
            return;
        blade_ = Blade::travel;
        blade_reach_.start(limb, over(site_at(seen, body, from_), limb, blade_height), body.view, 0.008, 0,
                           3);
    }

    void travel(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[cutter_];
        const Vector3 goal = over(site_at(seen, body, from_), limb, blade_height);
        blade_reach_.follow(goal);
        blade_reach_.update(limb, seen.tip[cutter_]);
        if (blade_reach_.arrived() || (blade_reach_.corrections() > 0 && limb.remaining() < 0.1 &&
                                       (limb.destination() - goal).norm() < 0.004)) {
            blade_ = Blade::press;
            limb.press(true);
            pressed_ = limb.time();
            blade_reach_.start(limb, over(site_at(seen, body, from_), limb, -depth_), body.view, 0.004, 0, 2);
        }
    }

    void press(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[cutter_];
        pedal_.press(limb, seen, cutter_, seen.display.cutting || seen.display.force[cutter_] > blade_felt);
        if (seen.display.cutting) {
            misses_ = 0;
            blade_ = Blade::stroke;
            cutting_seen_ = limb.time();
            return;
        }
        blade_reach_.follow(over(site_at(seen, body, from_), limb, -depth_));
        blade_reach_.update(limb, seen.tip[cutter_]);
        if (limb.time() - pressed_ > 0.35 + skill_.reaction_s && limb.remaining() <= 0) {
            // Deeper and further on, until the blade breaks through.
            depth_ += press_step;
            pressed_ = limb.time();
            if (depth_ > (of_septa() ? deepest_septum_press : deepest_press) ||
                seen.display.force[cutter_] > skill_.comfortable_force) {
                misses_ = misses_ < most_misses ? misses_ + 1 : 0;
                lift(seen, body);
            } else
                limb.carry(
                    press_step * (way_ * site_at(seen, body, from_).along - site_at(seen, body, from_).up),
                    0.25 * skill_.duration_scale);
        }
    }

    void lift_off(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[cutter_];
        pedal_.lift(limb);
        if (level(seen, body, limb) > -blade_depth) limb.press(false);
        if (limb.remaining() <= -skill_.reaction_s) {
            limb.press(false);
            blade_ = Blade::wait;
            asked_ = limb.time();
        }
    }

    void stroke(const Perception& seen, Body& body) noexcept {
        Limb& limb = *body.limb[cutter_];
        if (seen.display.cutting) cutting_seen_ = limb.time();
        const bool out = limb.time() - cutting_seen_ > skill_.reaction_s + 0.15;
        const double here = place_of(seen, body, seen.tip[cutter_]);
        pedal_.stroke(limb, seen, cutter_, way_ * (to_ - here));
        const bool slack = !taut(seen) && skill_.foresight > 0.5;
        // An operator with foresight stops when the tissue goes slack; the current stroke is completed.
        if (out || way_ * (here - to_) > -0.001 || (slack && limb.remaining() <= 0)) {
            lift(seen, body);
            return;
        }
        if (limb.remaining() > std::max(0.0, -skill_.gap_s)) return;
        const double planned = place_of(seen, body, limb.destination());
        const double aim =
            way_ > 0 ? std::min(planned + chunk, to_ + beyond()) : std::max(planned - chunk, to_ - beyond());
        const Vector3 goal = over(site_at(seen, body, aim), limb, -blade_depth);
        limb.reach(goal - limb.destination(), 0.003);
    }

    // Back along the shaft, the button held until the tip is at the sheet's level: the blade comes out
    // through the slit that it made and cuts nothing on its way.
    void lift(const Perception& seen, const Body& body) noexcept {
        Limb& limb = *body.limb[cutter_];
        limb.stop();
        const Vector3 out = of_septa() ? site_at(seen, body, to_).up
                                       : (limb.trocar().position - limb.destination()).normalized();
        limb.carry((blade_height + depth_) * out, 0.4 * skill_.duration_scale);
        pedal_.lifted(limb);
        blade_ = Blade::lift;
    }

    /// Above the middle of the septum that is worked on.
    Vector3 middle(const Perception& seen, const Body& body, const Limb& limb) const noexcept {
        return over(site_at(seen, body, (sight_.level + 0.5) * sight_.septum), limb, blade_height);
    }

    /// A tip above (or, below 0, beneath) a place of the line, by the way that its shaft goes: what is
    /// pressed down and springs back when the blade is through then meets the blade where it was touched.
    Vector3 over(const Site& site, const Limb& limb, double height) const noexcept {
        const Vector3 point = site.point + aside_ * site.across;
        if (of_septa()) return point + height * site.up;  // next to the rims the wall blocks the shaft
        return point - height * (point - limb.trocar().position).normalized();
    }

    void finish(Body& body, const Site& site) noexcept {
        if (finished_) return;
        finished_ = true;
        Limb& blade = *body.limb[cutter_];
        blade.press(false);
        blade.stop();
        blade.carry(0.02 * site.up, 0.5 * skill_.duration_scale);
        Limb& limb = *body.limb[holder_];
        limb.jaws(open_share * limb.spec().jaw_opening, 0);
        limb.carry(0.01 * (limb.trocar().position - limb.destination()).normalized(),
                   0.5 * skill_.duration_scale);
    }

    Skill skill_;
    std::vector<Goal> goals_;
    Goal line_;
    Reach hold_reach_, blade_reach_;
    FieldTurn field_;
    PlaneSense plane_;
    BladePedal pedal_;
    SheetSight sight_;
    int holder_ = 0, cutter_ = 1, attempts_ = 0;
    double friction_ = 0.5;
    Hold hold_ = Hold::choose;
    Blade blade_ = Blade::wait;
    bool finished_ = false;
    // Septa.
    int hold_level_ = 0;
    double radius_ = 0;
    int crossed_ = 0, misses_ = 0;
    int planned_level_ = -1;  // the last for which a stroke was planned
    double way_ = 1;          // +1 along the line, -1 against it
    double hold_place_ = 0, wanted_ = 1, until_ = 0, slack_since_ = 0, content_since_ = 0;
    Vector3 taken_ = Vector3::Zero();
    double from_ = 0, to_ = 0, aside_ = 0, depth_ = 0, pressed_ = 0, cutting_seen_ = 0, asked_ = 0;
};

}  // namespace

std::unique_ptr<Behaviour> make_sheet_division(const TaskDefinition& task, const Scene& scene,
                                               const Skill& skill, std::uint64_t attempt) {
    return std::make_unique<SheetDivision>(task, scene, skill, attempt);
}

}  // namespace fulcrum
