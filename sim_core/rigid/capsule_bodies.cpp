// SPDX-License-Identifier: Apache-2.0
#include "sim_core/rigid/capsule_bodies.h"

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int sweeps = 24;             // of the constraints in a substep
constexpr double end_of_tube = 0.999;  // of its length: from there on it is the beginning of the next
constexpr double margin = 0.0015;      // m: contacts that may close within a substep
constexpr double slop = 0.00005;       // m of overlap that is left, so that a resting body keeps its contacts
constexpr double correction = 0.2;     // of the rest of an overlap, in each substep
constexpr double fastest_correction = 0.2;         // m/s
constexpr double fastest = 5, fastest_spin = 400;  // m/s, rad/s: beyond, a body is slowed

Matrix3 cross(const Vector3& v) {
    Matrix3 matrix;
    matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return matrix;
}

// Sums and products in the order in which Eigen has them for its small fixed sizes, so that they are equal to
// the bit to those of vectors and matrices.
inline double dot(const Lanes& a, const Lanes& b) {
    const Lanes product = a * b;
    return (product[0] + product[1]) + product[2];
}

inline Lanes times(const Lanes* columns, const Lanes& v) {
    const Lanes x = turned_lanes<0, 0, 0, 0>(v), y = turned_lanes<1, 1, 1, 1>(v),
                z = turned_lanes<2, 2, 2, 2>(v);
    const Lanes first = columns[0] * x;
    const Lanes upper = multiply_add_lanes(columns[2], z, multiply_add_lanes(columns[1], y, first));
    const Lanes lower = first + (columns[1] * y + columns[2] * z);
    return first_two_lanes(upper, lower);
}

inline Lanes cross(const Lanes& a, const Lanes& b) {
    return turned_lanes<1, 2, 0, 3>(a) * turned_lanes<2, 0, 1, 3>(b) -
           turned_lanes<2, 0, 1, 3>(a) * turned_lanes<1, 2, 0, 3>(b);
}

}  // namespace

BodyShape make_ring(int sides, double corner_radius, double tube_radius, double mass) {
    BodyShape shape;
    shape.radius = tube_radius;
    shape.reach = corner_radius + tube_radius;
    shape.mass = mass;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * pi * i / sides;
        shape.corners.emplace_back(corner_radius * math::cos(angle), corner_radius * math::sin(angle), 0);
    }
    const double length = 2 * corner_radius * math::sin(pi / sides), r = tube_radius;
    // Volumes: cylinders and balls of one material.
    const double cylinder = pi * r * r * length, ball = 4.0 / 3.0 * pi * r * r * r;
    const double density = mass / (sides * (cylinder + ball));
    const double middle = corner_radius * math::cos(pi / sides);  // m, of a tube's middle from the axis
    const double tube = density * cylinder, corner = density * ball;
    // About the ring's axis, and, by symmetry, about any line in its plane half of what lies in the plane.
    const double across = tube * (length * length / 12 + r * r / 4), along = tube * r * r / 2;
    const double axial =
        sides * (across + tube * middle * middle + corner * (0.4 * r * r + corner_radius * corner_radius));
    const double planar = sides * (0.5 * (across + along) + 0.5 * tube * middle * middle +
                                   corner * (0.4 * r * r + 0.5 * corner_radius * corner_radius));
    shape.inertia = Vector3(planar, planar, axial);
    return shape;
}

double CapsuleBodies::height(const BodyState& body) const noexcept {
    double least = 1e9;
    for (const Vector3& corner : shape_.corners)
        least = std::min(least, (point_of(body, corner) - ground_.point).dot(ground_.normal) - shape_.radius);
    return least;
}

std::size_t CapsuleBodies::bytes() const {
    return sizeof(*this) + shape_.corners.capacity() * sizeof(Vector3) +
           ground_.posts.capacity() * sizeof(Capsule);
}

