// SPDX-License-Identifier: Apache-2.0
// Constraints on the rod: tethers (convex energy), grasps and contacts. Multipliers enter in a proximal
// (augmented Lagrangian) form,
//     [H  J^T; J  -1/rho] [dx; dl] = -[grad + J^T l; c],  eliminated to
//     (H + rho J^T J) dx = -grad - J^T (l + rho c).
// The multiplier of a grasp is set to l + rho c after every Newton step, those of contacts when the forces
// balance. The matrix keeps its band, sixty contacts cost little, and at convergence c = 0 and l is the
// reaction (proximal method of multipliers; Rockafellar 1976).
#include <cmath>

#include "sim_core/rod/rod_system.h"

namespace fulcrum {
namespace {

inline Vector3 node(const RodShape& shape, std::size_t i) {
    return Vector3(shape.position[4 * i], shape.position[4 * i + 1], shape.position[4 * i + 2]);
}
inline Vector3 tangent(const RodShape& shape, std::size_t j) {
    return Vector3(shape.tx[j + 1], shape.ty[j + 1], shape.tz[j + 1]);
}
inline Vector3 director(const RodShape& shape, std::size_t j) {
    return Vector3(shape.dx[j + 1], shape.dy[j + 1], shape.dz[j + 1]);
}

// Location of stencil block (joint - 1 + r, joint - 1 + c), r >= c.
inline Block4& block(BlockBand& matrix, std::size_t base, std::size_t r, std::size_t c) {
    return r == c ? matrix.diagonal[base + c]
                  : (r == c + 1 ? matrix.first[base + c] : matrix.second[base + c]);
}

// A symmetric stiffness acting on the motion of the point, distributed to its three nodes by their weights.
inline void add_stiffness(BlockBand& matrix, const RodPoint& point, const Matrix3& stiffness) {
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t r = c; r < 3; ++r) {
            const double w = point.node_weight[r] * point.node_weight[c];
            Block4& b = block(matrix, base, r, c);
            for (int q = 0; q < 3; ++q)
                b.column[q] += Lanes{stiffness(0, q), stiffness(1, q), stiffness(2, q), 0} * w;
        }
    }
}

// gradient += J^T force
void add_gradient(const RodJacobian& j, std::size_t base, const Vector3& force,
                  std::vector<double>& gradient) {
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 4; ++c) gradient[4 * (base + k) + c] += j.column[k][c].dot(force);
    }
}

// matrix += J^T K J, K symmetric
void add_hessian(const RodJacobian& j, std::size_t base, const Matrix3& stiffness, BlockBand& matrix) {
    Vector3 kj[3][4];
    for (int k = 0; k < 3; ++k) {
        for (int c = 0; c < 4; ++c) kj[k][c].noalias() = stiffness * j.column[k][c];
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t r = c; r < 3; ++r) {
            Block4& b = block(matrix, base, r, c);
            for (int q = 0; q < 4; ++q) {
                const Vector3& right = kj[c][q];
                b.column[q] += Lanes{j.column[r][0].dot(right), j.column[r][1].dot(right),
                                     j.column[r][2].dot(right), j.column[r][3].dot(right)};
            }
        }
    }
}

