// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/camera_targets/camera_targets_layout.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr std::uint64_t cup_stream = 31, tip_stream = 32;  // of the seed
constexpr int most_draws = 20000;
constexpr double clearance = 0.003;  // m, between a cup and a line of sight, a shaft or the tip
constexpr double slowest = 0.6;      // share of the largest rate of the tip along an axis

double distance(const Vector3& from, const Vector3& to, const Vector3& other_from, const Vector3& other_to) {
    const SegmentPair pair = closest_points_of_segments(from, to, other_from, other_to);
    return (from + pair.s * (to - from) - other_from - pair.t * (other_to - other_from)).norm();
}

/// A direction at `angle` from a unit vector, `turn` around it.
Vector3 tilted(const Vector3& axis, double angle, double turn) {
    const Vector3 across = axis.unitOrthogonal(), third = axis.cross(across);
    const Vector3 out = math::cos(turn) * across + math::sin(turn) * third;
    return (math::cos(angle) * axis + math::sin(angle) * out).normalized();
}

class CupPlacer {
  public:
    CupPlacer(const Scene& scene, std::uint64_t seed)
        : spec_(*scene.camera_targets), scope_(make_scope(*scene.camera)), random_(seed, cup_stream) {
        outer_ = spec_.cup_radius + spec_.wall;
        nominal_ = scope_.trocar.rotation.col(2);
        follow_.push_back({spec_.tip_centre, eye_for(spec_.tip_centre)});
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3 side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            const Vector3 tip = spec_.tip_centre + side.cwiseProduct(spec_.tip_extent);
            follow_.push_back({tip, eye_for(tip)});
        }
    }

    bool add() {
        const CameraTarget cup = draw();
        if (!has_room(cup)) return false;
        cups_.push_back(cup);
        return true;
    }
    std::vector<CameraTarget> take() { return std::move(cups_); }

  private:
    Vector3 bottom(const CameraTarget& cup) const { return cup.ball - spec_.ball_radius * cup.axis; }

    CameraTarget draw() {
        CameraTarget cup;
        const double angle = spec_.swing * std::sqrt(random_.uniform());
        const Vector3 shaft = tilted(nominal_, angle, random_.uniform(0, 2 * pi));
        cup.eye =
            scope_.trocar.position + random_.uniform(spec_.least_insertion, spec_.most_insertion) * shaft;
        cup.post = random_.uniform(-pi, pi);
        DeviceReading reading;
        reading.handle = handle_for_tip(scope_.trocar, cup.eye);
        reading.roll = cup.post;
        const Vector3 view = view_direction(scope_pose(scope_, quantise(reading, {})));
        cup.ball = cup.eye + spec_.distance * view;
        const double tilt = spec_.tilt * std::sqrt(random_.uniform());
        cup.axis = tilted(-view, tilt, random_.uniform(0, 2 * pi));
        cup.mouth = cup.ball + spec_.cup_depth * cup.axis;
        return cup;
    }

    /// Where a tip is framed with the light post as it is at the beginning.
    Vector3 eye_for(const Vector3& tip) const {
        Vector3 eye = tip - spec_.distance * nominal_;
        for (int i = 0; i < 20; ++i) {
            DeviceReading reading;
            reading.handle = handle_for_tip(scope_.trocar, eye);
            eye = tip - spec_.distance * view_direction(scope_pose(scope_, quantise(reading, {})));
        }
        return eye;
    }

    bool near_tip(const Vector3& point, double margin) const {
        const Vector3 away = (point - spec_.tip_centre).cwiseAbs() - spec_.tip_extent;
        return away.maxCoeff() < margin;
    }

    /// Whether a cup keeps clear of a line of sight and of the scope that looks along it.
    bool clear_of(const CameraTarget& cup, const CameraTarget& other) const {
        const Vector3 from = bottom(cup);
        return distance(from, cup.mouth, other.eye, other.mouth) > outer_ + clearance &&
               distance(from, cup.mouth, scope_.trocar.position, other.eye) >
                   outer_ + spec_.lens_radius + clearance;
    }

    bool has_room(const CameraTarget& cup) const {
        const double margin = outer_ + 2 * clearance;
        if (near_tip(cup.ball, margin) || near_tip(cup.mouth, margin)) return false;
        // The tip can be followed, and is seen, wherever it is.
        for (const Followed& tip : follow_) {
            if (distance(bottom(cup), cup.mouth, scope_.trocar.position, tip.eye) <
                    outer_ + spec_.lens_radius + 2 * clearance ||
                distance(bottom(cup), cup.mouth, tip.eye, tip.tip) < outer_ + clearance)
                return false;
        }
        for (const CameraTarget& other : cups_) {
            if (distance(bottom(cup), cup.mouth, bottom(other), other.mouth) < spec_.spacing) return false;
            if (!clear_of(cup, other) || !clear_of(other, cup)) return false;
        }
        return true;
    }

    struct Followed {
        Vector3 tip, eye;
    };

    const CameraTargetsSpec& spec_;
    ScopeModel scope_;
    std::vector<Followed> follow_;
    Random random_;
    double outer_ = 0;
    Vector3 nominal_ = Vector3::UnitZ();
    std::vector<CameraTarget> cups_;
};

}  // namespace

std::vector<CameraTarget> place_camera_targets(const Scene& scene, std::uint64_t seed) {
    CupPlacer placer(scene, seed);
    int placed = 0;
    for (int draws = 0; placed < scene.camera_targets->count; ++draws) {
        if (draws == most_draws) {
            throw InputError(
                scene.id, "/camera_targets/count",
                {QT_TRANSLATE_NOOP("errors", "only %1 cups have room where the scope can see them"), placed},
                QT_TRANSLATE_NOOP("errors", "ask for fewer cups, less spacing or more swing of the scope"));
        }
        if (placer.add()) ++placed;
    }
    return placer.take();
}

TipPath draw_tip_path(const CameraTargetsSpec& spec, std::uint64_t seed) {
    TipPath path;
    path.centre = spec.tip_centre;
    path.extent = spec.tip_extent;
    Random random(seed, tip_stream);
    for (int axis = 0; axis < 3; ++axis) {
        const double fastest = path.extent[axis] > 0 ? spec.tip_speed / path.extent[axis] : 0;
        path.rate[axis] = random.uniform(slowest, 1) * fastest;
        path.phase[axis] = random.uniform(-pi, pi);
    }
    return path;
}

Vector3 TipPath::at(double time) const noexcept {
    Vector3 point = centre;
    for (int axis = 0; axis < 3; ++axis)
        point[axis] += extent[axis] * math::sin(rate[axis] * time + phase[axis]);
    return point;
}

Vector3 TipPath::velocity(double time) const noexcept {
    Vector3 speed;
    for (int axis = 0; axis < 3; ++axis)
        speed[axis] = extent[axis] * rate[axis] * math::cos(rate[axis] * time + phase[axis]);
    return speed;
}

}  // namespace fulcrum
