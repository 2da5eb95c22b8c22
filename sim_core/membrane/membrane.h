// SPDX-License-Identifier: Apache-2.0
// A membrane: masses and springs on a triangle mesh (docs/THEORY.md, section 3), with three integrators.
//
// symplectic: v += h a(x, v), x += h v. Stable for h < (2/w)(sqrt(1 + z^2) - z), w the highest frequency, z
// its
//   damping ratio. The limit is enforced: the step is divided, or refused with a report.
// global_local: minimises the incremental potential of implicit Euler with one precomputed matrix for every
//   shape: a bound of the springs' stiffness (each spring's local problem, its direction, is solved exactly).
//   Its inverse is approximated by a multigrid cycle, O(n), with quasi-Newton memory and a line search. A
//   fixed number of iterations, or until a tolerance.
// implicit: the same potential by Newton's method; inner systems by conjugate gradients preconditioned with
// the
//   same matrix.
//
// Model (Membrane, const) / state (MembraneState, copyable; includes the cuts) / scratch (one per thread).
// step and solve do not allocate, lock or throw, and give the same output bits for the same input bits. SI
// units; vectors in the patient frame; vertex numbers are those of the mesh.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/membrane/integrator.h"
#include "sim_core/membrane/springs.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

class StateArchive;

/// Outcome of a step. From `refused` on the state is not the result of a step.
enum class MembraneFault : std::uint8_t {
    none,
    substepped,   ///< symplectic: the step was above the limit and was divided
    unconverged,  ///< implicit: the tolerance was not reached; finite, momentum conserved, energy not minimal
    refused,  ///< not computed: input not finite or beyond 1e9 (loads) and 1e4 m, step outside 1e-9 .. 1 s or
              ///< too far above the limit
    frozen    ///< the result was not finite or out of bounds: last good positions, at rest
};
const char* name_of(MembraneFault fault);

/// Complete state of a membrane. Copyable; copies of the same size do not allocate.
struct MembraneState {
    std::vector<Vector3> positions;   ///< m, one per vertex
    std::vector<Vector3> velocities;  ///< m/s
    std::vector<std::uint8_t> cut;    ///< one per spring, in Membrane::springs() order: 1 if it is cut
    std::uint32_t topology = 0;       ///< increment it with every change of `cut`

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(positions, velocities, cut, topology);
    }
};

/// A vertex held by jaws: a zero-length spring to a target, solved implicitly with the others.
struct MembraneHold {
    std::int32_t vertex = -1;            ///< no effect at an attached vertex
    double stiffness = 0;                ///< N/m, 0 .. 1e9
    Vector3 target = Vector3::Zero();    ///< m, at the end of the step
    Vector3 reaction = Vector3::Zero();  ///< out: N, hold on membrane
};

/// Loads on a membrane in one step.
struct MembraneInputs {
    Vector3 gravity = Vector3::Zero();  ///< m/s2
    std::vector<Vector3> forces;        ///< N, empty or one per vertex; dead loads
    /// Positions of the attached vertices at the end of the step, in Membrane::attached() order; empty:
    /// unchanged.
    std::vector<Vector3> attachments;
    /// Out: N, support on membrane, same order (sized by the caller; not written if the size differs).
    /// Together with the forces they change the momentum of the whole membrane, attached vertices included.
    std::vector<Vector3> reactions;
    std::vector<MembraneHold> holds;  ///< at most Membrane::most_holds; a vertex may be held twice

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(gravity, forces, attachments, reactions, holds);
    }
};

struct MembraneSolve {
    MembraneIntegrator integrator = MembraneIntegrator::global_local;
    int iterations = 0;  ///< limit; 0: global_local 4 per step and 500 static, implicit 50
    double tolerance =
        0;  ///< on MembraneReport::residual; 0: global_local 0 (all iterations), implicit 1e-10
    int most_substeps = 256;  ///< symplectic refuses a step that needs more
};

struct MembraneReport {
    double residual = 0;  ///< |free force imbalance| over the largest of |internal|, |external|, |inertial|
                          ///< force and that of springs strained by 1e-4
    double energy = 0;    ///< J, of the springs
    double potential =
        0;  ///< J, incremental potential that was minimised (static: springs minus work of dead loads)
    int iterations = 0;        ///< outer iterations
    int inner_iterations = 0;  ///< conjugate gradient steps
    int substeps = 1;
    bool converged = true;
    bool finite = true;  ///< false: input or result was not finite; the state is finite in any case
    MembraneFault fault = MembraneFault::none;
};

struct MembraneEnergy {
    double structural = 0, shear = 0, bend = 0, kinetic = 0;  ///< J
    double elastic() const { return structural + shear + bend; }
};

