// SPDX-License-Identifier: Apache-2.0
// The incremental potential, its matrix, and the minimiser of a frame (quasi-Newton).
#include <algorithm>
#include <array>
#include <cmath>

#include "sim_core/membrane/membrane_system.h"

namespace fulcrum::membrane_detail {
namespace {

// Fraction of the bound that the matrix of a static solve uses: springs without a force across them resist
// less than the bound, and with all of it a gap of 1 % takes 10 iterations instead of 8 (measured on held
// sheets). The line search handles the rest. A frame uses the full bound: few iterations then stay on the
// safe side of the step's end and create no energy there.
constexpr double static_share = 2.0 / 3;

}  // namespace

void load_step(const Membrane& membrane, const MembraneState& state, const MembraneInputs& inputs, double dt,
               Data& d) {
    const Membrane::Tables& t = membrane.tables();
    const MembraneMaterial& material = membrane.material();
    d.dt = dt;
    const double mass_factor = dt > 0 ? (1 + material.mass_damping * dt) : 0;
    const Lanes gravity = lanes_of(inputs.gravity);
    for (std::int32_t k = 0; k < t.nodes; ++k) {
        const std::size_t n = at(k), v = at(t.vertex_of[n]);
        d.start[n] = lanes_of(state.positions[v]);
        d.start_velocity[n] = lanes_of(state.velocities[v]);
        d.load[n] = all_lanes(t.mass[n]) * gravity;
        if (!inputs.forces.empty()) d.load[n] += lanes_of(inputs.forces[v]);
        d.inertia[n] = dt > 0 && k < t.free ? t.mass[n] * mass_factor / (dt * dt) : 0;
        d.target[n] = d.start[n];
        if (d.inertia[n] > 0) d.target[n] += all_lanes(dt / mass_factor) * d.start_velocity[n];
        d.position[n] = d.start[n];
    }
    if (!inputs.attachments.empty()) {
        for (std::size_t a = 0; a < membrane.attached().size(); ++a)
            d.position[at(t.node_of[at(membrane.attached()[a])])] = lanes_of(inputs.attachments[a]);
    }
    // Spring and inertia of a held node form one parabola about a point between the two; they differ by a
    // constant, which the potential omits.
    d.held_count = 0;
    for (const MembraneHold& hold : inputs.holds) {
        const std::int32_t node = t.node_of[at(hold.vertex)];
        if (node >= t.free || hold.stiffness <= 0) continue;
        const double sum = d.inertia[at(node)] + hold.stiffness;
        d.target[at(node)] = all_lanes(d.inertia[at(node)] / sum) * d.target[at(node)] +
                             all_lanes(hold.stiffness / sum) * lanes_of(hold.target);
        d.inertia[at(node)] = sum;
        int k = 0;
        while (k < d.held_count && d.held[at(k)].node != node) ++k;
        if (k == d.held_count) d.held[at(d.held_count++)] = {node, 0.0};
        d.held[at(k)].stiffness += hold.stiffness;
    }
    // In implicit Euler, stiffness-proportional damping is one more spring to the length at the start of the
    // step: 1/2 k (l - r)^2 + (k b / 2h) (l - l_0)^2 has the form of one spring again.
    const double damping = dt > 0 ? material.stiffness_damping / dt : 0;
    for (std::size_t s = 0; s < t.first.size(); ++s) {
        const std::int32_t number = t.spring_of[s];
        const bool gone = number < 0 || state.cut[at(number)] != 0;
        d.stiffness[s] = gone ? 0.0 : t.stiffness[s] * (1 + damping);
        d.rest[s] = t.rest[s];
        if (damping > 0) {
            const Lanes difference = d.start[at(t.first[s])] - d.start[at(t.second[s])];
            d.rest[s] = (t.rest[s] + damping * std::sqrt(sum_lanes(difference * difference))) / (1 + damping);
        }
    }
}

double potential(const Membrane::Tables& t, const Data& d, const Lanes* x, Lanes* gradient) {
    Lanes energy = all_lanes(0);
    for (std::int32_t k = 0; k < t.nodes; ++k) {
        const std::size_t n = at(k);
        const Lanes off = x[n] - d.target[n];
        gradient[n] = all_lanes(d.inertia[n]) * off;
        energy += all_lanes(0.5) * gradient[n] * off;
        if (k >= t.free) continue;
        energy -= d.load[n] * off;
        gradient[n] -= d.load[n];
    }
    return sum_lanes(energy) + add_springs(t, d.stiffness.data(), d.rest.data(), x, gradient);
}

double scaled_residual(const Membrane::Tables& t, const Data& d, const Lanes* x, const Lanes* gradient) {
    double imbalance = 0, external = 0, inertial = 0, internal = 0;
    for (std::int32_t k = 0; k < t.free; ++k) {
        const std::size_t n = at(k);
        const Lanes inertia = all_lanes(d.inertia[n]) * (x[n] - d.target[n]);
        const Lanes carried = all_lanes(d.inertia[n]) * (d.start[n] - d.target[n]);
        const Lanes spring = gradient[n] - inertia + d.load[n];
        imbalance += sum_lanes(gradient[n] * gradient[n]);
        external += sum_lanes(d.load[n] * d.load[n]);
        inertial += sum_lanes(carried * carried);
        internal += sum_lanes(spring * spring);
    }
    // Attached nodes: include the spring forces on them.
    for (std::int32_t k = t.free; k < t.nodes; ++k) internal += sum_lanes(gradient[at(k)] * gradient[at(k)]);
    // Forces at a strain of 1e-4: below 1e-10 of that is rounding of the positions.
    double slight = 0;
    for (std::size_t s = 0; s < d.rest.size(); ++s) {
        const double force = 1e-4 * d.stiffness[s] * d.rest[s];
        slight += force * force;
    }
    const double scale = std::sqrt(std::max(std::max(external, slight), std::max(inertial, internal)));
    return std::sqrt(imbalance) / std::max(scale, 1e-30);
}

namespace {

// Grasps and releases since the matrix was built change one diagonal entry each. False: not positive
// definite.
bool follow_holds(Data& d) {
    const auto begin = d.held.begin(), end = begin + d.held_count;
    const auto old_begin = d.built_held.begin(), old_end = old_begin + d.built_held_count;
    if (std::equal(begin, end, old_begin, old_end)) return true;
    bool good = true;
    for (auto held = begin; held != end; ++held) {
        if (std::find(old_begin, old_end, *held) == old_end) {
            good = good && d.multigrid.update(held->node, -1, held->stiffness);
            ++d.updates;
        }
    }
    for (auto held = old_begin; held != old_end; ++held) {
        if (std::find(begin, end, *held) == end) {
            good = good && d.multigrid.update(held->node, -1, -held->stiffness);
            ++d.updates;
        }
    }
    d.built_held = d.held;
    d.built_held_count = d.held_count;
    return good;
}

}  // namespace

void apply_inverse(const Membrane::Tables& t, Data& d, Lanes* x) {
    const auto free = at(t.free);
    if (t.free < t.nodes) {
        d.multigrid.solve(x);
        return;
    }
    // Nothing attached: a motion of the whole is resisted by inertia (and holds) only. It is removed before
    // and corrected after, so that both together stay symmetric.
    Lanes pull = all_lanes(0), moved = all_lanes(0);
    double inertia = 0;
    for (std::size_t i = 0; i < free; ++i) {
        pull += x[i];
        inertia += d.inertia[i];
    }
    const Lanes whole = all_lanes(1 / inertia) * pull;
    for (std::size_t i = 0; i < free; ++i) x[i] -= all_lanes(d.inertia[i]) * whole;
    d.multigrid.solve(x);
    for (std::size_t i = 0; i < free; ++i) moved += all_lanes(d.inertia[i]) * x[i];
    const Lanes back = whole - all_lanes(1 / inertia) * moved;
    for (std::size_t i = 0; i < free; ++i) x[i] += back;
}

bool refresh_matrix(const Membrane& membrane, const MembraneState& state, double dt, Data& d) {
    const Membrane::Tables& t = membrane.tables();
    const MembraneMaterial& material = membrane.material();
    const double damped = dt > 0 ? 1 + material.stiffness_damping / dt : static_share;
    const bool other_step = d.built_dt != dt;
    bool whole = other_step || !follow_holds(d);
    if (!whole && d.built_topology == state.topology && !d.cuts_behind) return true;
    int budget = Membrane::updates_per_step;
    // After so many changed edges the aggregates are rebuilt: the cost of a few cycles, rarely.
    whole = whole || d.updates_since > t.free;
    if (!whole) {
        // Fewer springs than before: apply each change of an edge to the matrix. What does not fit into this
        // step stays in. A spring that came back has to be added at once.
        d.cuts_behind = false;
        for (std::size_t s = 0; s < state.cut.size() && !whole; ++s) {
            if (state.cut[s] == d.built_cut[s]) continue;
            if (state.cut[s] == 0) {
                whole = true;
                break;
            }
            const std::int32_t begin = t.share_offsets[s], end = t.share_offsets[s + 1];
            if (end - begin > budget) {
                d.cuts_behind = true;
                break;
            }
            for (std::int32_t k = begin; k < end && !whole; ++k) {
                const auto& share = t.shares[at(k)];
                const GraphEdge& edge = t.edges[at(share.edge)];
                d.edge_weight[at(share.edge)] -= share.weight;
                const bool inner = t.inner_edge[at(share.edge)] >= 0;
                if (edge[0] >= t.free) continue;
                whole = !d.multigrid.update(edge[0], inner ? edge[1] : -1, -damped * share.weight);
                ++d.updates;
                ++d.updates_since;
                --budget;
            }
            d.built_cut[s] = 1;
        }
        d.built_topology = state.topology;
    }
    if (!whole) return true;
    std::fill(d.edge_weight.begin(), d.edge_weight.end(), 0.0);
    for (std::size_t s = 0; s < state.cut.size(); ++s) {
        d.built_cut[s] = state.cut[s];
        if (state.cut[s] != 0) continue;
        for (std::int32_t k = t.share_offsets[s]; k < t.share_offsets[s + 1]; ++k)
            d.edge_weight[at(t.shares[at(k)].edge)] += t.shares[at(k)].weight;
    }
    double largest = 0;
    for (std::int32_t k = 0; k < t.free; ++k) {
        d.diagonal[at(k)] = dt > 0 ? t.mass[at(k)] * (1 + material.mass_damping * dt) / (dt * dt) : 0;
    }
    for (int k = 0; k < d.held_count; ++k) d.diagonal[at(d.held[at(k)].node)] += d.held[at(k)].stiffness;
    d.built_held = d.held;
    d.built_held_count = d.held_count;
    for (std::size_t e = 0; e < t.edges.size(); ++e) {
        const double weight = damped * d.edge_weight[e];
        largest = std::max(largest, weight);
        const std::int32_t inner = t.inner_edge[e];
        if (inner >= 0) {
            d.inner_weight[at(inner)] = weight;
        } else if (t.edges[e][0] < t.free) {
            d.diagonal[at(t.edges[e][0])] += weight;
        }
    }
    // Statics: a part without any attachment would make the matrix singular; this small term holds it.
    for (std::int32_t k = 0; k < t.free; ++k) d.diagonal[at(k)] += 1e-9 * largest;
    ++d.builds;
    d.updates_since = 0;
    const bool good = d.multigrid.build(d.diagonal.data(), d.inner_weight.data());
    d.built_dt = good ? dt : -1;
    d.built_topology = state.topology;
    d.cuts_behind = false;
    return good;
}

namespace {

using History = std::array<const double*, Data::memory>;  ///< newest first
constexpr Lanes three = {1, 1, 1,
                         0};  // a node's numbers in the packed history, followed by those of the next node

// The whole memory is read at once, where the standard two-loop form goes through it a pair at a time: at
// 50,000 nodes it exceeds the caches, and those loops took longer than a cycle.

/// products[k] = history[k] . x
template <int pairs>
void dots_of(const History& history, const Lanes* x, std::size_t count, double* products) {
    Lanes sum[pairs];
    for (Lanes& s : sum) s = all_lanes(0);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < pairs; ++k) sum[k] += load_lanes(history[k] + 3 * i) * x[i];
    }
    for (int k = 0; k < pairs; ++k) products[k] = sum_lanes(sum[k] * three);
}