// Velocities after gravity and the bodies' own turning; gyroscopic torque by one Newton step of the implicit
// equation in the body's frame, which damps a little.
void CapsuleBodies::begin_substep(std::vector<BodyState>& bodies, double h) noexcept {
    const Matrix3 inertia = shape_.inertia.asDiagonal();
    const Vector3 inverse = shape_.inertia.cwiseInverse();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        BodyState& body = bodies[i];
        const Matrix3 turn = body.rotation.toRotationMatrix();
        inverse_inertia_[i] = turn * inverse.asDiagonal() * turn.transpose();
        for (std::size_t k = 0; k < shape_.corners.size(); ++k)
            corners_[i][k] = body.position + turn * shape_.corners[k];
        body.velocity += h * ground_.gravity;
        Vector3 spin = turn.transpose() * body.spin;
        const Vector3 momentum = inertia * spin;
        const Matrix3 slope = inertia + h * (cross(spin) * inertia - cross(momentum));
        spin -= slope.inverse() * (h * spin.cross(momentum));
        body.spin = turn * spin / (1 + h * ground_.spin_damping);
    }
}

Matrix3 CapsuleBodies::answer(std::int32_t body, const Vector3& arm) const noexcept {
    const Matrix3 lever = cross(arm);
    return Matrix3::Identity() / shape_.mass -
           lever * inverse_inertia_[static_cast<std::size_t>(body)] * lever;
}

void CapsuleBodies::add(const Contact& contact) noexcept {
    if (count_ == contact_capacity) return;
    Contact& added = contacts_[static_cast<std::size_t>(count_++)];
    added = contact;
    Matrix3 both = answer(contact.first, contact.on_first);
    if (contact.second >= 0) both += answer(contact.second, contact.on_second);
    added.share_normal = contact.normal.dot(both * contact.normal);
    // One number for both directions along the contact: the larger, so that no sweep overshoots.
    added.share_along = both.trace() - added.share_normal;
}

// A place at the end of a tube is one at the beginning of the next, and counts there.
void CapsuleBodies::touch(const std::vector<BodyState>& bodies, std::int32_t body, const Capsule& other,
                          std::int32_t pusher, const Vector3& speed_from, const Vector3& speed_to) noexcept {
    const Vector3& middle = bodies[static_cast<std::size_t>(body)].position;
    const Vector3 along = other.to - other.from;
    const double share = std::clamp((middle - other.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double near = shape_.reach + other.radius + margin;
    if ((middle - other.from - share * along).squaredNorm() > near * near) return;
    const auto& corners = corners_[static_cast<std::size_t>(body)];
    const std::size_t count = shape_.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        const SegmentPair pair =
            closest_points_of_segments(corners[k], corners[(k + 1) % count], other.from, other.to);
        const Vector3 apart = pair.on_first - pair.on_second;
        const double distance = apart.norm();
        Contact contact;
        contact.gap = distance - shape_.radius - other.radius;
        // An instrument's push is a spring that begins where they overlap.
        if (contact.gap > (pusher >= 0 ? 0 : margin) || distance < 1e-9 || pair.s > end_of_tube) continue;
        contact.first = body;
        contact.pusher = pusher;
        contact.normal = apart / distance;
        contact.on_first = pair.on_first - shape_.radius * contact.normal - middle;
        contact.speed = speed_from + pair.t * (speed_to - speed_from);
        contact.along = pair.t;
        add(contact);
    }
}

void CapsuleBodies::touch_pair(const std::vector<BodyState>& bodies, std::int32_t first,
                               std::int32_t second) noexcept {
    const Vector3& one = bodies[static_cast<std::size_t>(first)].position;
    const Vector3& two = bodies[static_cast<std::size_t>(second)].position;
    const double near = 2 * shape_.reach + margin;
    if ((one - two).squaredNorm() > near * near) return;
    const auto& a = corners_[static_cast<std::size_t>(first)];
    const auto& b = corners_[static_cast<std::size_t>(second)];
    const std::size_t count = shape_.corners.size();
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t l = 0; l < count; ++l) {
            const SegmentPair pair =
                closest_points_of_segments(a[k], a[(k + 1) % count], b[l], b[(l + 1) % count]);
            const Vector3 apart = pair.on_first - pair.on_second;
            const double distance = apart.norm();
            Contact contact;
            contact.gap = distance - 2 * shape_.radius;
            if (contact.gap > margin || distance < 1e-9 || pair.s > end_of_tube || pair.t > end_of_tube)
                continue;
            contact.first = first;
            contact.second = second;
            contact.normal = apart / distance;
            contact.on_first = pair.on_first - shape_.radius * contact.normal - one;
            contact.on_second = pair.on_second + shape_.radius * contact.normal - two;
            add(contact);
        }
    }
}