// Second derivative of force . (R X) of one segment in edge variables, added as node blocks.
void add_geometric(const RodShape& shape, std::size_t segment, const Vector3& offset, const Vector3& force,
                   double weight, BlockBand& matrix) {
    if (weight == 0 || offset.isZero(0)) return;
    const Vector3 t = tangent(shape, segment), d1 = director(shape, segment), d2 = t.cross(d1);
    const Vector3 across = d1 * offset.x() + d2 * offset.y(), turned = t.cross(across);
    const double along = offset.z(), scale = shape.inverse[segment + 1];
    const double ft = force.dot(t);
    const Vector3 f = force - t * ft;
    // Edge part / (scale^2): -along (t f^T + f t^T + ft P) + ft (t a^T + a t^T) - (a f^T + f a^T) / 2
    const Vector3 left = across * ft - f * along;
    Matrix3 e =
        t * left.transpose() + left * t.transpose() - 0.5 * (across * f.transpose() + f * across.transpose());
    e -= along * ft * (Matrix3::Identity() - t * t.transpose());
    e *= weight * scale * scale;
    const Vector3 mixed = turned * (-ft * weight * scale);
    const double angle = -weight * across.dot(f);
    Block4 &a = matrix.diagonal[segment], &b = matrix.diagonal[segment + 1], &ab = matrix.first[segment];
    for (int c = 0; c < 3; ++c) {
        const Lanes column{e(0, c), e(1, c), e(2, c), 0};
        a.column[c] += column - Lanes{0, 0, 0, mixed[c]};
        b.column[c] += column;
        ab.column[c] -= column;
    }
    const Lanes m{mixed.x(), mixed.y(), mixed.z(), 0};
    a.column[3] += Lanes{0, 0, 0, angle} - m;
    ab.column[3] += m;
}

void add_wall_geometric(const RodShape& shape, const RodPoint& point, const Vector3& offset,
                        const Vector3& force, BlockBand& matrix) {
    const auto joint = static_cast<std::size_t>(point.joint);
    add_geometric(shape, joint - 1, offset, force, point.segment_weight[0], matrix);
    add_geometric(shape, joint, offset, force, point.segment_weight[1], matrix);
}

// The same section without the position weights: the part of a wall point that rotates.
RodPoint turning_point(RodPoint point) {
    point.node_weight[0] = point.node_weight[1] = point.node_weight[2] = 0;
    return point;
}

// J dx
Vector3 moved(const RodJacobian& j, std::size_t base, const std::vector<double>& step) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 4; ++c) sum += j.column[k][c] * step[4 * (base + k) + c];
    }
    return sum;
}

// n . (motion of the centre line)
double approach(const RodPoint& point, const Vector3& normal, const std::vector<double>& step) {
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c)
            sum += point.node_weight[k] * normal[static_cast<Eigen::Index>(c)] * step[4 * (base + k) + c];
    }
    return sum;
}

// Rotation error of a held section relative to its target, and the derivative: c = 1/2 sum_k T_k x b_k, T the
// target's axes and b the blended directors. For a section turned by phi about an axis u it is sin(phi) u.
Vector3 held_turn(const RodShape& shape, const RodPoint& turning, const Matrix3& target,
                  RodJacobian& jacobian) {
    RodJacobian by_axis;
    for (auto& row : jacobian.column) {
        for (Vector3& column : row) column.setZero();
    }
    Vector3 away = Vector3::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vector3 axis = Vector3::Unit(k), wanted = 0.5 * target.col(k);
        away += wanted.cross(wall_position(shape, turning, axis));
        wall_jacobian(shape, turning, axis, by_axis);
        for (int q = 0; q < 3; ++q) {
            for (int c = 0; c < 4; ++c) jacobian.column[q][c] += wanted.cross(by_axis.column[q][c]);
        }
    }
    return away;
}

// Holds the rotation. Linear in the directors, so the section's own second derivative is all that its
// curvature adds.
void add_held_rotation(const Rod::Tables& tables, const RodShape& shape, std::size_t i, bool hessian,
                       RodScratch::Data& data) {
    const RodPoint turning = turning_point(data.grasp_points[i]);
    const Matrix3& target = data.turn_target[i];
    const auto base = static_cast<std::size_t>(turning.joint) - 1;
    RodJacobian jacobian;
    const Vector3 away = held_turn(shape, turning, target, jacobian);
    const double size = away.norm(), stiff = tables.turn_penalty, lever = size * tables.outer_radius;
    const Vector3 lambda = data.turn_lambda[i], moment = lambda + stiff * away;
    data.constraint_residual = lever > data.constraint_residual ? lever : data.constraint_residual;
    data.turn_force[i] = moment;
    data.energy += lambda.dot(away) + 0.5 * stiff * size * size;
    data.energy_noise += 1e-15 * stiff * size;
    data.reaction_squared += moment.squaredNorm() / (tables.outer_radius * tables.outer_radius);
    add_gradient(jacobian, base, moment, data.gradient);
    if (!hessian) return;
    add_hessian(jacobian, base, stiff * Matrix3::Identity(), data.matrix);
    for (int k = 0; k < 3; ++k) {
        const Vector3 pull = 0.5 * lambda.cross(Vector3(target.col(k)));
        add_wall_geometric(shape, turning, Vector3::Unit(k), pull, data.matrix);
    }
}

}  // namespace

