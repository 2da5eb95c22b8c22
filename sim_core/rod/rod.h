// SPDX-License-Identifier: Apache-2.0
// The centre line: an extensible Kirchhoff rod (Pan et al. 2011, Eq. 5; docs/THEORY.md, section 1.1) of n
// segments.
//
// Unknowns: node positions r_0 .. r_n and one twist angle per segment. The directors d1, d2 of a segment are
// perpendicular to its tangent d3; they follow it by parallel transport and are rotated by the twist angle.
// Strains: at the joint between two segments the turning (2 tan(angle/2), isotropic) and the unwrapped twist,
// on segments the stretch. Every point of the rod, r(s) and R(s), follows the quadratic B-spline of the
// nodes: for s between the midpoints of segments i-1 and i it depends on nodes i-1, i, i+1 only.
//
// Units SI; vectors in the patient frame; arc lengths s in rest length, 0 .. length (values outside are
// clamped). Model (Rod, const), state (RodState, copyable) and scratch (RodScratch, one per thread) are
// separate; any number of states may share one Rod. step() and solve() do not allocate, lock or throw once
// the containers have reached their largest size (reserve them), and give the same output bits for the same
// input bits. Invalid RodSpec values throw std::invalid_argument from the constructor.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "sim_core/material/layered_wall.h"
#include "sim_core/numerics/types.h"
#include "sim_core/rod/rod_level.h"

namespace fulcrum {

class StateArchive;

enum class RodEnd : std::uint8_t {
    free,     ///< nothing prescribed
    pinned,   ///< position prescribed, direction and twist free
    held,     ///< position and twist prescribed, bending free
    clamped,  ///< position, direction and twist prescribed (over the first half cell: second order in segment
              ///< length)
};

/// Geometry and material of a rod. Defaults: a bowel.
struct RodSpec {
    int segments = 64;              ///< 2 .. 4096
    double length = 0.9;            ///< m, at rest
    double outer_radius = 0.015;    ///< m
    double inner_radius = 0.012;    ///< m, 0 for a solid rod
    double young_modulus = 32.3e3;  ///< Pa, at rest: E of the linear law, E0 of EXP2
    double poisson_ratio = 0.35;
    /// exp2: stretch and bending are coupled by quadrature over the wall (material/section.h); twist stays
    /// linear.
    MaterialLaw law = MaterialLaw::linear;
    double exponent = 3.0;  ///< a of EXP2, 0.01 .. 100
    /// Optional layers of the wall, lumen first. If given, they replace inner_radius, young_modulus and
    /// exponent. Their total thickness is at most outer_radius.
    std::vector<WallLayer> layers;
    double linear_density = 0.25;    ///< kg/m
    double mass_damping = 6.0;       ///< 1/s: force -c m v
    double stiffness_damping = 0.0;  ///< s: force -c K v, K the elastic tangent at the start of the step
    RodEnd ends[2] = {RodEnd::free, RodEnd::free};
    /// Uniform intrinsic curvature about d1, d2 and twist, 1/m, 1/m, rad/m. Ignored if rest_nodes is given.
    double intrinsic_curvature[3] = {0, 0, 0};
    /// Optional natural shape (segments + 1 distinct nodes). It then determines segment lengths, natural
    /// curvature and start shape, without natural twist, and `length` becomes the length of its polygon.
    /// Empty: straight along +x from the origin, d1 = +y, d2 = +z.
    std::vector<Vector3> rest_nodes;
};

/// Position and orientation of a point of the centre line; columns of rotation are d1, d2, d3 (d3 the
/// tangent).
struct RodFrame {
    Vector3 position = Vector3::Zero();
    Matrix3 rotation = Matrix3::Identity();
};

/// RodFrame with its velocity. Power balance: force . velocity + moment . angular_velocity of a RodLoad at
/// the same s is exactly the power of that load on the rod's unknowns.
struct RodMotion {
    RodFrame frame;
    Vector3 velocity = Vector3::Zero();          ///< m/s
    Vector3 angular_velocity = Vector3::Zero();  ///< rad/s
};

/// Complete state of a rod. Copyable; copies of the same size do not allocate. The arrays have no padding and
/// may be hashed bytewise.
struct RodState {
    std::vector<Vector3> nodes;      ///< n + 1, m
    std::vector<Vector3> directors;  ///< n, d1 of each segment, unit, perpendicular to the segment
    std::vector<double>
        joint_twist;  ///< n + 1, rad, unwrapped, joint i before segment i; 0 and n against the end frames
    std::vector<Vector3> velocities;  ///< n + 1, m/s
    std::vector<double> spins;        ///< n, rad/s about the tangent
    RodFrame ends[2];                 ///< frames of the prescribed ends at the end of the last step

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(nodes, directors, joint_twist, velocities, spins, ends);
    }
};