void CapsuleBodies::find_contacts(const std::vector<BodyState>& bodies, const BodyPusher* pushers, int hands,
                                  double to, double dt) noexcept {
    count_ = 0;
    const auto number = static_cast<std::int32_t>(bodies.size());
    for (std::int32_t i = 0; i < number; ++i) {
        const BodyState& body = bodies[static_cast<std::size_t>(i)];
        for (std::size_t k = 0; k < shape_.corners.size(); ++k) {
            const Vector3& at = corners_[static_cast<std::size_t>(i)][k];
            Contact contact;
            contact.gap = (at - ground_.point).dot(ground_.normal) - shape_.radius;
            if (contact.gap > margin) continue;
            contact.first = i;
            contact.normal = ground_.normal;
            contact.on_first = at - shape_.radius * ground_.normal - body.position;
            add(contact);
        }
        for (const Capsule& post : ground_.posts)
            touch(bodies, i, post, -1, Vector3::Zero(), Vector3::Zero());
        for (int hand = 0; hand < hands; ++hand) {
            const BodyPusher& pusher = pushers[hand];
            if (!pusher.present || pusher.spares == i) continue;
            const Capsule now = {pusher.before.from + to * (pusher.after.from - pusher.before.from),
                                 pusher.before.to + to * (pusher.after.to - pusher.before.to),
                                 pusher.after.radius};
            touch(bodies, i, now, hand, (pusher.after.from - pusher.before.from) / dt,
                  (pusher.after.to - pusher.before.to) / dt);
        }
        for (std::int32_t j = i + 1; j < number; ++j) touch_pair(bodies, i, j);
    }
}

void CapsuleBodies::find_springs(const std::vector<BodyState>& bodies, const BodyGrip* grips, int hands,
                                 double to, double dt, double h) noexcept {
    spring_count_ = 0;
    for (int hand = 0; hand < hands; ++hand) {
        const BodyGrip& grip = grips[hand];
        if (grip.body < 0 || !(grip.stiffness > 0)) continue;
        const BodyState& body = bodies[static_cast<std::size_t>(grip.body)];
        for (std::size_t i = 0; i < static_cast<std::size_t>(grip.count); ++i) {
            Spring& spring = springs_[static_cast<std::size_t>(spring_count_++)];
            spring.body = grip.body;
            spring.hand = hand;
            spring.arm = body.rotation * grip.at[i];
            const Vector3 jaws = grip.last[i] + to * (grip.target[i] - grip.last[i]);
            const Vector3 speed = (grip.target[i] - grip.last[i]) / dt;
            const Vector3 stretch = body.position + spring.arm - (jaws - h * speed);
            // Implicit Euler of a spring and damper as a constraint with softness.
            const double scale = grip.damping + h * grip.stiffness;
            spring.softness = 1 / (h * scale);
            spring.goal = speed - grip.stiffness / scale * stretch;
            spring.most = h * grip.most;
            spring.impulse.setZero();
            spring.inverse =
                (answer(grip.body, spring.arm) + spring.softness * Matrix3::Identity()).inverse();
        }
    }
}

