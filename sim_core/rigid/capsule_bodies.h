// SPDX-License-Identifier: Apache-2.0
// Small rigid rings of straight tubes, with dry friction: on a plane, around posts, on each other, pushed by
// instruments and held in jaws. Time stepping at the level of velocities with complementarity conditions for
// contact and friction (Stewart and Trinkle 1996), solved by projected Gauss-Seidel; holds and instruments
// act through implicit springs (tested from 1 to 1e7 N/m). Equations: docs/THEORY.md, section 12.
//
// World thread. step() neither allocates, locks nor throws. Frames: patient frame unless a name says body.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/numerics/lanes.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

/// A segment with a radius.
struct Capsule {
    Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< m
    double radius = 0;                                     ///< m
};

/// A body in its own frame: origin in the centre of mass, axes along the principal axes of inertia.
struct BodyShape {
    static constexpr std::size_t most_corners = 12;
    std::vector<Vector3> corners;       ///< m; a tube goes from each to the next, from the last to the first
    double radius = 0;                  ///< m, of the tubes
    double reach = 0;                   ///< m, from the origin to the farthest surface
    double mass = 0;                    ///< kg
    Vector3 inertia = Vector3::Zero();  ///< kg m2, about the axes
};

/// A ring of `sides` straight tubes, in the plane z = 0, its corners at `corner_radius` (m) from the middle.
/// Mass spread evenly over the tubes and a ball at each corner. sides: 3 .. most_corners.
BodyShape make_ring(int sides, double corner_radius, double tube_radius, double mass);

/// State of a body.
struct BodyState {
    Vector3 position = Vector3::Zero();            ///< m, of the centre of mass
    Quaternion rotation = Quaternion::Identity();  ///< body to patient frame
    Vector3 velocity = Vector3::Zero();            ///< m/s
    Vector3 spin = Vector3::Zero();                ///< rad/s
};
inline Vector3 point_of(const BodyState& body, const Vector3& in_body) {
    return body.position + body.rotation * in_body;
}

/// What a body stands on and how bodies touch.
struct BodyGround {
    Vector3 point = Vector3::Zero();         ///< m, of the plane
    Vector3 normal = Vector3::UnitZ();       ///< unit, towards the bodies
    std::vector<Capsule> posts;              ///< fixed
    Vector3 gravity = Vector3(0, 0, -9.81);  ///< m/s2
    double friction = 0.4;                   ///< of everything on everything
    double spin_damping = 1;                 ///< 1/s, of the spin: what rolling loses
};

inline constexpr int grip_points = 3;

/// Jaws that hold a body: springs between points of the body and points of the jaws.
struct BodyGrip {
    std::int32_t body = -1;                     ///< -1: none is held
    int count = 0;                              ///< points, at most grip_points
    std::array<Vector3, grip_points> at{};      ///< m, body frame
    std::array<Vector3, grip_points> last{};    ///< m, where the jaws had each point at the step's begin
    std::array<Vector3, grip_points> target{};  ///< m, and at its end
    double stiffness = 0;                       ///< N/m, of each
    double damping = 0;                         ///< N s/m, of each
    double most = 1e9;                          ///< N, of each: beyond it the body slides in the jaws
    Vector3 force = Vector3::Zero();            ///< N, jaws on body, mean of the last step; written by step()
};

/// An instrument that pushes bodies. It moves as the hand moves it; its push is a spring along the normal.
struct BodyPusher {
    bool present = false;
    std::int32_t spares = -1;         ///< body that it does not push: its jaws hold it; -1 none
    Capsule before, after;            ///< at the step's begin and end, longer than 0
    double stiffness = 600;           ///< N/m
    double damping = 0.5;             ///< N s/m
    Vector3 force = Vector3::Zero();  ///< N, on the bodies, mean of the last step; written by step()
    /// N, what the capsule's end `to` carries of it, `from` the rest, as a beam on two supports; by step().
    Vector3 force_at_end = Vector3::Zero();
    /// Where along the capsule the force is, 0 .. 1; 1 without a force.
    double place() const {
        const double size2 = force.squaredNorm();
        return size2 > 0 ? std::clamp(force_at_end.dot(force) / size2, 0.0, 1.0) : 1.0;
    }
};

class CapsuleBodies {
  public:
    static constexpr int contact_capacity = 256;  ///< in a substep; further ones are left out of it
    static constexpr double substep = 0.00125;    ///< s, longest