/// x + sum of shares[k] history[k], written to y, or subtracted if there is a destination for that; returns
/// its product with z.
template <int pairs>
double combine_of(const History& history, const double* shares, const Lanes* x, const Lanes* z,
                  const Lanes* place, Lanes* y, std::size_t count) {
    Lanes share[pairs + 1], product = all_lanes(0);
    for (int k = 0; k < pairs; ++k) share[k] = all_lanes(shares[k]) * three;
    for (std::size_t i = 0; i < count; ++i) {
        Lanes sum = x[i];
        for (std::size_t k = 0; k < pairs; ++k) sum += share[k] * load_lanes(history[k] + 3 * i);
        product += sum * z[i];
        y[i] = place != nullptr ? place[i] - sum : sum;
    }
    return sum_lanes(product);
}

void dots(int pairs, const History& history, const Lanes* x, std::size_t count, double* products) {
    if (pairs == 1) dots_of<1>(history, x, count, products);
    if (pairs == 2) dots_of<2>(history, x, count, products);
}

double combine(int pairs, const History& history, const double* shares, const Lanes* x, const Lanes* z,
               const Lanes* place, Lanes* y, std::size_t count) {
    static_assert(Data::memory == 2, "one case for each number of pairs");
    if (pairs == 0) return combine_of<0>(history, shares, x, z, place, y, count);
    return pairs == 1 ? combine_of<1>(history, shares, x, z, place, y, count)
                      : combine_of<2>(history, shares, x, z, place, y, count);
}