void CapsuleBodies::begin_sweeps(const std::vector<BodyState>& bodies, const BodyPusher* pushers,
                                 double h) noexcept {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        motions_[i].velocity = lanes_of(bodies[i].velocity);
        motions_[i].spin = lanes_of(bodies[i].spin);
        for (int c = 0; c < 3; ++c) motions_[i].inverse_inertia[c] = lanes_of(inverse_inertia_[i].col(c));
    }
    order_contacts(static_cast<std::int32_t>(bodies.size()));
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        const Contact& contact = contacts_[i];
        Constraint& constraint = constraints_[static_cast<std::size_t>(place_[i])];
        constraint.first = contact.first;
        constraint.second = contact.second;
        constraint.normal = lanes_of(contact.normal);
        constraint.on_first = lanes_of(contact.on_first);
        constraint.on_second = lanes_of(contact.on_second);
        constraint.speed = lanes_of(contact.speed);
        constraint.drag = all_lanes(0);
        constraint.push = 0;
        constraint.share_normal = contact.share_normal;
        constraint.share_along = contact.share_along;
        // Bodies may close a gap, and part where they overlap. An instrument pushes as a spring does.
        constraint.softness = 0;
        constraint.least = -contact.gap / h;
        if (contact.pusher >= 0) {
            const BodyPusher& pusher = pushers[contact.pusher];
            const double scale = pusher.damping + h * pusher.stiffness;
            constraint.softness = 1 / (h * scale);
            constraint.least = -pusher.stiffness / scale * contact.gap;
        } else if (contact.gap < 0) {
            constraint.least =
                std::min(correction * std::max(0.0, -contact.gap - slop) / h, fastest_correction);
        }
    }
}

// A contact waits for the velocities that the one before it gave the same body. Contacts of other bodies in
// between keep the processor busy. Each body's contacts stay in the order in which they were found, so that
// the result is the same to the bit.
void CapsuleBodies::order_contacts(std::int32_t bodies) noexcept {
    std::array<std::int32_t, most_bodies> next;  // contact of each body, count_ at its end
    const auto after = [&](std::int32_t body, std::int32_t contact) {
        while (contact < count_ && contacts_[static_cast<std::size_t>(contact)].first != body &&
               contacts_[static_cast<std::size_t>(contact)].second != body)
            ++contact;
        return contact;
    };
    for (std::int32_t b = 0; b < bodies; ++b) next[static_cast<std::size_t>(b)] = after(b, 0);
    // The earliest contact that is left is the next one of its bodies: each round places one or more.
    for (std::int32_t placed = 0; placed < count_;) {
        for (std::int32_t b = 0; b < bodies; ++b) {
            const std::int32_t i = next[static_cast<std::size_t>(b)];
            if (i == count_) continue;
            const Contact& contact = contacts_[static_cast<std::size_t>(i)];
            const std::int32_t other = contact.first == b ? contact.second : contact.first;
            if (other >= 0 && next[static_cast<std::size_t>(other)] != i) continue;
            place_[static_cast<std::size_t>(i)] = placed++;
            next[static_cast<std::size_t>(b)] = after(b, i + 1);
            if (other >= 0) next[static_cast<std::size_t>(other)] = after(other, i + 1);
        }
    }
}

void CapsuleBodies::shift(Motion& motion, const Lanes& arm, const Lanes& impulse) const noexcept {
    motion.velocity += impulse / all_lanes(shape_.mass);
    motion.spin += times(motion.inverse_inertia, cross(arm, impulse));
}

void CapsuleBodies::pull(Spring& spring) noexcept {
    Motion& motion = motions_[static_cast<std::size_t>(spring.body)];
    const Vector3 speed = vector_of(motion.velocity) + vector_of(motion.spin).cross(spring.arm);
    const Vector3 before = spring.impulse;
    spring.impulse += spring.inverse * (spring.goal - speed - spring.softness * spring.impulse);
    // Another hand or a post may take the body along within the step.
    const double size = spring.impulse.norm();
    if (size > spring.most) spring.impulse *= spring.most / size;
    shift(motion, lanes_of(spring.arm), lanes_of(Vector3(spring.impulse - before)));
}