Vector3 point_position(const RodShape& shape, const RodPoint& point) {
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    return node(shape, base) * point.node_weight[0] + node(shape, base + 1) * point.node_weight[1] +
           node(shape, base + 2) * point.node_weight[2];
}

Vector3 wall_position(const RodShape& shape, const RodPoint& point, const Vector3& offset) {
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    Vector3 position = point_position(shape, point);
    for (std::size_t q = 0; q < 2; ++q) {
        const Vector3 t = tangent(shape, base + q), d1 = director(shape, base + q);
        position += point.segment_weight[q] * (d1 * offset.x() + t.cross(d1) * offset.y() + t * offset.z());
    }
    return position;
}

void wall_jacobian(const RodShape& shape, const RodPoint& point, const Vector3& offset,
                   RodJacobian& jacobian) {
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    for (int k = 0; k < 3; ++k) {
        for (int c = 0; c < 4; ++c) jacobian.column[k][c].setZero();
        for (int c = 0; c < 3; ++c) jacobian.column[k][c][c] = point.node_weight[k];
    }
    for (int q = 0; q < 2; ++q) {
        const double weight = point.segment_weight[q];
        if (weight == 0) continue;
        const std::size_t segment = base + static_cast<std::size_t>(q);
        const Vector3 t = tangent(shape, segment), d1 = director(shape, segment), d2 = t.cross(d1);
        const Vector3 across = d1 * offset.x() + d2 * offset.y();
        const double scale = weight * shape.inverse[segment + 1];
        for (int c = 0; c < 3; ++c) {
            // (t x P e_c) x Y = P e_c (t.Y) - t (P e_c . Y)
            Vector3 u = -t * t[c];
            u[c] += 1;
            const Vector3 by = (u * offset.z() - t * across[c]) * scale;
            jacobian.column[q + 1][c] += by;
            jacobian.column[q][c] -= by;
        }
        jacobian.column[q][3] += weight * t.cross(across);
    }
}

static void add_tethers(const RodShape& shape, RodInputs& inputs, bool hessian, RodScratch::Data& data) {
    RodJacobian jacobian;
    for (std::size_t i = 0; i < inputs.tethers.size(); ++i) {
        RodTether& tether = inputs.tethers[i];
        tether.force.setZero();
        const RodPoint& point = data.tether_points[i];
        const Vector3 away = wall_position(shape, point, tether.offset) - tether.anchor;
        const double distance = away.norm();
        const double stretch = distance - tether.rest_length;
        const bool taut = stretch > 0 && distance > 1e-12 && tether.stiffness > 0;
        if (!taut) continue;
        const Vector3 u = away / distance;
        const double tension = tether.stiffness * stretch;
        data.energy += 0.5 * tension * stretch;
        Vector3 force = u * tension;
        Matrix3 stiffness = (tether.stiffness - tension / distance) * (u * u.transpose());
        stiffness.diagonal().array() += tension / distance;
        if (tether.damping > 0 && data.dt > 0) {
            // Damps the motion along the tether since the step's start, in the tether direction at that time.
            const Vector3& start = data.tether_start[i];
            const double rate = tether.damping / data.dt, moved = u.dot(away - start);
            const double pull = rate * moved > -tension ? rate * moved : -tension;
            force += u * pull;
            if (pull == rate * moved) stiffness += rate * (u * u.transpose());
            data.energy += 0.5 * pull * moved;
        }
        tether.force = -force;
        wall_jacobian(shape, point, tether.offset, jacobian);
        const auto base = static_cast<std::size_t>(point.joint) - 1;
        add_gradient(jacobian, base, force, data.gradient);
        if (hessian) {
            add_hessian(jacobian, base, stiffness, data.matrix);
            add_wall_geometric(shape, point, tether.offset, force, data.matrix);
        }
    }
}

