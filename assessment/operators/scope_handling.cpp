// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "assessment/operators/behaviour.h"
#include "assessment/operators/scope_limb.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/instrument/framing.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double two_pi = 6.283185307179586;
constexpr double clearance = 0.003;     // m, kept from cups
constexpr double withdrawn = 0.04;      // m of insertion: no cup is nearer to the trocar
constexpr double way_width = 0.012;     // m, of a place on the way
constexpr double framed_width = 0.006;  // m, of the place from which a target is framed
constexpr double follow_period = 0.25;  // s, between two decisions while following
constexpr double level_period = 1.0;    // s, between two looks at the horizon while following
constexpr double level_enough = 0.12;   // rad
constexpr double error_left = 0.5;      // share of a wrong turn after a correction
constexpr int turns_tried = 12;

double distance(const Vector3& from, const Vector3& to, const Vector3& other_from, const Vector3& other_to) {
    const SegmentPair pair = closest_points_of_segments(from, to, other_from, other_to);
    return (from + pair.s * (to - from) - other_from - pair.t * (other_to - other_from)).norm();
}

/// The angle nearest to `near` that is `angle` but for whole turns.
double nearest_turn(double angle, double near) {
    return angle + two_pi * std::round((near - angle) / two_pi);
}

class ScopeHandling : public Behaviour {
  public:
    ScopeHandling(const Scene& scene, const Skill& skill)
        : skill_(skill),
          reach_(skill),
          spec_(*scene.camera_targets),
          lens_radius_(scene.camera_targets->lens_radius) {}

    void decide(const Perception& seen, Body& body) noexcept override {
        if (body.scope == nullptr) return;
        ScopeLimb& scope = *body.scope;
        view_ = &body.eyes->camera_targets();
        const int wanted = seen.display.active_target;
        const int count = static_cast<int>(view_->targets.size());
        if (wanted < 0 || wanted > count) return;
        if (wanted != target_) {
            target_ = wanted;
            if (wanted < count) {
                const CameraTarget& target = view_->targets[static_cast<std::size_t>(wanted)];
                set_out(scope, target.eye, target.post);
            } else {
                const double post = post_for_tip(scope);
                set_out(scope, eye_for(scope, seen.moving_tip, scope.lens().destination(), post), post);
            }
        }
        if (!travel(scope, seen)) return;
        if (wanted < count) {
            correct(scope, seen);
        } else {
            follow(scope, seen);
        }
    }

  private:
    double outside() const noexcept { return view_->cup_radius + view_->wall; }

    /// Whether the straight way of a ball of this radius keeps clear of all cups.
    bool clear(const Vector3& from, const Vector3& to, double radius) const noexcept {
        for (const CameraTarget& cup : view_->targets) {
            const Vector3 bottom = cup.ball - view_->ball_radius * cup.axis;
            if (distance(from, to, bottom, cup.mouth) < outside() + radius + clearance) return false;
        }
        return true;
    }

    /// Angle of the camera head that levels the image there.
    double level(const ScopeLimb& scope, const Vector3& lens, double post) const noexcept {
        const double tilt = horizon_of(scope.pose(lens, post, 0).orientation, Vector3::UnitZ());
        return nearest_turn(-tilt, scope.head());
    }

    /// Where the lens sees a point in the middle at the wanted distance, with this turn of the light post.
    Vector3 eye_for(const ScopeLimb& scope, const Vector3& point, Vector3 lens, double post) const noexcept {
        for (int i = 0; i < 12; ++i)
            lens = point - view_->distance * view_direction(scope.pose(lens, post, 0));
        return lens;
    }

    /// The turn of the light post, not far from the present one, with which the tip can be followed wherever
    /// it goes without touching a cup.
    double post_for_tip(const ScopeLimb& scope) const noexcept {
        double best = scope.post(), least = 1e9;
        for (int i = 0; i < turns_tried; ++i) {
            const double post = nearest_turn(two_pi * i / turns_tried, scope.post());
            const double cost = 0.002 * std::abs(post - scope.post()) - room_for(scope, post);
            if (cost >= least) continue;
            least = cost;
            best = post;
        }
        return best;
    }

    /// m, least distance between the scope and a cup while the tip is followed with this turn of the light
    /// post; more than enough counts as enough.
    double room_for(const ScopeLimb& scope, double post) const noexcept {
        const Vector3 trocar = scope.model().trocar.position;
        double room = lens_radius_ + 2 * clearance;
        for (int place = 0; place < 7; ++place) {
            Vector3 tip = spec_.tip_centre;
            if (place > 0) {
                const int axis = (place - 1) / 2;
                tip[axis] += place % 2 == 0 ? spec_.tip_extent[axis] : -spec_.tip_extent[axis];
            }
            const Vector3 eye = eye_for(scope, tip, trocar + 0.7 * (tip - trocar), post);
            for (const CameraTarget& cup : view_->targets) {
                const Vector3 bottom = cup.ball - view_->ball_radius * cup.axis;
                room = std::min(room, distance(trocar, eye, bottom, cup.mouth) - outside());
            }
        }
        return room;
    }

