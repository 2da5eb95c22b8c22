// SPDX-License-Identifier: Apache-2.0
// The dynamic step (implicit Euler) and the static solve: assembly of the inputs, solver level, and the
// fallback sequence after a failure.
#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/rod/rod_newton.h"

namespace fulcrum {
namespace {

// Of a segment within one step, in its rest lengths: from here on the step is made in smaller parts.
constexpr double doubtful_stretch = 2;

bool good(const Vector3& v) {
    return std::isfinite(v.x() + v.y() + v.z());
}

bool finite_inputs(const RodInputs& inputs) {
    bool ok = good(inputs.gravity);
    for (const RodFrame& end : inputs.ends)
        ok = ok && good(end.position) && std::isfinite(end.rotation.sum());
    for (const RodLoad& load : inputs.loads)
        ok = ok && good(load.force) && good(load.moment) && std::isfinite(load.s);
    for (const Vector3& force : inputs.nodal_forces) ok = ok && good(force);
    for (const RodTether& t : inputs.tethers) {
        ok = ok && good(t.anchor) && good(t.offset) &&
             std::isfinite(t.stiffness + t.rest_length + t.damping + t.s);
    }
    for (const RodGrasp& g : inputs.grasps)
        ok = ok && good(g.target) && good(g.offset) && good(g.reaction) && good(g.moment) &&
             std::isfinite(g.s) && g.stiffness >= 0 && g.most >= 0 &&
             (!g.hold_rotation || std::isfinite(g.target_rotation.sum()));
    for (const RodContact& c : inputs.contacts) {
        ok = ok && good(c.normal) && good(c.point) && good(c.surface_velocity) &&
             std::isfinite(c.s + c.radius + c.lambda + c.friction);
    }
    for (const RodSelfContact& c : inputs.self_contacts) {
        ok = ok && good(c.normal) && std::isfinite(c.s + c.other_s + c.distance + c.lambda);
    }
    return ok;
}

// Locates the points of all constraints; the scratch grows only if there are more than it was made for.
void locate_all(const Rod::Tables& tables, RodInputs& inputs, RodScratch::Data& d) {
    const auto grow = [](auto& array, std::size_t size, const auto& value) {
        if (array.size() < size) array.resize(size, value);
    };
    grow(d.tether_points, inputs.tethers.size(), RodPoint{});
    grow(d.tether_start, inputs.tethers.size(), Vector3(Vector3::Zero()));
    grow(d.grasp_points, inputs.grasps.size(), RodPoint{});
    grow(d.turn_target, inputs.grasps.size(), Matrix3(Matrix3::Identity()));
    for (auto* array : {&d.grasp_lambda, &d.grasp_force, &d.grasp_target, &d.turn_lambda, &d.turn_force}) {
        grow(*array, inputs.grasps.size(), Vector3(Vector3::Zero()));
    }
    grow(d.contact_points, inputs.contacts.size(), RodPoint{});
    grow(d.contact_start, inputs.contacts.size(), Vector3(Vector3::Zero()));
    for (auto* array : {&d.contact_lambda, &d.contact_force, &d.contact_start_lambda})
        grow(*array, inputs.contacts.size(), 0.0);
    grow(d.contact_active, inputs.contacts.size(), char{0});
    grow(d.self_points, 2 * inputs.self_contacts.size(), RodPoint{});
    for (auto* array : {&d.self_lambda, &d.self_force}) grow(*array, inputs.self_contacts.size(), 0.0);
    for (std::size_t i = 0; i < inputs.tethers.size(); ++i)
        d.tether_points[i] = locate(tables, inputs.tethers[i].s);
    for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
        d.grasp_points[i] = locate(tables, inputs.grasps[i].s);
        d.grasp_lambda[i] = d.grasp_force[i] = -inputs.grasps[i].reaction;
        d.turn_lambda[i] = d.turn_force[i] =
            inputs.grasps[i].hold_rotation ? Vector3(-inputs.grasps[i].moment) : Vector3(Vector3::Zero());
    }
    for (std::size_t i = 0; i < inputs.contacts.size(); ++i) {
        const RodContact& contact = inputs.contacts[i];
        d.contact_points[i] = locate(tables, contact.s);
        d.contact_lambda[i] = d.contact_force[i] = d.contact_start_lambda[i] =
            contact.lambda > 0 ? contact.lambda : 0;
    }
    for (std::size_t i = 0; i < inputs.self_contacts.size(); ++i) {
        const RodSelfContact& contact = inputs.self_contacts[i];
        d.self_points[2 * i] = locate(tables, contact.s);
        d.self_points[2 * i + 1] = locate(tables, contact.other_s);
        d.self_lambda[i] = d.self_force[i] = contact.lambda > 0 ? contact.lambda : 0;
    }
}

// Dead forces per node, with the directions of d.shape.
void gather_loads(const Rod::Tables& tables, const RodInputs& inputs, RodScratch::Data& d) {
    const std::size_t nodes = tables.mass.size();
    for (std::size_t i = 0; i < nodes; ++i) {
        Vector3 force = tables.mass[i] * inputs.gravity;
        if (i < inputs.nodal_forces.size()) force += inputs.nodal_forces[i];
        store_lanes(&d.dead[4 * i], Lanes{force.x(), force.y(), force.z(), 0});
    }
    for (const RodLoad& load : inputs.loads) {
        const RodPoint point = locate(tables, load.s);
        const auto base = static_cast<std::size_t>(point.joint) - 1;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t c = 0; c < 3; ++c) {
                d.dead[4 * (base + k) + c] += point.node_weight[k] * load.force[static_cast<Eigen::Index>(c)];
            }
        }
        if (load.moment.isZero(0)) continue;
        for (std::size_t q = 0; q < 2; ++q) {
            const std::size_t j = base + q;
            const Vector3 t(d.shape.tx[j + 1], d.shape.ty[j + 1], d.shape.tz[j + 1]);
            const Vector3 couple = load.moment.cross(t) * (d.shape.inverse[j + 1] * point.segment_weight[q]);
            for (std::size_t c = 0; c < 3; ++c) {
                d.dead[4 * j + c] -= couple[static_cast<Eigen::Index>(c)];
                d.dead[4 * (j + 1) + c] += couple[static_cast<Eigen::Index>(c)];
            }
            d.dead[4 * j + 3] += point.segment_weight[q] * load.moment.dot(t);
        }
    }
    Lanes sum = all_lanes(0);
    for (std::size_t i = 0; i < nodes; ++i) {
        const Lanes f = load_lanes(&d.dead[4 * i]) * Lanes{1, 1, 1, 0};
        sum += f * f;
    }
    d.dead_norm = std::sqrt(sum_lanes(sum));
}

