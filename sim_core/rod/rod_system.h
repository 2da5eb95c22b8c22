// SPDX-License-Identifier: Apache-2.0
// Objective function of one implicit step or static solve: elastic energy, inertia, dead loads, tethers, and
// the augmented Lagrangian of grasps and contacts. All data is in scratch; nothing allocates.
#pragma once

#include <vector>

#include "sim_core/numerics/block_band.h"
#include "sim_core/rod/rod.h"
#include "sim_core/rod/rod_kernel.h"
#include "sim_core/rod/rod_point.h"
#include "sim_core/rod/rod_section.h"

namespace fulcrum {

struct RodScratch::Data {
    RodShape shape, trial, start;
    RodJointTerms joints;
    RodSectionTerms section;  ///< EXP2 only
    BlockBand matrix, reduced;
    BlockBandFactor factor;
    std::vector<double> gradient;   ///< 4 per node: of the whole merit function at the last evaluated shape
    std::vector<double> step;       ///< 4 per node: Newton step
    std::vector<double> inertia;    ///< 4 per node: (mass / dt2 + damping / dt), spin likewise; 0 in statics
    std::vector<double> predicted;  ///< 4 per node: position under inertia and damping only
    std::vector<double> dead;       ///< 4 per node: gravity, loads
    std::vector<double> shift_weight;   ///< 4 per node: scale of the safeguard shift
    std::vector<double> column;         ///< 4 per node: right-hand side of compliance
    std::vector<double> damping_force;  ///< 4 per node, work
    BlockBand damping;                  ///< elastic tangent at the start, stiffness-proportional damping
    bool fixed[2] = {false, false};     ///< end positions prescribed
    Vector3 target[2];                  ///< prescribed positions of the ends
    std::vector<RodPoint> tether_points, grasp_points, contact_points, self_points;
    std::vector<Vector3> grasp_lambda, grasp_force, grasp_target, tether_start, contact_start;
    std::vector<Vector3> turn_lambda, turn_force;  ///< N m, of held rotations
    std::vector<Matrix3> turn_target;
    std::vector<double> contact_lambda, contact_force, contact_start_lambda, self_lambda, self_force;
    std::vector<char> contact_active;  ///< active in the last matrix
    int active_changes = 0;            ///< contacts that have switched since then, at the last evaluation
    int anchor = -1;  ///< statics of a rod held at one end only: that end; segments then turn as rigid bodies
    double dt = 0;    ///< 0 in statics
    double shift = 0;  ///< last safeguard shift that was needed
    double dead_norm = 0;
    std::uint64_t joint_evaluations = 0;  ///< since the scratch was made; with or without the matrix
    std::uint64_t block_factors = 0;      ///< rows of blocks factored since
    double energy = 0, energy_noise = 0, gradient_noise = 0;
    double bend = 0, twist = 0, stretch = 0;
    double constraint_residual = 0, penetration = 0, multiplier_change = 0, reaction_squared = 0;
    RodState saved;
    std::vector<RodGrasp> saved_grasps;
    std::vector<double> saved_lambda, saved_self_lambda;

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(shape, trial, start, joints, section, matrix, reduced, factor, gradient, step, inertia,
              predicted, dead, shift_weight, column, damping_force, damping, fixed, target, tether_points,
              grasp_points, contact_points, self_points, grasp_lambda, grasp_force, grasp_target,
              tether_start, contact_start, turn_lambda, turn_force, turn_target, contact_lambda,
              contact_force, contact_start_lambda, self_lambda, self_force, contact_active, active_changes,
              anchor, dt, shift, dead_norm, joint_evaluations, block_factors, energy, energy_noise,
              gradient_noise, bend, twist, stretch, constraint_residual, penetration, multiplier_change,
              reaction_squared, saved, saved_grasps, saved_lambda, saved_self_lambda);
    }
};

/// Copies a state into a shape, including the end frames.
void shape_from_state(const Rod::Tables& tables, const RodSpec& spec, const RodState& state,
                      const RodFrame ends[2], RodShape& shape);
void state_from_shape(const RodShape& shape, RodState& state);

/// out = base moved by factor * step (4 per node). Returns false if a segment turns over or vanishes. With an
/// anchor (0: first, 1: last node) the step's first-order turn and stretch of every segment are applied in
/// full and the nodes follow from that end, so that a large turn does not stretch the rod.
bool retract(const Rod::Tables& tables, const RodShape& base, const double* step, double factor,
             RodShape& out, int anchor = -1);

/// Merit and its gradient at `shape` (and, with hessian, the matrix) under the multipliers in scratch; false
/// if not finite.
bool evaluate(const Rod::Tables& tables, const RodShape& shape, RodInputs& inputs, bool hessian,
              RodScratch::Data& data);

/// Adds tethers, grasps and contacts to energy, gradient and matrix.
void add_constraints(const Rod::Tables& tables, const RodShape& shape, RodInputs& inputs, bool hessian,
                     RodScratch::Data& data);

/// Adds contacts of the rod with itself.
void add_self_contacts(const Rod::Tables& tables, const RodShape& shape, RodInputs& inputs, bool hessian,
                       RodScratch::Data& data);

/// Sets the selected multipliers (grasps, contacts) to the forces of the last evaluation.
void update_multipliers(const RodInputs& inputs, bool grasps, bool contacts, RodScratch::Data& data);

/// Forces of grasps and contacts in the linear system of data.step, set up at `shape`: l + rho (c + J dx).
/// After a full step c is of second order in dx; the penalty must not turn that remainder into a force.
void linear_reactions(const Rod::Tables& tables, const RodShape& shape, const RodInputs& inputs,
                      RodScratch::Data& data);

/// Stiffness-proportional damping: the elastic tangent at data.shape times spec.stiffness_damping / dt.
void add_damping(const Rod::Tables& tables, const RodSpec& spec, double dt, RodScratch::Data& data);

/// Stretching energy of one segment and of the joints, without constraints. Used by the energy report.
double stretch_energy(const Rod::Tables& tables, const RodShape& shape);

/// Direction of segment j.
Vector3 tangent_of(const RodState& state, std::size_t j);
/// The frame with directors d1 and t x d1 along t; d1 and t are of unit length, at right angles.
Matrix3 frame_of(const Vector3& d1, const Vector3& t);
Vector3 point_position(const RodShape& shape, const RodPoint& point);
/// r(s) + blended R X.
Vector3 wall_position(const RodShape& shape, const RodPoint& point, const Vector3& offset);

/// 3 x 4 derivative blocks of a wall point by nodes joint - 1, joint, joint + 1: columns are x, y, z, twist.
struct RodJacobian {
    Vector3 column[3][4];
};
void wall_jacobian(const RodShape& shape, const RodPoint& point, const Vector3& offset,
                   RodJacobian& jacobian);

/// Eliminates prescribed ends from rhs and matrix; `step` receives -gradient and the prescribed increments.
void reduce(const RodShape& shape, RodScratch::Data& data);

/// Largest free residual, N (twist entries, per radius of gyration, stay in N m).
double free_residual(const RodScratch::Data& data);

}  // namespace fulcrum
