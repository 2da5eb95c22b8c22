// SPDX-License-Identifier: Apache-2.0
#include "sim_core/rod/rod_system.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double two_pi = 6.283185307179586;

struct Small {  // three doubles without the temporaries of the vector library, for the inner loops
    double x, y, z;
};
inline Small operator+(const Small& a, const Small& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Small operator-(const Small& a, const Small& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Small operator*(const Small& a, double s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline double dot(const Small& a, const Small& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Small cross(const Small& a, const Small& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Small tangent(const RodShape& shape, std::size_t i) {
    return {shape.tx[i], shape.ty[i], shape.tz[i]};
}
inline Small director(const RodShape& shape, std::size_t i) {
    return {shape.dx[i], shape.dy[i], shape.dz[i]};
}

/// Angle from the director of segment entry i, transported to entry i + 1, to the director there; the
/// multiple of 2 pi nearest to `expected`.
double joint_angle(const RodShape& shape, std::size_t i, double expected) {
    const Small s = tangent(shape, i), t = tangent(shape, i + 1), a = director(shape, i),
                b = director(shape, i + 1);
    const double chi = 1.0 + dot(s, t);
    const Small carried = a - (s + t) * (dot(t, a) / chi);
    const double angle = math::atan2(dot(cross(carried, b), t), dot(carried, b));
    return angle + two_pi * std::floor((expected - angle) / two_pi + 0.5);
}

void edges(const RodShape& shape, int segments, RodShape& out, bool& good) {
    const double* p = shape.position.data();
    const std::size_t n = static_cast<std::size_t>(segments);
    double smallest = 1e300;
    for (std::size_t j = 0; j < n; ++j) {
        const double x = p[4 * j + 4] - p[4 * j], y = p[4 * j + 5] - p[4 * j + 1],
                     z = p[4 * j + 6] - p[4 * j + 2];
        const double squared = x * x + y * y + z * z;
        const double length = std::sqrt(squared), inverse = 1.0 / length;
        smallest = length < smallest ? length : smallest;
        out.tx[j + 1] = x * inverse;
        out.ty[j + 1] = y * inverse;
        out.tz[j + 1] = z * inverse;
        out.length[j + 1] = length;
        out.inverse[j + 1] = inverse;
    }
    good = smallest > 1e-12;
}

}  // namespace

void shape_from_state(const Rod::Tables& tables, const RodSpec& spec, const RodState& state,
                      const RodFrame ends[2], RodShape& shape) {
    const std::size_t n = static_cast<std::size_t>(tables.segments);
    for (std::size_t i = 0; i <= n; ++i) {
        for (int k = 0; k < 3; ++k) shape.position[4 * i + static_cast<std::size_t>(k)] = state.nodes[i][k];
        shape.position[4 * i + 3] = 0;
    }
    bool good;
    edges(shape, tables.segments, shape, good);
    for (std::size_t j = 0; j < n; ++j) {
        shape.dx[j + 1] = state.directors[j].x();
        shape.dy[j + 1] = state.directors[j].y();
        shape.dz[j + 1] = state.directors[j].z();
    }
    for (std::size_t e = 0; e < 2; ++e) {
        const std::size_t at = e == 0 ? 0 : n + 1, neighbour = e == 0 ? 1 : n;
        const bool turned = spec.ends[e] == RodEnd::clamped || spec.ends[e] == RodEnd::held;
        const Vector3 t = turned ? Vector3(ends[e].rotation.col(2))
                                 : Vector3(shape.tx[neighbour], shape.ty[neighbour], shape.tz[neighbour]);
        const Vector3 d = turned ? Vector3(ends[e].rotation.col(0))
                                 : Vector3(shape.dx[neighbour], shape.dy[neighbour], shape.dz[neighbour]);
        shape.tx[at] = t.x();
        shape.ty[at] = t.y();
        shape.tz[at] = t.z();
        shape.dx[at] = d.x();
        shape.dy[at] = d.y();
        shape.dz[at] = d.z();
        shape.inverse[at] = 0;
        shape.length[at] = 1;
    }
    for (std::size_t i = 0; i <= n; ++i) shape.twist[i] = state.joint_twist[i];
    // End frames may have turned since then: the twist against them follows, by less than a turn.
    for (const std::size_t i : {std::size_t{0}, n}) {
        if (tables.twist[i] > 0) shape.twist[i] = joint_angle(shape, i, state.joint_twist[i]);
    }
}

void state_from_shape(const RodShape& shape, RodState& state) {
    const std::size_t n = state.directors.size();
    for (std::size_t i = 0; i <= n; ++i) {
        state.nodes[i] = Vector3(shape.position[4 * i], shape.position[4 * i + 1], shape.position[4 * i + 2]);
        state.joint_twist[i] = shape.twist[i];
    }
    for (std::size_t j = 0; j < n; ++j)
        state.directors[j] = Vector3(shape.dx[j + 1], shape.dy[j + 1], shape.dz[j + 1]);
}

namespace {

// Node positions accumulated from one end along segments that the step turns and stretches as rigid bodies.
void turn_segments(const RodShape& base, std::size_t n, const double* step, double factor, int anchor,
                   RodShape& out) {
    const std::size_t start = anchor == 0 ? 0 : n;
    store_lanes(&out.position[4 * start],
                load_lanes(&base.position[4 * start]) + load_lanes(&step[4 * start]) * factor);
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t j = anchor == 0 ? k : n - 1 - k;
        const double *a = step + 4 * j, *b = step + 4 * j + 4;
        const Small change = Small{b[0] - a[0], b[1] - a[1], b[2] - a[2]} * factor, t = tangent(base, j + 1);
        const double along = dot(change, t), length = base.length[j + 1];
        const Small turn = (change - t * along) * base.inverse[j + 1];
        const double angle = std::sqrt(dot(turn, turn));
        Small to = t;
        if (angle > 1e-12) {
            double sine, cosine;
            math::sin_cos(angle, sine, cosine);
            to = t * cosine + turn * (sine / angle);
        }
        const double stretched = length + along > 0.25 * length ? length + along : 0.25 * length;
        const Small edge = to * (anchor == 0 ? stretched : -stretched);
        const double* from = &out.position[4 * (anchor == 0 ? j : j + 1)];
        const Lanes next{from[0] + edge.x, from[1] + edge.y, from[2] + edge.z, 0};
        store_lanes(&out.position[4 * (anchor == 0 ? j + 1 : j)], next);
    }
    for (std::size_t i = 0; i <= n; ++i) {
        out.position[4 * i + 3] = base.position[4 * i + 3] + step[4 * i + 3] * factor;
    }
}

}  // namespace

bool retract(const Rod::Tables& tables, const RodShape& base, const double* step, double factor,
             RodShape& out, int anchor) {
    const std::size_t n = static_cast<std::size_t>(tables.segments);
    if (anchor >= 0) {
        turn_segments(base, n, step, factor, anchor, out);
    } else {
        for (std::size_t i = 0; i < 4 * (n + 1); i += 4) {
            store_lanes(&out.position[i], load_lanes(&base.position[i]) + load_lanes(&step[i]) * factor);
        }
    }
    bool good;
    edges(out, tables.segments, out, good);
    if (!good) return false;
    for (const std::size_t e : {std::size_t{0}, n + 1}) {
        const bool held = tables.twist[e == 0 ? 0 : n] > 0;
        const std::size_t from = held ? e : (e == 0 ? 1 : n);
        const RodShape& source = held ? base : out;
        out.tx[e] = source.tx[from];
        out.ty[e] = source.ty[from];
        out.tz[e] = source.tz[from];
        out.dx[e] = base.dx[e];
        out.dy[e] = base.dy[e];
        out.dz[e] = base.dz[e];
        out.inverse[e] = 0;
        out.length[e] = 1;
    }
    double smallest = 2;
    for (std::size_t j = 1; j <= n; ++j) {
        const Small from = tangent(base, j), to = tangent(out, j), d = director(base, j);
        const double chi = 1.0 + dot(from, to);
        smallest = chi < smallest ? chi : smallest;
        Small carried = d - (from + to) * (dot(d, to) / chi);
        const double angle = factor * step[4 * (j - 1) + 3];
        if (angle != 0) {
            double sine, cosine;
            math::sin_cos(angle, sine, cosine);
            carried = carried * cosine + cross(to, carried) * sine;
        }
        // Prevents rounding errors from accumulating over thousands of frames.
        carried = carried - to * dot(carried, to);
        carried = carried * (1.0 / std::sqrt(dot(carried, carried)));
        out.dx[j] = carried.x;
        out.dy[j] = carried.y;
        out.dz[j] = carried.z;
    }
    if (!(smallest > 1e-6)) return false;
    for (std::size_t i = 0; i <= n; ++i) {
        if (tables.twist[i] <= 0) continue;
        const double before = i > 0 ? step[4 * (i - 1) + 3] : 0, after = i < n ? step[4 * i + 3] : 0;
        out.twist[i] = joint_angle(out, i, base.twist[i] + factor * (after - before));
    }
    return true;
}

double stretch_energy(const Rod::Tables& tables, const RodShape& shape) {
    double energy = 0;
    for (std::size_t j = 0; j < static_cast<std::size_t>(tables.segments); ++j) {
        const double extension = shape.length[j + 1] - tables.rest_length[j];
        energy += 0.5 * tables.stretch[j] * extension * extension;
    }
    return energy;
}

namespace {

constexpr Lanes plus_vector{1, 1, 1, 0}, difference{-1, -1, -1, 1};

bool elastic_terms(const Rod::Tables& tables, const RodShape& shape, bool hessian, RodScratch::Data& data) {
    return tables.section ? section_terms(tables, shape, hessian, data.section, data.joints)
                          : joint_terms(tables, shape, hessian, data.joints);
}

// Edge blocks to node blocks: z_j = A y_(j+1) + C y_j with A = diag(1, 1, 1, 0), C = diag(-1, -1, -1, 1).
void assemble(const Rod::Tables& tables, const RodShape& shape, const RodJointTerms& joints,
              const RodSectionTerms& section, BlockBand& matrix) {
    const std::size_t n = static_cast<std::size_t>(tables.segments);
    Block4 previous{};  // edge block of segment i - 1
    for (int k = 0; k < 4; ++k) previous.column[k] = all_lanes(0);
    Block4 previous_cross = previous, previous_transposed = previous;  // joint i
    for (std::size_t i = 0; i <= n; ++i) {
        Block4 edge, cross_now, transposed;
        for (int k = 0; k < 4; ++k)
            edge.column[k] = cross_now.column[k] = transposed.column[k] = all_lanes(0);
        if (i < n) {
            const Lanes t{shape.tx[i + 1], shape.ty[i + 1], shape.tz[i + 1], 0};
            double stiffness = tables.stretch[i];
            double side = stiffness * (1.0 - tables.rest_length[i] * shape.inverse[i + 1]);
            if (tables.section) {
                stiffness = section.tangent[i];
                side = section.force[i] * shape.inverse[i + 1];
            }
            for (int k = 0; k < 4; ++k) {
                edge.column[k] =
                    joints.bb[i].column[k] + joints.aa[i + 1].column[k] + t * (t[k] * (stiffness - side));
            }
            edge.column[0][0] += side;
            edge.column[1][1] += side;
            edge.column[2][2] += side;
            if (i + 1 < n) {
                cross_now = joints.ab[i + 1];
                transposed = cross_now;
                transpose_lanes(transposed.column[0], transposed.column[1], transposed.column[2],
                                transposed.column[3]);
            }
        }
        Block4 &d = matrix.diagonal[i], &f = matrix.first[i], &s = matrix.second[i];
        for (int k = 0; k < 4; ++k) {
            const double c = k < 3 ? -1.0 : 1.0, a = k < 3 ? 1.0 : 0.0;
            d.column[k] = difference * edge.column[k] * c + plus_vector * previous.column[k] * a +
                          plus_vector * previous_cross.column[k] * c +
                          difference * previous_transposed.column[k] * a;
            f.column[k] = plus_vector * edge.column[k] * c + difference * transposed.column[k] * c +
                          plus_vector * previous_transposed.column[k] * a;
            s.column[k] = plus_vector * transposed.column[k] * c;
        }
        previous = edge;
        previous_cross = cross_now;
        previous_transposed = transposed;
    }
    matrix.diagonal[n].column[3][3] = 1.0;  // no segment behind the last node
}

}  // namespace

void add_damping(const Rod::Tables& tables, const RodSpec& spec, double dt, RodScratch::Data& data) {
    elastic_terms(tables, data.shape, true, data);
    assemble(tables, data.shape, data.joints, data.section, data.damping);
    const double rate = spec.stiffness_damping / dt;
    for (std::size_t i = 0; i < data.damping.blocks(); ++i) {
        for (int k = 0; k < 4; ++k) {
            data.damping.diagonal[i].column[k] *= rate;
            data.damping.first[i].column[k] *= rate;
            data.damping.second[i].column[k] *= rate;
        }
    }
    data.damping.diagonal.back().column[3] = all_lanes(0);
}

bool evaluate(const Rod::Tables& tables, const RodShape& shape, RodInputs& inputs, bool hessian,
              RodScratch::Data& data) {
    const std::size_t n = static_cast<std::size_t>(tables.segments);
    data.joint_evaluations += n + 1;
    if (!elastic_terms(tables, shape, hessian, data)) return false;
    if (hessian) assemble(tables, shape, data.joints, data.section, data.matrix);
    Lanes previous = all_lanes(0), energy = all_lanes(0), noise = all_lanes(0);
    double stretch = 0;
    for (std::size_t i = 0; i <= n; ++i) {
        Lanes edge = all_lanes(0);
        if (i < n) {
            const double extension = shape.length[i + 1] - tables.rest_length[i];
            double force = tables.stretch[i] * extension;
            if (tables.section) {
                force = data.section.force[i];
            } else {
                stretch += 0.5 * force * extension;
            }
            edge = load_lanes(&data.joints.gradient_b[4 * i]) +
                   load_lanes(&data.joints.gradient_a[4 * (i + 1)]) +
                   Lanes{shape.tx[i + 1], shape.ty[i + 1], shape.tz[i + 1], 0} * force;
        }
        const Lanes y = load_lanes(&shape.position[4 * i]), weight = load_lanes(&data.inertia[4 * i]);
        const Lanes away = y - load_lanes(&data.predicted[4 * i]), pull = weight * away,
                    dead = load_lanes(&data.dead[4 * i]);
        energy += 0.5 * pull * away - dead * y;
        noise += weight * (y * y) + dead * dead;
        store_lanes(&data.gradient[4 * i], difference * edge + plus_vector * previous + pull - dead);
        if (hessian) {
            for (int k = 0; k < 4; ++k) data.matrix.diagonal[i].column[k][k] += weight[k];
        }
        previous = edge;
    }
    data.bend = data.joints.bend;
    data.twist = data.joints.twist;
    if (tables.section) stretch = data.section.stretch;
    data.stretch = stretch;
    data.energy = data.bend + data.twist + stretch + sum_lanes(energy);
    if (data.damping.blocks() != 0 && data.dt > 0) {
        for (std::size_t i = 0; i < 4 * (n + 1); ++i)
            data.column[i] = shape.position[i] - data.start.position[i];
        multiply(data.damping, data.column.data(), data.damping_force.data());
        for (std::size_t i = 0; i < 4 * (n + 1); ++i) {
            data.gradient[i] += data.damping_force[i];
            data.energy += 0.5 * data.damping_force[i] * data.column[i];
        }
        if (hessian) {
            for (std::size_t i = 0; i <= n; ++i) {
                for (int k = 0; k < 4; ++k) {
                    data.matrix.diagonal[i].column[k] += data.damping.diagonal[i].column[k];
                    data.matrix.first[i].column[k] += data.damping.first[i].column[k];
                    data.matrix.second[i].column[k] += data.damping.second[i].column[k];
                }
            }
        }
    }
    data.energy_noise = 1e-14 * (std::fabs(data.energy) + data.bend + data.twist + stretch) +
                        1e-16 * sum_lanes(noise) + 1e-22;
    add_constraints(tables, shape, inputs, hessian, data);
    data.gradient[4 * n + 3] = 0;
    return std::isfinite(data.energy);
}

void reduce(const RodShape& shape, RodScratch::Data& data) {
    const std::size_t blocks = data.matrix.blocks(), n = blocks - 1;
    for (std::size_t i = 0; i < 4 * blocks; ++i) data.step[i] = -data.gradient[i];
    const auto increment = [&](std::size_t e, std::size_t node) {
        const double* p = &shape.position[4 * node];
        return Lanes{data.target[e].x() - p[0], data.target[e].y() - p[1], data.target[e].z() - p[2], 0};
    };
    const auto times = [](const Block4& b, const Lanes& v) {
        return b.column[0] * v[0] + b.column[1] * v[1] + b.column[2] * v[2];
    };
    if (data.fixed[0]) {
        const Lanes by = increment(0, 0);
        Block4 &d = data.matrix.diagonal[0], &f = data.matrix.first[0], &s = data.matrix.second[0];
        const double spin =
            data.step[3] - (d.column[0][3] * by[0] + d.column[1][3] * by[1] + d.column[2][3] * by[2]);
        store_lanes(&data.step[4], load_lanes(&data.step[4]) - times(f, by));
        store_lanes(&data.step[8], load_lanes(&data.step[8]) - times(s, by));
        store_lanes(&data.step[0], Lanes{by[0], by[1], by[2], spin});
        for (int k = 0; k < 3; ++k) {
            d.column[k] = f.column[k] = s.column[k] = all_lanes(0);
            d.column[k][k] = 1;
            d.column[3][k] = 0;
        }
    }
    if (data.fixed[1]) {
        const Lanes by = increment(1, n);
        Block4 &d = data.matrix.diagonal[n], &f = data.matrix.first[n - 1], &s = data.matrix.second[n - 2];
        Lanes one = load_lanes(&data.step[4 * (n - 1)]), two = load_lanes(&data.step[4 * (n - 2)]);
        for (int k = 0; k < 4; ++k) {
            one[k] -= f.column[k][0] * by[0] + f.column[k][1] * by[1] + f.column[k][2] * by[2];
            two[k] -= s.column[k][0] * by[0] + s.column[k][1] * by[1] + s.column[k][2] * by[2];
            f.column[k] *= Lanes{0, 0, 0, 1};
            s.column[k] *= Lanes{0, 0, 0, 1};
            d.column[k] = all_lanes(0);
            d.column[k][k] = 1;
        }
        store_lanes(&data.step[4 * (n - 1)], one);
        store_lanes(&data.step[4 * (n - 2)], two);
        store_lanes(&data.step[4 * n], by);
    }
    data.step[4 * n + 3] = 0;
}

double free_residual(const RodScratch::Data& data) {
    const std::size_t blocks = data.matrix.blocks();
    Lanes sum = all_lanes(0);
    for (std::size_t i = 0; i < blocks; ++i) {
        Lanes g = load_lanes(&data.gradient[4 * i]);
        if ((i == 0 && data.fixed[0]) || (i + 1 == blocks && data.fixed[1])) g *= Lanes{0, 0, 0, 1};
        sum += g * g;
    }
    return std::sqrt(sum_lanes(sum));
}

}  // namespace fulcrum