// Rotation of the section held by a grasp, orthonormal, and the angle from it to the requested one.
Matrix3 held_rotation(const RodShape& shape, const RodPoint& point) {
    RodPoint turning = point;
    turning.node_weight[0] = turning.node_weight[1] = turning.node_weight[2] = 0;
    Matrix3 now;
    for (int k = 0; k < 3; ++k) now.col(k) = wall_position(shape, turning, Vector3::Unit(k));
    now.col(2).normalize();
    now.col(0) = (now.col(0) - now.col(2) * now.col(2).dot(now.col(0))).normalized();
    now.col(1) = now.col(2).cross(now.col(0));
    return now;
}

// Moment of a held rotation's multiplier: sum of b x (multiplier x T) / 2; equal to the multiplier itself if
// the section is at its target and its blend rigid.
Vector3 held_moment(const RodShape& shape, const RodPoint& point, const Matrix3& target,
                    const Vector3& multiplier) {
    RodPoint turning = point;
    turning.node_weight[0] = turning.node_weight[1] = turning.node_weight[2] = 0;
    Vector3 moment = Vector3::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vector3 axis = wall_position(shape, turning, Vector3::Unit(k));
        moment += 0.5 * axis.cross(multiplier.cross(Vector3(target.col(k))));
    }
    return moment;
}

