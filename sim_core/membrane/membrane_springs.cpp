// SPDX-License-Identifier: Apache-2.0
// Spring energy, gradient, dampers and tangent, four springs at a time.
#include <algorithm>
#include <cmath>

#include "sim_core/membrane/membrane_system.h"

namespace fulcrum::membrane_detail {
namespace {

constexpr double shortest = 1e-12;  // m: below it a spring has no direction; its force vanishes with it

struct Four {
    Lanes difference[4];
    Lanes length;
};

inline Four lengths(const std::int32_t* first, const std::int32_t* second, const Lanes* x) {
    Four four;
    for (int q = 0; q < 4; ++q) four.difference[q] = x[first[q]] - x[second[q]];
    Lanes a = four.difference[0], b = four.difference[1], c = four.difference[2], d = four.difference[3];
    transpose_lanes(a, b, c, d);
    const Lanes squared = (a * a + b * b) + c * c;
    const Lanes least = all_lanes(shortest * shortest);
    four.length = sqrt_lanes(squared > least ? squared : least);
    return four;
}

}  // namespace

double dot(const Lanes* a, const Lanes* b, std::size_t count) {
    Lanes even = all_lanes(0), odd = all_lanes(0);
    std::size_t i = 0;
    for (; i + 1 < count; i += 2) {
        even += a[i] * b[i];
        odd += a[i + 1] * b[i + 1];
    }
    if (i < count) even += a[i] * b[i];
    return sum_lanes(even + odd);
}

double add_springs(const Membrane::Tables& tables, const double* stiffness, const double* rest,
                   const Lanes* x, Lanes* gradient) {
    const std::size_t count = tables.first.size();
    if (count == 0) return 0;
    // Springs of one first node follow one another: its sum stays in a register until the next node. Roots
    // and quotients of some fours are computed before their sums, since they do not wait for one another.
    constexpr std::size_t block = 4;
    Lanes energy = all_lanes(0), pulls[block], differences[block][4];
    const std::int32_t *first = tables.first.data(), *second = tables.second.data();
    std::int32_t node = first[0];
    Lanes at_node = gradient[node];
    for (std::size_t begin = 0; begin < count; begin += 4 * block) {
        const std::size_t fours = std::min(block, (count - begin) / 4);
        for (std::size_t b = 0; b < fours; ++b) {
            const std::size_t s = begin + 4 * b;
            const Four four = lengths(first + s, second + s, x);
            const Lanes k = load_lanes(stiffness + s), stretch = four.length - load_lanes(rest + s);
            energy += k * stretch * stretch;
            pulls[b] = k * stretch / four.length;
            std::copy_n(four.difference, 4, differences[b]);
        }
        for (std::size_t b = 0; b < fours; ++b) {
            for (std::size_t q = 0; q < 4; ++q) {
                const std::size_t s = begin + 4 * b + q;
                const Lanes force = all_lanes(pulls[b][q]) * differences[b][q];
                if (first[s] != node) {
                    gradient[node] = at_node;
                    node = first[s];
                    at_node = gradient[node];
                }
                at_node += force;
                gradient[second[s]] -= force;
            }
        }
    }
    gradient[node] = at_node;
    return 0.5 * sum_lanes(energy);
}

void add_damped_springs(const SpringEnds& ends, const double* stiffness, const double* rest, double damping,
                        const Lanes* x, const Lanes* v, Lanes* gradient) {
    const std::int32_t *first = ends.first, *second = ends.second;
    const Lanes least = all_lanes(shortest * shortest), damped = all_lanes(damping);
    const auto pull_of = [&](std::size_t s) {
        Lanes d[4], u[4];
        for (int q = 0; q < 4; ++q) {
            const auto i = first[s + static_cast<std::size_t>(q)],
                       j = second[s + static_cast<std::size_t>(q)];
            d[q] = x[i] - x[j];
            u[q] = v[i] - v[j];
        }
        transpose_lanes(d[0], d[1], d[2], d[3]);
        transpose_lanes(u[0], u[1], u[2], u[3]);
        Lanes squared = (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2];
        squared = squared > least ? squared : least;
        const Lanes length = sqrt_lanes(squared), approach = (d[0] * u[0] + d[1] * u[1]) + d[2] * u[2];
        return load_lanes(stiffness + s) * (length * (length - load_lanes(rest + s)) + damped * approach) /
               squared;
    };
    const auto add_four = [&](std::size_t s, const Lanes& pull) {
        for (int q = 0; q < 4; ++q) {
            const auto i = first[s + static_cast<std::size_t>(q)],
                       j = second[s + static_cast<std::size_t>(q)];
            const Lanes force = all_lanes(pull[q]) * (x[i] - x[j]);
            gradient[i] += force;
            gradient[j] -= force;
        }
    };
    // Neighbours in the table share nodes, and each sum at a node waits for the one before it. Two places of
    // the table in turn keep the processor busy while it waits. Roots and quotients of some fours are
    // computed before their sums: they do not wait for one another.
    constexpr std::size_t block = 8;
    const std::size_t half = (ends.count / 4 + 1) / 2 * 4;
    Lanes pulls[2][block];
    for (std::size_t begin = 0; begin < half; begin += 4 * block) {
        const std::size_t fours = std::min(block, (half - begin) / 4);
        // Of an odd number of fours the second half has one less.
        const std::size_t second_fours = std::min(fours, (ends.count - half - begin) / 4);
        for (std::size_t b = 0; b < fours; ++b) pulls[0][b] = pull_of(begin + 4 * b);
        for (std::size_t b = 0; b < second_fours; ++b) pulls[1][b] = pull_of(half + begin + 4 * b);
        for (std::size_t b = 0; b < fours; ++b) {
            add_four(begin + 4 * b, pulls[0][b]);
            if (b < second_fours) add_four(half + begin + 4 * b, pulls[1][b]);
        }
    }
}

void make_tangent(const Membrane::Tables& tables, const double* stiffness, const double* rest, const Lanes* x,
                  bool clamped, Data& data) {
    for (std::size_t s = 0; s < tables.first.size(); s += 4) {
        const Four four = lengths(tables.first.data() + s, tables.second.data() + s, x);
        for (int q = 0; q < 4; ++q) {
            const std::size_t place = s + static_cast<std::size_t>(q);
            const double k = stiffness[place], l = four.length[q];
            double across = k * (1 - rest[place] / l);
            if (clamped) across = std::max(0.0, across);
            data.across[place] = across;
            data.along[place] = all_lanes(std::sqrt(std::max(0.0, k - across)) / l) * four.difference[q];
        }
    }
}

void multiply_tangent(const Membrane::Tables& tables, const Data& data, const Lanes* p, Lanes* product) {
    const std::int32_t *first = tables.first.data(), *second = tables.second.data();
    for (std::size_t s = 0; s < tables.first.size(); ++s) {
        const Lanes difference = p[first[s]] - p[second[s]];
        const Lanes& along = data.along[s];
        const Lanes force =
            all_lanes(data.across[s]) * difference + all_lanes(sum_lanes(along * difference)) * along;
        product[first[s]] += force;
        product[second[s]] -= force;
    }
}

}  // namespace fulcrum::membrane_detail