// Force of a grasp's spring on the rod's gradient for an error (m), and its stiffness: k e up to `most`,
// which is then the force whatever the error.
static Vector3 spring_force(const RodGrasp& grasp, const Vector3& error, Matrix3* stiffness, double& energy) {
    const double size = error.norm(), k = grasp.stiffness;
    if (k * size <= grasp.most) {
        energy = 0.5 * k * size * size;
        if (stiffness != nullptr) *stiffness = k * Matrix3::Identity();
        return k * error;
    }
    energy = grasp.most * (size - 0.5 * grasp.most / k);
    const Vector3 unit = error / size;
    if (stiffness != nullptr)
        *stiffness = grasp.most / size * (Matrix3::Identity() - unit * unit.transpose());
    return grasp.most * unit;
}

// A grasp that yields: no multiplier, as a tether.
static void add_spring_grasp(const RodShape& shape, const RodGrasp& grasp, std::size_t i,
                             const Vector3& error, bool hessian, RodScratch::Data& data) {
    const RodPoint& point = data.grasp_points[i];
    Matrix3 stiffness;
    double energy = 0;
    const Vector3 force = spring_force(grasp, error, hessian ? &stiffness : nullptr, energy);
    data.energy += energy;
    data.grasp_force[i] = force;
    data.reaction_squared += force.squaredNorm();
    RodJacobian jacobian;
    wall_jacobian(shape, point, grasp.offset, jacobian);
    const auto base = static_cast<std::size_t>(point.joint) - 1;
    add_gradient(jacobian, base, force, data.gradient);
    if (!hessian) return;
    add_hessian(jacobian, base, stiffness, data.matrix);
    add_wall_geometric(shape, point, grasp.offset, force, data.matrix);
}

// Returns the largest coordinate of a target, m.
static double add_grasps(const Rod::Tables& tables, const RodShape& shape, RodInputs& inputs, bool hessian,
                         RodScratch::Data& data) {
    RodJacobian jacobian;
    double largest_position = 0;
    for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
        RodGrasp& grasp = inputs.grasps[i];
        const RodPoint& point = data.grasp_points[i];
        const Vector3 error = wall_position(shape, point, grasp.offset) - data.grasp_target[i];
        if (!grasp.rigid()) {
            add_spring_grasp(shape, grasp, i, error, hessian, data);
            if (grasp.hold_rotation) add_held_rotation(tables, shape, i, hessian, data);
            continue;
        }
        const Vector3 lambda = data.grasp_lambda[i], force = lambda + tables.grasp_penalty * error;
        const double size = error.norm();
        data.constraint_residual = size > data.constraint_residual ? size : data.constraint_residual;
        const double reach = data.grasp_target[i].cwiseAbs().maxCoeff();
        largest_position = reach > largest_position ? reach : largest_position;
        data.energy += error.dot(lambda) + 0.5 * tables.grasp_penalty * size * size;
        data.energy_noise += 1e-15 * tables.grasp_penalty * size * reach;
        data.grasp_force[i] = force;
        data.reaction_squared += force.squaredNorm();
        wall_jacobian(shape, point, grasp.offset, jacobian);
        const auto base = static_cast<std::size_t>(point.joint) - 1;
        add_gradient(jacobian, base, force, data.gradient);
        if (hessian) {
            add_hessian(jacobian, base, tables.grasp_penalty * Matrix3::Identity(), data.matrix);
            // The multiplier alone, as in the Lagrangian: rho c is not a force before the constraint is met.
            add_wall_geometric(shape, point, grasp.offset, lambda, data.matrix);
        }
        if (grasp.hold_rotation) add_held_rotation(tables, shape, i, hessian, data);
    }
    return largest_position;
}