    void set_out(ScopeLimb& scope, const Vector3& eye, double post) noexcept {
        Random& random = scope.lens().random();
        eye_ = eye;
        post_ = nearest_turn(post, scope.post());
        post_error_ = skill_.scope.post_error * random.normal();
        level_error_ = skill_.scope.level_error * random.normal();
        begin_ = scope.time() + skill_.choice_s * random.uniform(0.6, 1.4);
        turned_ = levelled_ = arrived_ = false;
        together_ = random.uniform() < skill_.scope.together;
        // A way that would touch a cup leads back towards the trocar first, for those who look ahead.
        legs_ = leg_ = 0;
        const Vector3 from = scope.lens().destination(), trocar = scope.model().trocar.position;
        if (!clear(from, eye, lens_radius_) && random.uniform() < skill_.foresight) {
            const auto back = [&](const Vector3& place) {
                const Vector3 shaft = place - trocar;
                return Vector3(trocar + std::min(withdrawn, shaft.norm()) * shaft.normalized());
            };
            way_[0] = back(from);
            way_[1] = back(eye);
            legs_ = 2;
        }
        start_leg(scope, begin_ - scope.time());
        look_ = 0;
    }

    void start_leg(ScopeLimb& scope, double delay) noexcept {
        const bool last = leg_ == legs_;
        reach_.start(scope.lens(), last ? eye_ : way_[leg_], line_of_sight(scope),
                     last ? framed_width : way_width, delay, last ? 3 : 8);
    }

    Vector3 line_of_sight(const ScopeLimb& scope) const noexcept {
        return view_direction(scope.pose(eye_, post_, 0));
    }

    void turn(ScopeLimb& scope) noexcept {
        if (!turned_) scope.turn_post(post_ + post_error_);
        turned_ = true;
        if (!levelled_) scope.turn_head(level(scope, eye_, post_ + post_error_) + level_error_);
        levelled_ = true;
    }

    /// Brings the lens to its place; true when it is there and everything is turned.
    bool travel(ScopeLimb& scope, const Perception& seen) noexcept {
        if (together_ && scope.time() > begin_ && !turned_) turn(scope);
        if (!arrived_) {
            reach_.update(scope.lens(), seen.lens);
            if (leg_ < legs_ && reach_.started() && scope.lens().remaining() < 0.12) {
                ++leg_;
                start_leg(scope, 0);
                return false;
            }
            if (leg_ < legs_ || !reach_.arrived()) return false;
            arrived_ = true;
            look_ = scope.time() + skill_.reaction_s;
            next_follow_ = next_level_ = scope.time();
        }
        if (!turned_) {
            turn(scope);
            look_ = scope.time() + skill_.reaction_s;
        }
        if (scope.turning()) {
            look_ = scope.time() + skill_.reaction_s + 0.05;
            return false;
        }
        return true;
    }

    /// Looks at what is still wrong and corrects it.
    void correct(ScopeLimb& scope, const Perception& seen) noexcept {
        if (scope.time() < look_ || seen.display.framing_faults == 0) return;
        const unsigned faults = seen.display.framing_faults;
        look_ = scope.time() + skill_.reaction_s + 0.3 * skill_.choice_s;
        if ((faults & (framing_hidden | framing_off_centre)) != 0) {
            post_error_ *= error_left;
            scope.turn_post(post_ + post_error_);
        }
        if ((faults & framing_tilted) != 0) {
            level_error_ *= error_left;
            scope.turn_head(level(scope, eye_, post_ + post_error_) + level_error_);
        }
        if ((faults & (framing_hidden | framing_off_centre | framing_too_far | framing_too_near)) != 0) {
            arrived_ = false;
            start_leg(scope, 0);
        }
    }

    void follow(ScopeLimb& scope, const Perception& seen) noexcept {
        Limb& lens = scope.lens();
        if (scope.time() < next_follow_) return;
        next_follow_ = scope.time() + follow_period * skill_.duration_scale;
        const double ahead = skill_.scope.lead * (skill_.reaction_s + follow_period);
        const Vector3 tip = seen.moving_tip + ahead * seen.moving_tip_velocity;
        eye_ = eye_for(scope, tip, eye_, scope.post());
        const Vector3 step = eye_ - lens.destination();
        if (step.norm() > skill_.tolerance) lens.carry(step, follow_period * skill_.duration_scale);
        if (scope.time() < next_level_) return;
        next_level_ = scope.time() + level_period;
        if (std::abs(seen.display.framing.horizon) < level_enough) return;
        level_error_ = skill_.scope.level_error * lens.random().normal();
        scope.turn_head(level(scope, eye_, scope.post()) + level_error_);
    }

    Skill skill_;
    Reach reach_;
    CameraTargetsSpec spec_;
    double lens_radius_;
    const CameraTargetsView* view_ = nullptr;
    int target_ = -1;
    Vector3 eye_ = Vector3::Zero(), way_[2] = {Vector3::Zero(), Vector3::Zero()};
    int legs_ = 0, leg_ = 0;
    double post_ = 0, post_error_ = 0, level_error_ = 0;
    double begin_ = 0, look_ = 0, next_follow_ = 0, next_level_ = 0;
    bool together_ = true, turned_ = false, levelled_ = false, arrived_ = false;
};

}  // namespace

std::unique_ptr<Behaviour> make_scope_handling(const TaskDefinition& /*task*/, const Scene& scene,
                                               const Skill& skill) {
    return std::make_unique<ScopeHandling>(scene, skill);
}

}  // namespace fulcrum