/// Dead load at arc length s: force through the centre line and moment (spatial). Applied with the directions
/// at the start of the step.
struct RodLoad {
    double s = 0;
    Vector3 force = Vector3::Zero();   ///< N
    Vector3 moment = Vector3::Zero();  ///< N m
};

/// Tension-only spring from the wall point r(s) + R(s) offset to a point in space: tension max(0, k (d -
/// rest) + c d').
struct RodTether {
    double s = 0;
    Vector3 offset = Vector3::Zero();  ///< m, ring frame
    Vector3 anchor = Vector3::Zero();  ///< m, anchor position at the end of the step
    double stiffness = 0;              ///< N/m
    double rest_length = 0;            ///< m
    double damping = 0;                ///< N s/m, acts only while taut
    Vector3 force = Vector3::Zero();   ///< out: N, spring on rod
};

/// Holds the wall point r(s) + R(s) offset at `target` (its position at the end of the step: the motion since
/// the last step enters the first Newton system as a constraint increment). Keep the struct from step to
/// step: reaction is also the warm start. With a finite stiffness it pulls by a spring instead, with at most
/// `most`.
struct RodGrasp {
    double s = 0;
    Vector3 offset = Vector3::Zero();  ///< m, ring frame
    Vector3 target = Vector3::Zero();  ///< m
    /// N/m, of what is between jaws and wall point; infinite: nothing yields.
    double stiffness = std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();  ///< N, of the spring: beyond it the wall slides
    bool hold_rotation = false;                             ///< also holds R(s) at target_rotation
    Matrix3 target_rotation = Matrix3::Identity();
    Vector3 reaction = Vector3::Zero();  ///< in/out: N, jaw on rod (set to zero on a new grasp)
    Vector3 moment = Vector3::Zero();    ///< in/out: N m, jaw on rod, when hold_rotation
    double residual = 0;                 ///< out: m, distance of the wall point from the target
    bool rigid() const { return !(stiffness < std::numeric_limits<double>::infinity()); }
};

/// Unilateral contact g = normal . (r(s) - point) - radius >= 0, lambda >= 0, lambda g = 0 (docs/THEORY.md,
/// section 2).
struct RodContact {
    double s = 0;
    Vector3 normal = Vector3::UnitZ();  ///< unit, towards the rod
    Vector3 point = Vector3::Zero();    ///< m, on the obstacle
    double radius = 0;                  ///< m, of the sphere
    double friction = 0;  ///< Coulomb coefficient; below friction_speed it is scaled in proportion to speed
    double friction_speed = 0.005;               ///< m/s
    Vector3 surface_velocity = Vector3::Zero();  ///< m/s of the obstacle, for friction
    double lambda = 0;                           ///< in/out: N (warm start in; 0 for a new contact)
    double gap = 0;                              ///< out: m, g at the end of the step
};

/// Contact between two points of the same rod (self-collision): g = normal . (r(s) - r(other_s)) - distance
/// >= 0. The motion of the other point lags by one Newton iteration, which keeps the matrix band narrow;
/// equal and opposite force lambda on both.
struct RodSelfContact {
    double s = 0, other_s = 0;
    Vector3 normal = Vector3::UnitZ();  ///< unit, from other_s to s
    double distance = 0;                ///< m, sum of the radii
    double lambda = 0;                  ///< in/out: N
    double gap = 0;                     ///< out: m
};

/// All actions on a rod in one step. Reserve the vectors once; the step writes only the fields marked out.
struct RodInputs {
    Vector3 gravity = Vector3::Zero();  ///< m/s2, on linear_density
    RodFrame ends[2];                   ///< prescribed frames of the ends at the end of the step
    std::vector<RodLoad> loads;
    std::vector<Vector3> nodal_forces;  ///< empty or n + 1, N, dead
    std::vector<RodTether> tethers;
    std::vector<RodGrasp> grasps;
    std::vector<RodContact> contacts;
    std::vector<RodSelfContact> self_contacts;

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(gravity, ends, loads, nodal_forces, tethers, grasps, contacts, self_contacts);
    }
};

/// Solver settings. Defaults: level `newton` of docs/THEORY.md, section 8 to the residual of docs/QUALITY.md.
struct RodSolve {
    using Level = RodLevel;
    Level level = Level::newton;
    int iterations =
        0;  ///< newton_k: k; linearised: load steps (0: 1); newton: limit (0: 200 static, 25 dynamic)
    double tolerance = 1e-6;             ///< |free residual| over max(|external forces|, |reactions|)
    double constraint_tolerance = 1e-9;  ///< m
};

/// Severity of a failed step. The sequence of docs/QUALITY.md: substep and retry, then freeze.
enum class RodFault : std::uint8_t { none = 0, substepped = 1, frozen = 2 };