static void add_contacts(const Rod::Tables& tables, const RodShape& shape, const RodInputs& inputs,
                         bool hessian, RodScratch::Data& data) {
    const double penalty = tables.contact_penalty;
    for (std::size_t i = 0; i < inputs.contacts.size(); ++i) {
        const RodContact& contact = inputs.contacts[i];
        const RodPoint& point = data.contact_points[i];
        const Vector3 centre = point_position(shape, point);
        const double gap = contact.normal.dot(centre - contact.point) - contact.radius;
        const double before = data.contact_lambda[i];
        double lambda = before - penalty * gap;
        const bool active = lambda > 0;
        if (hessian) {
            data.contact_active[i] = active;
        } else if (data.contact_active[i] != active) {
            ++data.active_changes;
        }
        lambda = active ? lambda : 0;
        data.contact_force[i] = lambda;
        data.penetration = -gap > data.penetration ? -gap : data.penetration;
        const double change = std::fabs(lambda - before) / penalty;
        data.multiplier_change = change > data.multiplier_change ? change : data.multiplier_change;
        data.energy += 0.5 * (lambda * lambda - before * before) / penalty;
        Vector3 force = -lambda * contact.normal;
        Matrix3 stiffness = Matrix3::Zero();
        if (active) stiffness = penalty * contact.normal * contact.normal.transpose();
        if (contact.friction > 0 && data.dt > 0 && data.contact_start_lambda[i] > 0) {
            Vector3 slid = centre - data.contact_start[i] - contact.surface_velocity * data.dt;
            slid -= contact.normal * contact.normal.dot(slid);
            const double size = slid.norm(), reach = contact.friction_speed * data.dt,
                         limit = contact.friction * data.contact_start_lambda[i];
            const double rate = limit / (size > reach ? size : reach);
            data.energy += size > reach ? limit * (size - 0.5 * reach) : 0.5 * rate * size * size;
            force += rate * slid;
            stiffness += rate * (Matrix3::Identity() - contact.normal * contact.normal.transpose());
            if (size > reach) stiffness -= (rate / (size * size)) * (slid * slid.transpose());
        } else if (!active) {
            continue;
        }
        data.reaction_squared += lambda * lambda;
        const auto base = static_cast<std::size_t>(point.joint) - 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const double w = point.node_weight[k];
            double* g = &data.gradient[4 * (base + k)];
            g[0] += w * force.x();
            g[1] += w * force.y();
            g[2] += w * force.z();
        }
        if (hessian) add_stiffness(data.matrix, point, stiffness);
    }
}

void add_constraints(const Rod::Tables& tables, const RodShape& shape, RodInputs& inputs, bool hessian,
                     RodScratch::Data& data) {
    data.active_changes = 0;
    data.constraint_residual = data.penetration = data.multiplier_change = data.reaction_squared = 0;
    add_tethers(shape, inputs, hessian, data);
    const double largest_position = add_grasps(tables, shape, inputs, hessian, data);
    add_contacts(tables, shape, inputs, hessian, data);
    data.gradient_noise = 4e-16 * (tables.grasp_penalty * largest_position);
    add_self_contacts(tables, shape, inputs, hessian, data);
}

