// SPDX-License-Identifier: Apache-2.0
// Implementation of Membrane: nodes in sweep order (free ones first), springs in groups of four, and the
// potential that a step minimises.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "sim_core/membrane/membrane.h"
#include "sim_core/membrane/mesh_multigrid.h"

namespace fulcrum {

struct Membrane::Tables {
    std::int32_t nodes = 0, free = 0;   ///< free nodes are 0 .. free-1
    std::vector<std::int32_t> node_of;  ///< node of a vertex
    std::vector<std::int32_t> vertex_of;
    std::vector<double> mass;  ///< kg, by node
    /// Springs by node numbers, first < second, ascending; padded at the end to a multiple of four with
    /// springs of no stiffness from node 0 to node 0.
    std::vector<std::int32_t> first, second;
    std::vector<double> stiffness, rest;
    std::vector<std::int32_t> spring_of;  ///< number in springs(), -1 for padding
    std::vector<std::int32_t> place_of;   ///< inverse of spring_of
    /// Edges of the bound of the springs' stiffness; the weight of edge e is the sum of its springs' shares.
    std::vector<GraphEdge> edges;  ///< node numbers, lower first; the second may be an attached node
    struct Share {
        std::int32_t edge;
        double weight;  ///< N/m
    };
    std::vector<std::int32_t> share_offsets;  ///< by number in springs()
    std::vector<Share> shares;
    std::vector<std::int32_t> inner_edge;  ///< index in inner_edges, -1 if one end is attached
    std::vector<GraphEdge> inner_edges;    ///< between free nodes
    double bounding = 0;                   ///< 1/s2, bounding_eigenvalue with no spring cut
};

struct MembraneScratch::Data {
    // By node.
    std::vector<Lanes> start, start_velocity, position, trial, target, gradient, trial_gradient, direction,
        load, product, residual, preconditioned, search;
    std::vector<double> inertia;  ///< N/m, mass / dt^2 with mass damping; 0 where attached or static
    // By spring index.
    std::vector<double> stiffness, rest;  ///< for the step: damping included, cut springs 0
    std::vector<double> across;           ///< N/m, tangent: share of the identity
    std::vector<Lanes> along;             ///< square root of the rest of the tangent, times the direction
    // The matrix that approximates the stiffness, and its contents.
    MeshMultigrid multigrid;
    double built_dt = -1;
    std::vector<std::uint8_t> built_cut;
    std::uint32_t built_topology = 0;
    bool cuts_behind = false;  ///< not all cut springs are applied yet
    int updates_since = 0;     ///< edges changed since the last build
    /// Held free nodes, each once with all that holds it: in this step, and in the matrix.
    struct Held {
        std::int32_t node = -1;
        double stiffness = 0;
        bool operator==(const Held& other) const {
            return node == other.node && stiffness == other.stiffness;
        }
    };
    std::array<Held, Membrane::most_holds> held, built_held;
    int held_count = 0, built_held_count = 0;
    std::vector<double> edge_weight, inner_weight, diagonal;
    int builds = 0, updates = 0;
    // Quasi-Newton memory: steps and changes of the gradient, three numbers per node and one after the last;
    // and product[i][j] = moved[i] . turned[j].
    static constexpr int memory = 2;  // six bring no gain (measured) and three times the memory traffic
    std::array<std::vector<double>, memory> moved, turned;
    std::array<std::array<double, memory>, memory> products = {};
    int remembered = 0, newest = -1;
    // Last good state.
    MembraneState good;
    double dt = 0;

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(start, start_velocity, position, trial, target, gradient, trial_gradient, direction, load,
              product, residual, preconditioned, search, inertia, stiffness, rest, across, along, multigrid,
              built_dt, built_cut, built_topology, cuts_behind, updates_since, held, built_held, held_count,
              built_held_count, edge_weight, inner_weight, diagonal, builds, updates, moved, turned, products,
              remembered, newest, good, dt);
    }
};

namespace membrane_detail {

inline std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

using Data = MembraneScratch::Data;

double dot(const Lanes* a, const Lanes* b, std::size_t count);

/// Energy of springs of the given stiffness and rest length, gradient added.
double add_springs(const Membrane::Tables& tables, const double* stiffness, const double* rest,
                   const Lanes* x, Lanes* gradient);
/// Ends of springs by node numbers; count is a multiple of four, padded with springs of no stiffness.
struct SpringEnds {
    const std::int32_t *first = nullptr, *second = nullptr;
    std::size_t count = 0;
};
/// Springs with dampers, gradient += stiffness * (length - rest + damping * n . (v_i - v_j)) n.
void add_damped_springs(const SpringEnds& ends, const double* stiffness, const double* rest, double damping,
                        const Lanes* x, const Lanes* v, Lanes* gradient);
/// Prepares tangent products at x; `clamped` omits the negative part that compressed springs have across
/// their direction.
void make_tangent(const Membrane::Tables& tables, const double* stiffness, const double* rest, const Lanes* x,
                  bool clamped, Data& data);
/// product = tangent * p (springs only).
void multiply_tangent(const Membrane::Tables& tables, const Data& data, const Lanes* p, Lanes* product);

/// Loads the state, the step's springs, inertia and loads. dt = 0: static.
void load_step(const Membrane& membrane, const MembraneState& state, const MembraneInputs& inputs, double dt,
               Data& data);
/// Potential at x and its gradient (zero at attached nodes; `support` then holds the spring forces on them).
double potential(const Membrane::Tables& tables, const Data& data, const Lanes* x, Lanes* gradient);
/// Updates the matrix for this dt, the cuts and the holds. False: not positive definite.
bool refresh_matrix(const Membrane& membrane, const MembraneState& state, double dt, Data& data);
/// x = approximate inverse of the matrix times x, at the free nodes; exact for a motion of the whole if
/// nothing is attached, so that linear momentum is conserved for any number of iterations.
void apply_inverse(const Membrane::Tables& tables, Data& data, Lanes* x);
double scaled_residual(const Membrane::Tables& tables, const Data& data, const Lanes* x,
                       const Lanes* gradient);

/// Minimisers: limited-memory quasi-Newton with that inverse, and Newton.
void minimise_quasi_newton(const Membrane::Tables& tables, Data& data, int iterations, double tolerance,
                           MembraneReport& report);
void minimise_newton(const Membrane::Tables& tables, Data& data, int iterations, double tolerance,
                     MembraneReport& report);
void step_symplectic(const Membrane& membrane, MembraneInputs& inputs, double safe_limit, double dt,
                     const MembraneSolve& solve, MembraneReport& report, Data& data);
/// Bound on the highest squared frequency in every shape, 1/s2.
double bounding_eigenvalue(const Membrane::Tables& tables, const double* stiffness, Data& data);
double stable_step(double frequency, double damping_ratio);

}  // namespace membrane_detail
}  // namespace fulcrum