double angle_between(const Matrix3& a, const Matrix3& b) {
    return math::acos(0.5 * ((a.transpose() * b).trace() - 1));
}

// Rotation interpolated from `from` to `to` by `share`, along the shortest path.
Matrix3 between(const Matrix3& from, const Matrix3& to, double share) {
    if (share >= 1) return to;
    const Matrix3 turn = to * from.transpose();
    const double angle = share * angle_between(from, to);
    Vector3 axis(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0), turn(1, 0) - turn(0, 1));
    if (axis.norm() < 1e-9) {
        // For half a turn the axis is the largest column of (R + 1).
        int largest = 0;
        for (int k = 1; k < 3; ++k) largest = turn(k, k) > turn(largest, largest) ? k : largest;
        axis = turn.col(largest) + Vector3(Vector3::Unit(largest));
        if (angle < 1e-6 || axis.norm() < 1e-9) return to;
    }
    axis.normalize();
    Matrix3 rotation;
    const double sine = math::sin(angle), cosine = math::cos(angle);
    for (int k = 0; k < 3; ++k) {
        const Vector3 v = from.col(k);
        rotation.col(k) = v * cosine + axis.cross(v) * sine + axis * (axis.dot(v) * (1 - cosine));
    }
    return rotation;
}

// Gyroscopic term: a spinning segment whose tangent t turns at the rate t' needs the moment I s t x t', which
// its neighbours supply. Without it the angular momentum of the spin is lost as the rod turns. It does no
// work. Omitted if damping removes momentum anyway.
void carry_spin(const Rod::Tables& tables, const RodState& state, RodScratch::Data& d) {
    for (std::size_t j = 0; j < state.spins.size(); ++j) {
        const Vector3 t(d.shape.tx[j + 1], d.shape.ty[j + 1], d.shape.tz[j + 1]);
        const double inverse = d.shape.inverse[j + 1];
        const Vector3 rate = inverse * (state.velocities[j + 1] - state.velocities[j]);
        const Vector3 force = tables.spin_inertia[j] * state.spins[j] * inverse * t.cross(rate);
        for (std::size_t c = 0; c < 3; ++c) {
            d.dead[4 * j + c] -= force[static_cast<Eigen::Index>(c)];
            d.dead[4 * (j + 1) + c] += force[static_cast<Eigen::Index>(c)];
        }
    }
}

// Everything that stays constant during the iterations of one solve. dt 0: statics.
void prepare(const Rod& rod, const RodState& state, RodInputs& inputs, double dt, RodScratch::Data& d) {
    const Rod::Tables& tables = rod.tables();
    const RodSpec& spec = rod.spec();
    const std::size_t n = static_cast<std::size_t>(tables.segments);
    d.dt = dt;
    const bool alone = inputs.grasps.empty() && inputs.contacts.empty() && inputs.self_contacts.empty() &&
                       inputs.tethers.empty();
    const bool first = spec.ends[0] != RodEnd::free, last = spec.ends[1] != RodEnd::free;
    d.anchor = dt <= 0 && alone && first != last ? (first ? 0 : 1) : -1;
    for (std::size_t e = 0; e < 2; ++e) d.fixed[e] = spec.ends[e] != RodEnd::free;
    gather_loads(tables, inputs, d);
    const double cell = rod.length() / rod.segments();
    const double bending = 12 * rod.bending_stiffness() / (cell * cell * cell);
    for (std::size_t i = 0; i <= n; ++i) {
        Lanes weight = all_lanes(0);
        Lanes predicted = load_lanes(&d.shape.position[4 * i]);
        if (dt > 0) {
            const double rate = 1 / (dt * dt) + spec.mass_damping / dt,
                         carry = dt / (1 + spec.mass_damping * dt);
            const double spin = i < n ? tables.spin_inertia[i] : 0, turning = i < n ? state.spins[i] : 0;
            const Vector3& v = state.velocities[i];
            weight = Lanes{tables.mass[i], tables.mass[i], tables.mass[i], spin} * rate;
            predicted += Lanes{v.x(), v.y(), v.z(), turning} * carry;
        }
        store_lanes(&d.inertia[4 * i], weight);
        store_lanes(&d.predicted[4 * i], predicted);
        const double turn = rod.torsional_stiffness() / cell;
        store_lanes(&d.shift_weight[4 * i], Lanes{bending, bending, bending, turn} + weight);
    }
    if (dt > 0 && spec.mass_damping <= 0) carry_spin(tables, state, d);
    if (dt > 0) {
        for (std::size_t i = 0; i < inputs.contacts.size(); ++i)
            d.contact_start[i] = point_position(d.shape, d.contact_points[i]);
        for (std::size_t i = 0; i < inputs.tethers.size(); ++i) {
            d.tether_start[i] = wall_position(d.shape, d.tether_points[i], inputs.tethers[i].offset) -
                                inputs.tethers[i].anchor;
        }
    }
}