// The diagonal blocks of both points carry twice the stiffness: (a - b)^2 <= 2 a^2 + 2 b^2 keeps the band and
// never overshoots.
void add_self_contacts(const Rod::Tables& tables, const RodShape& shape, RodInputs& inputs, bool hessian,
                       RodScratch::Data& data) {
    const double penalty = tables.self_penalty;
    for (std::size_t i = 0; i < inputs.self_contacts.size(); ++i) {
        const RodSelfContact& contact = inputs.self_contacts[i];
        const RodPoint points[2] = {data.self_points[2 * i], data.self_points[2 * i + 1]};
        const Vector3 apart = point_position(shape, points[0]) - point_position(shape, points[1]);
        const double gap = contact.normal.dot(apart) - contact.distance, before = data.self_lambda[i];
        double lambda = before - penalty * gap;
        lambda = lambda > 0 ? lambda : 0;
        data.self_force[i] = lambda;
        data.energy += 0.5 * (lambda * lambda - before * before) / penalty;
        if (lambda <= 0) continue;
        data.reaction_squared += 2 * lambda * lambda;
        for (int side = 0; side < 2; ++side) {
            const RodPoint& point = points[side];
            const auto base = static_cast<std::size_t>(point.joint) - 1;
            const Vector3 force = contact.normal * (side == 0 ? -lambda : lambda);
            for (std::size_t k = 0; k < 3; ++k) {
                for (int c = 0; c < 3; ++c) {
                    data.gradient[4 * (base + k) + static_cast<std::size_t>(c)] +=
                        point.node_weight[k] * force[c];
                }
            }
            if (!hessian) continue;
            add_stiffness(data.matrix, point, 2 * penalty * contact.normal * contact.normal.transpose());
        }
    }
}

void linear_reactions(const Rod::Tables& tables, const RodShape& shape, const RodInputs& inputs,
                      RodScratch::Data& data) {
    RodJacobian jacobian;
    for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
        const RodGrasp& grasp = inputs.grasps[i];
        const RodPoint& point = data.grasp_points[i];
        const auto base = static_cast<std::size_t>(point.joint) - 1;
        wall_jacobian(shape, point, grasp.offset, jacobian);
        const Vector3 left = wall_position(shape, point, grasp.offset) - data.grasp_target[i] +
                             moved(jacobian, base, data.step);
        double energy = 0;
        data.grasp_force[i] = grasp.rigid() ? Vector3(data.grasp_lambda[i] + tables.grasp_penalty * left)
                                            : spring_force(grasp, left, nullptr, energy);
        if (!grasp.hold_rotation) continue;
        Vector3 away = held_turn(shape, turning_point(point), data.turn_target[i], jacobian);
        away += moved(jacobian, base, data.step);
        data.turn_force[i] = data.turn_lambda[i] + tables.turn_penalty * away;
    }
    const auto pressed = [](double lambda, double penalty, double gap, double change) {
        // Only contacts that were in the system have a force from it.
        const double after = lambda - penalty * (gap + change);
        return lambda - penalty * gap > 0 && after > 0 ? after : 0.0;
    };
    for (std::size_t i = 0; i < inputs.contacts.size(); ++i) {
        const RodContact& contact = inputs.contacts[i];
        const RodPoint& point = data.contact_points[i];
        const double gap = contact.normal.dot(point_position(shape, point) - contact.point) - contact.radius;
        data.contact_force[i] = pressed(data.contact_lambda[i], tables.contact_penalty, gap,
                                        approach(point, contact.normal, data.step));
    }
    for (std::size_t i = 0; i < inputs.self_contacts.size(); ++i) {
        const RodSelfContact& contact = inputs.self_contacts[i];
        const RodPoint &one = data.self_points[2 * i], &other = data.self_points[2 * i + 1];
        const Vector3 apart = point_position(shape, one) - point_position(shape, other);
        data.self_force[i] =
            pressed(data.self_lambda[i], tables.self_penalty, contact.normal.dot(apart) - contact.distance,
                    approach(one, contact.normal, data.step) - approach(other, contact.normal, data.step));
    }
}

void update_multipliers(const RodInputs& inputs, bool grasps, bool contacts, RodScratch::Data& data) {
    if (grasps) {
        for (std::size_t i = 0; i < inputs.grasps.size(); ++i) {
            data.grasp_lambda[i] = data.grasp_force[i];
            data.turn_lambda[i] = data.turn_force[i];
        }
    }
    if (!contacts) return;
    for (std::size_t i = 0; i < inputs.contacts.size(); ++i) data.contact_lambda[i] = data.contact_force[i];
    for (std::size_t i = 0; i < inputs.self_contacts.size(); ++i) data.self_lambda[i] = data.self_force[i];
}

}  // namespace fulcrum