/// Highest frequency and the step limits that follow from it.
struct MembraneLimit {
    double frequency = 0;  ///< rad/s, of the tangent at the given state (Lanczos), from below within 1 %
    double safe_frequency =
        0;  ///< rad/s, bound that no shape exceeds; 1 to 2 times `frequency` on meshes at rest
    double damping_ratio = 0;   ///< of that mode
    double time_step = 0;       ///< s, (2/w)(sqrt(1 + z^2) - z) for `frequency`; infinite without stiffness
    double safe_time_step = 0;  ///< s, the same for `safe_frequency`; this limit is enforced
};

/// Work space and multigrid for one thread. Made by Membrane::make_scratch.
class MembraneScratch {
  public:
    MembraneScratch();
    ~MembraneScratch();
    MembraneScratch(MembraneScratch&&) noexcept;
    MembraneScratch& operator=(MembraneScratch&&) noexcept;
    /// A step resumes from a copy bit for bit.
    MembraneScratch(const MembraneScratch& other);
    MembraneScratch& operator=(const MembraneScratch& other);
    struct Data;
    Data& data() { return *data_; }
    std::size_t bytes() const;
    void fields(StateArchive& archive);
    /// Number of matrix builds, and of changed edges or diagonal entries since the last one.
    int builds() const, updates() const;
    /// Multiplications: for building the levels; for one cycle (each of four lanes); and springs. For the
    /// size sweep.
    struct Operations {
        std::int64_t build = 0, solve = 0, springs = 0;
    };
    Operations operations() const;

  private:
    friend class Membrane;
    std::unique_ptr<Data> data_;
};

class Membrane {
  public:
    /// attached: vertices with prescribed positions (fixed or moved), in any order, all different. Throws
    /// InputError on a bad mesh, material or vertex number.
    Membrane(const TriangleMesh& mesh, const MembraneMaterial& material, std::vector<std::int32_t> attached);
    ~Membrane();
    Membrane(Membrane&&) noexcept;

    std::int32_t vertices() const { return static_cast<std::int32_t>(masses_.size()); }
    const std::vector<MembraneSpring>& springs() const { return springs_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }
    const std::vector<std::int32_t>& attached() const { return attached_; }
    /// True if a corner is not attached.
    bool any_free(const Triangle& corners) const noexcept;
    const std::vector<double>& masses() const { return masses_; }  ///< kg
    const MembraneMaterial& material() const { return material_; }
    std::size_t bytes() const;

    /// The given mesh, at rest.
    MembraneState make_state() const;
    /// Builds the matrix for steps of dt seconds (a different dt later rebuilds it in the step).
    MembraneScratch make_scratch(double dt = 0.005) const;

    /// One step of dt seconds. Springs cut since the last step are removed from the matrix gradually, at most
    /// `updates_per_step` per step; until then the matrix is stiffer than necessary.
    static constexpr int updates_per_step = 48;
    static constexpr int most_holds = 16;
    MembraneReport step(MembraneState& state, MembraneInputs& inputs, double dt, MembraneScratch& scratch,
                        const MembraneSolve& solve = {}) const noexcept;
    /// Static equilibrium from the given state (velocities become zero); refused if nothing is attached.
    MembraneReport solve(MembraneState& state, MembraneInputs& inputs, MembraneScratch& scratch,
                         const MembraneSolve& solve = {}) const noexcept;

    MembraneEnergy energy(const MembraneState& state) const;
    /// Incremental potential of a step of dt from `start` to `end` (minimised by an implicit Euler step). The
    /// 1 % of the reference workloads is measured in this value. dt = 0: static, springs minus work of the
    /// loads from start.
    double incremental_potential(const MembraneState& start, const MembraneState& end,
                                 const MembraneInputs& inputs, double dt, MembraneScratch& scratch) const;
    /// Negative gradient of the springs' energy, N, one per vertex (attached ones included).
    void forces(const MembraneState& state, std::vector<Vector3>& forces) const;
    /// Tangent (second derivative of the energy) times `direction`, N, one per vertex.
    void tangent_times(const MembraneState& state, const std::vector<Vector3>& direction,
                       std::vector<Vector3>& product) const;
    MembraneLimit limit(const MembraneState& state, MembraneScratch& scratch) const;
    static bool finite(const MembraneState& state);
    /// Sets every velocity to zero.
    static void stop(MembraneState& state) noexcept;

    struct Tables;
    const Tables& tables() const { return *tables_; }

  private:
    std::vector<MembraneSpring> springs_;
    std::vector<Triangle> triangles_;
    std::vector<Vector3> rest_;
    std::vector<std::int32_t> attached_;
    std::vector<double> masses_;
    MembraneMaterial material_;
    std::unique_ptr<const Tables> tables_;
};

}  // namespace fulcrum