void write_outputs(const Rod& rod, RodInputs& inputs, RodScratch::Data& d, RodReport& report) {
    report.constraint_residual = d.constraint_residual;
    report.penetration = d.penetration;
    report.contact_sum = 0;
    for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
        inputs.grasps[i].reaction = -d.grasp_force[i];
        if (inputs.grasps[i].hold_rotation)
            inputs.grasps[i].moment =
                -held_moment(d.shape, d.grasp_points[i], d.turn_target[i], d.turn_force[i]);
        inputs.grasps[i].residual =
            (wall_position(d.shape, d.grasp_points[i], inputs.grasps[i].offset) - inputs.grasps[i].target)
                .norm();
    }
    for (std::size_t i = 0; i < inputs.contacts.size(); ++i) {
        RodContact& contact = inputs.contacts[i];
        contact.lambda = d.contact_force[i];
        contact.gap =
            contact.normal.dot(point_position(d.shape, d.contact_points[i]) - contact.point) - contact.radius;
        report.contact_sum += contact.lambda;
    }
    for (std::size_t i = 0; i < inputs.self_contacts.size(); ++i) {
        RodSelfContact& contact = inputs.self_contacts[i];
        contact.lambda = d.self_force[i];
        contact.gap = contact.normal.dot(point_position(d.shape, d.self_points[2 * i]) -
                                         point_position(d.shape, d.self_points[2 * i + 1])) -
                      contact.distance;
    }
    const std::size_t n = static_cast<std::size_t>(rod.segments());
    for (std::size_t e = 0; e < 2; ++e) {
        if (!d.fixed[e]) continue;
        const double* g = &d.gradient[e == 0 ? 0 : 4 * n];
        report.end_force[e] = Vector3(g[0], g[1], g[2]);
        const std::size_t segment = e == 0 ? 1 : n;
        const double* pull = e == 0 ? &d.joints.gradient_b[0] : &d.joints.gradient_a[4 * n];
        const Vector3 t(d.shape.tx[segment], d.shape.ty[segment], d.shape.tz[segment]);
        const Vector3 edge = t * d.shape.length[segment];
        report.end_moment[e] = -(edge.cross(Vector3(pull[0], pull[1], pull[2])) + t * pull[3]);
    }
}

// Restores the previous shape, at rest: the result must not be used.
void freeze_shape(RodState& state, const RodState& saved, RodReport& report) {
    state = saved;
    Rod::stop(state);
    report.converged = false;
    report.fault = RodFault::frozen;
    if (!std::isfinite(report.residual + report.force_residual)) report.residual = report.force_residual = 1;
}

// Largest jump of a grasp's target since the last step, in segment lengths; a turn of half a radian counts as
// one.
double leap_of(const Rod& rod, const RodState& state, const RodInputs& inputs) {
    double leap = 0;
    for (const RodGrasp& grasp : inputs.grasps) {
        const double distance = (grasp.target - rod.wall_point(state, grasp.s, grasp.offset)).norm();
        leap = distance > leap ? distance : leap;
    }
    leap *= rod.segments() / rod.length();
    for (const RodGrasp& grasp : inputs.grasps) {
        // A section that has to turn by more than a radian has no constraint force towards its target.
        if (!grasp.hold_rotation) continue;
        const double turn = angle_between(rod.frame_at(state, grasp.s).frame.rotation, grasp.target_rotation);
        leap = 2 * turn > leap ? 2 * turn : leap;
    }
    return leap;
}