void CapsuleBodies::press(Constraint& contact) noexcept {
    Motion& one = motions_[static_cast<std::size_t>(contact.first)];
    Motion* const two = contact.second >= 0 ? &motions_[static_cast<std::size_t>(contact.second)] : nullptr;
    const auto relative = [&] {
        Lanes speed = one.velocity + cross(one.spin, contact.on_first) - contact.speed;
        if (two != nullptr) speed -= two->velocity + cross(two->spin, contact.on_second);
        return speed;
    };
    const auto push_bodies = [&](const Lanes& impulse) {
        shift(one, contact.on_first, impulse);
        if (two != nullptr) shift(*two, contact.on_second, -impulse);
    };
    const double before = contact.push;
    const double closing = dot(relative(), contact.normal);
    contact.push = std::max(0.0, before + (contact.least - closing - contact.softness * before) /
                                              (contact.share_normal + contact.softness));
    push_bodies(all_lanes(contact.push - before) * contact.normal);
    // Friction, within the cone.
    const Lanes speed = relative();
    const Lanes sliding = speed - all_lanes(dot(speed, contact.normal)) * contact.normal;
    Lanes drag = contact.drag - sliding / all_lanes(contact.share_along);
    const double most = ground_.friction * contact.push, size = std::sqrt(dot(drag, drag));
    if (size > most) drag *= all_lanes(size > 0 ? most / size : 0.0);
    push_bodies(drag - contact.drag);
    contact.drag = drag;
}

void CapsuleBodies::end_sweeps(std::vector<BodyState>& bodies, BodyGrip* grips, BodyPusher* pushers,
                               double dt) const noexcept {
    for (int i = 0; i < spring_count_; ++i)
        grips[springs_[static_cast<std::size_t>(i)].hand].force +=
            springs_[static_cast<std::size_t>(i)].impulse / dt;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
        const Contact& contact = contacts_[i];
        const Constraint& pressed = constraints_[static_cast<std::size_t>(place_[i])];
        if (contact.pusher < 0) continue;
        const Vector3 force = (pressed.push * contact.normal + vector_of(pressed.drag)) / dt;
        pushers[contact.pusher].force += force;
        pushers[contact.pusher].force_at_end += contact.along * force;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bodies[i].velocity = vector_of(motions_[i].velocity);
        bodies[i].spin = vector_of(motions_[i].spin);
    }
}

void CapsuleBodies::step(std::vector<BodyState>& bodies, BodyGrip* grips, BodyPusher* pushers, int hands,
                         double dt) noexcept {
    const int substeps = std::max(1, static_cast<int>(std::ceil(dt / substep - 1e-9)));
    const double h = dt / substeps;
    for (int hand = 0; hand < hands; ++hand)
        grips[hand].force = pushers[hand].force = pushers[hand].force_at_end = Vector3::Zero();
    for (int s = 0; s < substeps; ++s) {
        const double to = (s + 1.0) / substeps;
        begin_substep(bodies, h);
        find_contacts(bodies, pushers, hands, to, dt);
        find_springs(bodies, grips, hands, to, dt, h);
        begin_sweeps(bodies, pushers, h);
        for (int sweep = 0; sweep < sweeps; ++sweep) {
            for (int i = 0; i < spring_count_; ++i) pull(springs_[static_cast<std::size_t>(i)]);
            for (int i = 0; i < count_; ++i) press(constraints_[static_cast<std::size_t>(i)]);
        }
        end_sweeps(bodies, grips, pushers, dt);
        for (BodyState& body : bodies) {
            const double speed = body.velocity.norm(), spin = body.spin.norm();
            if (speed > fastest) body.velocity *= fastest / speed;
            if (spin > fastest_spin) body.spin *= fastest_spin / spin;
            body.position += h * body.velocity;
            const Vector3 half = 0.5 * h * body.spin;
            const Quaternion turn(1, half.x(), half.y(), half.z());
            body.rotation = (turn * body.rotation).normalized();
        }
    }
}

}  // namespace fulcrum