    CapsuleBodies(BodyShape shape, BodyGround ground)
        : shape_(std::move(shape)), ground_(std::move(ground)) {}
    /// Advances all bodies, at most body_capacity, by dt (s). Writes the forces of grips and pushers, one of
    /// each for each of at most two hands. The caller keeps these limits: they are not checked here.
    void step(std::vector<BodyState>& bodies, BodyGrip* grips, BodyPusher* pushers, int hands,
              double dt) noexcept;

    const BodyShape& shape() const { return shape_; }
    const BodyGround& ground() const { return ground_; }
    /// m, of the body's lowest point above the plane.
    double height(const BodyState& body) const noexcept;
    std::size_t bytes() const;
    /// Contacts of the last substep.
    int contacts() const noexcept { return count_; }

  private:
    /// Of a body with the ground, a post, an instrument or another body.
    struct Contact {
        std::int32_t first = -1, second = -1;  ///< bodies; second -1: no body
        std::int32_t pusher = -1;
        Vector3 normal = Vector3::Zero();                                 ///< unit, towards `first`
        Vector3 on_first = Vector3::Zero(), on_second = Vector3::Zero();  ///< m, from the centres of mass
        Vector3 speed = Vector3::Zero();                                  ///< m/s, of what is no body
        double gap = 0;                                                   ///< m
        double along = 0;                                                 ///< 0 .. 1, where on the pusher
        double share_normal = 0, share_along = 0;                         ///< 1/kg, of the bodies' answer
    };
    /// A contact as the sweeps read it: most of the time of a step is theirs.
    struct Constraint {
        Lanes normal, on_first, on_second, speed;  ///< as of the contact
        Lanes drag;                                ///< N s, along the contact, so far in this substep
        double push, least, softness;              ///< N s so far; m/s; s/kg
        double share_normal, share_along;
        std::int32_t first, second;
    };
    /// Of a body, during the sweeps.
    struct Motion {
        Lanes velocity, spin;      ///< m/s, rad/s
        Lanes inverse_inertia[3];  ///< 1/(kg m2), columns
    };
    /// A spring of a grip in a substep.
    struct Spring {
        std::int32_t body = -1, hand = 0;
        Vector3 arm = Vector3::Zero(), goal = Vector3::Zero(), impulse = Vector3::Zero();
        Matrix3 inverse = Matrix3::Zero();
        double softness = 0, most = 0;  ///< s/kg; N s
    };

    void begin_substep(std::vector<BodyState>& bodies, double h) noexcept;
    void find_contacts(const std::vector<BodyState>& bodies, const BodyPusher* pushers, int hands, double to,
                       double dt) noexcept;
    void touch(const std::vector<BodyState>& bodies, std::int32_t body, const Capsule& other,
               std::int32_t pusher, const Vector3& speed_from, const Vector3& speed_to) noexcept;
    void touch_pair(const std::vector<BodyState>& bodies, std::int32_t first, std::int32_t second) noexcept;
    void add(const Contact& contact) noexcept;
    void find_springs(const std::vector<BodyState>& bodies, const BodyGrip* grips, int hands, double to,
                      double dt, double h) noexcept;
    void begin_sweeps(const std::vector<BodyState>& bodies, const BodyPusher* pushers, double h) noexcept;
    void order_contacts(std::int32_t bodies) noexcept;
    void pull(Spring& spring) noexcept;
    void press(Constraint& contact) noexcept;
    void shift(Motion& motion, const Lanes& arm, const Lanes& impulse) const noexcept;
    /// Hands back the velocities, and the forces of grips and pushers.
    void end_sweeps(std::vector<BodyState>& bodies, BodyGrip* grips, BodyPusher* pushers,
                    double dt) const noexcept;
    Matrix3 answer(std::int32_t body, const Vector3& arm) const noexcept;

    BodyShape shape_;
    BodyGround ground_;
    // Scratch.
    static constexpr int most_bodies = 16, most_springs = 2 * grip_points;
    std::array<Matrix3, most_bodies> inverse_inertia_;  ///< 1/(kg m2), patient frame
    std::array<std::array<Vector3, BodyShape::most_corners>, most_bodies> corners_;  ///< m, of each body now
    std::array<Contact, contact_capacity> contacts_;
    std::array<Constraint, contact_capacity> constraints_;  ///< in the order of the sweeps
    std::array<std::int32_t, contact_capacity> place_;      ///< of each contact's constraint
    std::array<Motion, most_bodies> motions_;
    std::array<Spring, most_springs> springs_;
    int count_ = 0, spring_count_ = 0;

  public:
    static constexpr int body_capacity = most_bodies;
};

}  // namespace fulcrum