// By how much a segment became longer since the step's start at most, in rest lengths. A load that appears at
// once can drive Newton's method to a balance in which a segment is folded over; smaller parts do not get
// there.
double longest_stretch(const Rod::Tables& tables, const RodState& before, const RodState& after) {
    double longest = 0;
    for (std::size_t j = 0; j < tables.rest_length.size(); ++j) {
        const double was = (before.nodes[j + 1] - before.nodes[j]).norm();
        const double is = (after.nodes[j + 1] - after.nodes[j]).norm();
        longest = std::max(longest, (is - was) / tables.rest_length[j]);
    }
    return longest;
}

// From the motion within the part that was just solved; rate: one over its time, 1/s.
void set_velocities(const RodScratch::Data& d, double rate, RodState& state) {
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
        const double *now = &d.shape.position[4 * i], *start = &d.start.position[4 * i];
        state.velocities[i] = Vector3(now[0] - start[0], now[1] - start[1], now[2] - start[2]) * rate;
        if (i < state.spins.size()) state.spins[i] = now[3] * rate;
    }
}

// Targets of ends and grasps after `share` of the remaining motion.
void set_targets(const RodState& state, const RodInputs& inputs, double share, RodScratch::Data& d) {
    const std::size_t n = state.nodes.size() - 1;
    d.target[0] = state.nodes[0] + (inputs.ends[0].position - state.nodes[0]) * share;
    d.target[1] = state.nodes[n] + (inputs.ends[1].position - state.nodes[n]) * share;
    for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
        const Vector3 now = wall_position(d.shape, d.grasp_points[i], inputs.grasps[i].offset);
        d.grasp_target[i] = now + (inputs.grasps[i].target - now) * share;
        if (inputs.grasps[i].hold_rotation) {
            d.turn_target[i] =
                between(held_rotation(d.shape, d.grasp_points[i]), inputs.grasps[i].target_rotation, share);
        }
    }
}

}  // namespace

RodReport Rod::step(RodState& state, RodInputs& inputs, double dt, RodScratch& scratch,
                    const RodSolve& solve) const {
    RodReport report;
    RodScratch::Data& d = scratch.data();
    d.saved = state;
    d.saved_grasps.assign(inputs.grasps.begin(), inputs.grasps.end());
    const auto freeze = [&] {
        freeze_shape(state, d.saved, report);
        for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
            inputs.grasps[i].reaction = d.saved_grasps[i].reaction;
            inputs.grasps[i].moment = d.saved_grasps[i].moment;
        }
    };
    if (!(dt >= 1e-6 && dt <= 1.0) || !finite_inputs(inputs) || !finite(state)) {
        report.finite = false;
        if (finite(state)) {
            freeze();
        } else {
            report.fault = RodFault::frozen;
        }
        return report;
    }
    const bool one = solve.level == RodSolve::Level::linearised;
    const int limit =
        one ? 1
            : (solve.iterations > 0 ? solve.iterations : (solve.level == RodSolve::Level::newton ? 25 : 4));
    // A grasp target that jumps is followed in parts from the start.
    const double leap = leap_of(*this, state, inputs);
    for (int parts = leap > 2 ? 4 : (leap > 1 ? 2 : 1); parts <= 8; parts *= 2) {
        report.substeps = parts;
        report.iterations = 0;
        NewtonResult result;
        double folded_stretch = 0;
        for (int part = 0; part < parts; ++part) {
            RodFrame ends[2] = {inputs.ends[0], inputs.ends[1]};
            shape_from_state(*tables_, spec_, state, ends, d.shape);
            if (part == 0) locate_all(*tables_, inputs, d);
            prepare(*this, state, inputs, dt / parts, d);
            // Well beyond what the loads can stretch the rod to: no answer.
            if (part == 0) folded_stretch = 4 * (1 + d.dead_norm / axial_stiffness_);
            const double share = 1.0 / (parts - part);
            set_targets(state, inputs, share, d);
            std::copy(d.shape.position.begin(), d.shape.position.end(), d.start.position.begin());
            if (spec_.stiffness_damping > 0) {
                // The elastic tangent where it is positive: taken at the start, without inertia, loads or
                // constraints.
                add_damping(*tables_, spec_, dt / parts, d);
            }
            result = newton(*tables_, inputs, d, limit, solve.tolerance, solve.constraint_tolerance, one);
            report.iterations += result.iterations;
            if (!result.finite) break;
            state_from_shape(d.shape, state);
            set_velocities(d, parts / dt, state);
        }
        report.residual = result.residual;
        report.force_residual = result.force_residual;
        report.converged = result.converged;
        report.positive_definite = result.positive_definite;
        report.finite = result.finite && finite(state);
        const double stretched = report.finite ? longest_stretch(*tables_, d.saved, state) : 0;
        const bool acceptable =
            stretched < doubtful_stretch && report.finite &&
            (result.converged || solve.level != RodSolve::Level::newton || result.residual < 1e-3);
        if (acceptable ||
            (report.finite && stretched < folded_stretch && parts == 8 && result.residual < 0.1)) {
            report.fault = parts > 1 ? RodFault::substepped : RodFault::none;
            state.ends[0] = inputs.ends[0];
            state.ends[1] = inputs.ends[1];
            write_outputs(*this, inputs, d, report);
            return report;
        }
        state = d.saved;
    }
    freeze();
    return report;
}