inline void pack(const Lanes& value, double* to) {
    to[0] = value[0];
    to[1] = value[1];
    to[2] = value[2];
}

// Halves the step from d.trial towards d.position until the potential decreases enough; false after 12
// attempts. length: fraction of the step; next: potential there.
bool search(const Membrane::Tables& t, Data& d, double value, double slope, double& length, double& next) {
    const auto count = at(t.free);
    for (std::size_t i = count; i < at(t.nodes); ++i) d.trial[i] = d.position[i];
    for (int halving = 0; halving < 12; ++halving, length *= 0.5) {
        for (std::size_t i = 0; halving > 0 && i < count; ++i)
            d.trial[i] = all_lanes(0.5) * (d.trial[i] + d.position[i]);
        next = potential(t, d, d.trial.data(), d.trial_gradient.data());
        if (next <= value + 1e-4 * length * slope + 1e-15 * std::abs(value)) return true;
    }
    return false;
}

// Writes the step and the change of the gradient into a slot of the memory. product: of the two; squared: of
// the change.
void pack_pair(Data& d, std::size_t slot, std::size_t count, double& product, double& squared) {
    double *step = d.moved[slot].data(), *change = d.turned[slot].data();
    Lanes across = all_lanes(0), square = all_lanes(0);
    for (std::size_t i = 0; i < count; ++i) {
        const Lanes moved_by = d.trial[i] - d.position[i], turned_by = d.trial_gradient[i] - d.gradient[i];
        across += moved_by * turned_by;
        square += turned_by * turned_by;
        pack(moved_by, step + 3 * i);
        pack(turned_by, change + 3 * i);
    }
    product = sum_lanes(across);
    squared = sum_lanes(square);
}