struct RodReport {
    double residual = 0;             ///< |free residual| over max(|external forces|, |reactions|)
    double force_residual = 0;       ///< N
    double constraint_residual = 0;  ///< m, largest over grasps
    double penetration = 0;          ///< m, deepest contact
    double contact_sum = 0;          ///< N, sum of lambda over contacts
    int iterations = 0;              ///< number of linear systems solved
    int substeps = 1;
    bool converged = false;
    bool finite = true;  ///< false: the inputs or the result were not finite; the state is the last good one
    bool positive_definite = true;  ///< of the tangent at the end (newton)
    RodFault fault = RodFault::none;
    Vector3 end_force[2] = {Vector3::Zero(), Vector3::Zero()};  ///< N, support on rod
    Vector3 end_moment[2] = {Vector3::Zero(),
                             Vector3::Zero()};  ///< N m, support on rod (clamped; held: about the tangent)
};

struct RodEnergy {
    double bend = 0, twist = 0, stretch = 0, external = 0,
           kinetic = 0;  ///< J; external: dead loads and gravity, -work from the origin
    double elastic() const { return bend + twist + stretch; }
};

/// Factorisation and work space for one thread. Made by Rod::make_scratch; holds the factor of the last
/// system solved.
class RodScratch {
  public:
    RodScratch();
    ~RodScratch();
    RodScratch(RodScratch&&) noexcept;
    RodScratch& operator=(RodScratch&&) noexcept;
    /// A step with a copy gives the same bits; assignment between scratches of the same rod does not
    /// allocate.
    RodScratch(const RodScratch& other);
    RodScratch& operator=(const RodScratch& other);
    struct Data;
    Data& data() { return *data_; }
    const Data& data() const { return *data_; }
    std::size_t bytes() const;
    void fields(StateArchive& archive);

  private:
    friend class Rod;
    std::unique_ptr<Data> data_;
};

class Rod {
  public:
    /// Throws std::invalid_argument on values outside the ranges given in RodSpec.
    explicit Rod(RodSpec spec);

    const RodSpec& spec() const { return spec_; }
    int segments() const { return spec_.segments; }
    double length() const { return length_; }
    double bending_stiffness() const { return bending_stiffness_; }                    ///< N m2, EI, at rest
    double torsional_stiffness() const { return torsional_stiffness_; }                ///< N m2, GJ
    double axial_stiffness() const { return axial_stiffness_; }                        ///< N, EA, at rest
    const std::vector<double>& node_arc_lengths() const { return node_arc_lengths_; }  ///< n + 1, m
    double node_mass(int node) const { return node_mass_[static_cast<std::size_t>(node)]; }  ///< kg
    std::size_t bytes() const;

    /// The rod at rest: straight along +x, or in the rest shape; ends at their own frames.
    RodState make_state() const;
    /// A state with the given nodes (n + 1), at rest; directors transported from the start frame without
    /// twist.
    RodState make_state(const std::vector<Vector3>& nodes) const;
    /// Work space for this rod with at most the given numbers of grasps, contacts and so on.
    RodScratch make_scratch(int tethers = 64, int grasps = 8, int contacts = 512,
                            int self_contacts = 256) const;

    /// One implicit Euler step of dt seconds (1e-5 .. 0.1): inertia, damping, everything in `inputs`. The
    /// state is always finite afterwards.
    RodReport step(RodState& state, RodInputs& inputs, double dt, RodScratch& scratch,
                   const RodSolve& solve = {}) const;
    /// Static equilibrium from the given state (velocities are set to zero). Contacts and grasps as in step.
    RodReport solve(RodState& state, RodInputs& inputs, RodScratch& scratch,
                    const RodSolve& solve = {}) const;

    RodMotion frame_at(const RodState& state, double s) const;
    Vector3 wall_point(const RodState& state, double s, const Vector3& offset) const;
    Vector3 wall_velocity(const RodState& state, double s, const Vector3& offset) const;
    /// The offset X with wall_point(state, s, X) = point.
    Vector3 wall_offset(const RodState& state, double s, const Vector3& point) const;
    /// Stiffness of the rod seen at a wall point, N/m, symmetric positive definite: inverse of the compliance
    /// with the factor of the last step (inertia over dt, contacts, tethers and other grasps included; a
    /// grasp of this same point excluded).
    Matrix3 stiffness_at(const RodState& state, double s, const Vector3& offset, RodScratch& scratch) const;
    RodEnergy energy(const RodState& state, const RodInputs& inputs) const;

    /// Sets every velocity to zero (freeze).
    static void stop(RodState& state);
    /// True if every number of the state is finite.
    static bool finite(const RodState& state);

    struct Tables;  ///< per-segment and per-joint constants (rod_tables.h)
    const Tables& tables() const { return *tables_; }

  private:
    RodSpec spec_;
    double length_ = 0, bending_stiffness_ = 0, torsional_stiffness_ = 0, axial_stiffness_ = 0;
    std::vector<double> node_arc_lengths_, node_mass_;
    std::shared_ptr<const Tables> tables_;
};

}  // namespace fulcrum