RodReport Rod::solve(RodState& state, RodInputs& inputs, RodScratch& scratch, const RodSolve& solve) const {
    RodReport report;
    RodScratch::Data& d = scratch.data();
    d.saved = state;
    d.saved_grasps.assign(inputs.grasps.begin(), inputs.grasps.end());
    stop(state);
    if (!finite_inputs(inputs) || !finite(state)) {
        report.finite = false;
        report.fault = RodFault::frozen;
        return report;
    }
    const bool one = solve.level == RodSolve::Level::linearised;
    const int limit = solve.iterations > 0 ? solve.iterations : (one ? 1 : 200);
    shape_from_state(*tables_, spec_, state, inputs.ends, d.shape);
    locate_all(*tables_, inputs, d);
    prepare(*this, state, inputs, 0, d);
    d.target[0] = inputs.ends[0].position;
    d.target[1] = inputs.ends[1].position;
    double turn = 0;
    for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
        d.grasp_target[i] = inputs.grasps[i].target;
        d.turn_target[i] = inputs.grasps[i].target_rotation;
        if (!inputs.grasps[i].hold_rotation) continue;
        const double angle = angle_between(held_rotation(d.shape, d.grasp_points[i]), d.turn_target[i]);
        turn = angle > turn ? angle : turn;
    }
    NewtonResult result;
    // A section that has to turn far is turned in parts: beyond a right angle there is no force towards the
    // target.
    for (int parts = 1 + static_cast<int>(turn); parts >= 1; --parts) {
        for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
            if (!inputs.grasps[i].hold_rotation) continue;
            d.turn_target[i] = between(held_rotation(d.shape, d.grasp_points[i]),
                                       inputs.grasps[i].target_rotation, 1.0 / parts);
        }
        result = newton(*tables_, inputs, d, limit, solve.tolerance, solve.constraint_tolerance, one);
        report.iterations += result.iterations;
        if (!result.finite) break;
    }
    report.residual = result.residual;
    report.force_residual = result.force_residual;
    report.converged = result.converged;
    report.positive_definite = result.positive_definite;
    if (result.finite) state_from_shape(d.shape, state);
    report.finite = result.finite && finite(state);
    if (!report.finite) {
        freeze_shape(state, d.saved, report);
        return report;
    }
    state.ends[0] = inputs.ends[0];
    state.ends[1] = inputs.ends[1];
    write_outputs(*this, inputs, d, report);
    return report;
}

}  // namespace fulcrum