// The remembered pairs, newest first.
struct Pairs {
    int count = 0;
    std::size_t slot[Data::memory];
    History moved, turned;

    explicit Pairs(const Data& d) : count(d.remembered) {
        for (int k = 0; k < count; ++k) {
            const auto i = static_cast<std::size_t>(k);
            slot[k] = static_cast<std::size_t>((d.newest - k + Data::memory) % Data::memory);
            moved[i] = d.moved[slot[k]].data();
            turned[i] = d.turned[slot[k]].data();
        }
    }
};

// Replaces the oldest pair by the step to d.trial and its change of the gradient; false, and one pair less,
// if their product is not positive. products: the direction times the pairs' changes; share: of the pairs'
// steps in the direction; length: fraction of the direction that was moved.
bool remember_step(Data& d, const Pairs& pairs, const double* products, const double* share, double length,
                   std::size_t count) {
    const auto slot = static_cast<std::size_t>((d.newest + 1) % Data::memory);
    double product = 0, squared = 0;
    pack_pair(d, slot, count, product, squared);
    // The oldest pair's slot was overwritten: without a new pair in it, it is dropped.
    d.remembered = std::min(d.remembered, Data::memory - 1);
    if (!(product > 1e-21 * squared && product > 0)) return false;
    for (int k = 0; k < pairs.count; ++k) {
        double sum = products[k];  // direction . turned[k]
        for (int j = 0; j < pairs.count; ++j) sum += share[j] * d.products[pairs.slot[j]][pairs.slot[k]];
        d.products[slot][pairs.slot[k]] = -length * sum;
    }
    d.products[slot][slot] = product;
    d.newest = static_cast<int>(slot);
    ++d.remembered;
    return true;
}

}  // namespace

void minimise_quasi_newton(const Membrane::Tables& t, Data& d, int iterations, double tolerance,
                           MembraneReport& report) {
    const auto count = at(t.free);
    d.remembered = 0;
    d.newest = -1;
    double along[Data::memory] = {};  // moved . gradient, by slot, of the previous iteration
    bool fresh = false;               // the newest pair's products with the gradients are not computed yet
    double value = potential(t, d, d.position.data(), d.gradient.data());
    report.converged = tolerance <= 0;
    for (report.iterations = 0; report.iterations < iterations; ++report.iterations) {
        if (tolerance > 0 &&
            (report.residual = scaled_residual(t, d, d.position.data(), d.gradient.data())) <= tolerance) {
            report.converged = true;
            break;
        }
        Lanes* p = d.direction.data();
        const Pairs pairs(d);
        const std::size_t* slot = pairs.slot;
        double products[Data::memory], share[Data::memory], minus[Data::memory];
        dots(pairs.count, pairs.moved, d.gradient.data(), count, products);
        for (int k = 0; k < pairs.count; ++k) {
            // An earlier step on the last change of the gradient: the difference of two known products.
            if (fresh && k > 0) d.products[slot[k]][slot[0]] = products[k] - along[slot[k]];
            along[slot[k]] = products[k];
            double sum = products[k];
            for (int j = 0; j < k; ++j) sum -= share[j] * d.products[slot[k]][slot[j]];
            share[k] = sum / d.products[slot[k]][slot[k]];
            minus[k] = -share[k];
        }
        fresh = false;
        combine(pairs.count, pairs.turned, minus, d.gradient.data(), d.gradient.data(), nullptr, p, count);
        apply_inverse(t, d, p);
        dots(pairs.count, pairs.turned, p, count, products);
        for (int k = pairs.count - 1; k >= 0; --k) {
            double sum = products[k];
            for (int j = k + 1; j < pairs.count; ++j) sum += share[j] * d.products[slot[j]][slot[k]];
            share[k] -= sum / d.products[slot[k]][slot[k]];
        }
        const double slope = -combine(pairs.count, pairs.moved, share, p, d.gradient.data(),
                                      d.position.data(), d.trial.data(), count);
        if (!(slope < 0)) {
            if (!std::isfinite(slope)) break;
            if (d.remembered == 0) break;  // at the minimum to working accuracy
            d.remembered = 0;
            continue;
        }
        double length = 1, next = 0;
        const bool lower = search(t, d, value, slope, length, next);
        if (!lower) {
            if (d.remembered == 0) break;  // only rounding remains
            d.remembered = 0;
            continue;
        }
        fresh = remember_step(d, pairs, products, share, length, count);
        d.position.swap(d.trial);
        d.gradient.swap(d.trial_gradient);
        value = next;
    }
    report.potential = value;
    report.residual = scaled_residual(t, d, d.position.data(), d.gradient.data());
    if (tolerance > 0) report.converged = report.residual <= tolerance;
}

}  // namespace fulcrum::membrane_detail
