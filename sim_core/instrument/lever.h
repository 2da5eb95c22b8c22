// SPDX-License-Identifier: Apache-2.0
// The lever at the trocar: what the hand feels of the loads on its instrument (docs/THEORY.md, section 4,
// Force at the hand).
//
// h = handle - trocar, u = h / |h|, loads F at points r from the trocar, M = sum of r x F. The shaft slides
// along u and turns about the trocar without turning about itself, so a motion v of the hand moves a point by
//     u (u . v) + (u x v) x r / |h|
// and by virtual work the force on the hand is
//     F_hand = u (u . F) + (M x h) / |h|^2;
// for one load at the tip: along the shaft times 1, across it times -insertion / |h|. The moment about the
// shaft acts on the roll axis. Patient frame, SI units. Pure functions, any thread; no allocation, lock or
// exception.
#pragma once

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// What acts on an instrument.
struct ToolLoad {
    Vector3 force = Vector3::Zero();   ///< N, sum
    Vector3 moment = Vector3::Zero();  ///< N m, about the trocar

    /// Adds a force (N) at `arm` (m, point minus trocar).
    void add(const Vector3& arm, const Vector3& added) {
        force += added;
        moment += arm.cross(added);
    }
};

/// What the hand feels of it.
struct HandLoad {
    Vector3 force = Vector3::Zero();  ///< N
    double torque = 0;                ///< N m, about the shaft, positive about the direction trocar to tip
};

/// Force and torque on the hand. `handle`: h, m, not zero. A handle at the trocar, or a value that is not
/// finite, gives zero: no hand can hold it there.
HandLoad load_at_hand(const Vector3& handle, const ToolLoad& load);

/// Sum over loads of the symmetric matrices K that link their displacement to their force (N/m; for dampers N
/// s/m), kept so that it can be seen from any handle.
class ToolMatrix {
  public:
    /// Adds K at `arm` (m, point minus trocar).
    void add(const Matrix3& matrix, const Vector3& arm);
    void add(const ToolMatrix& other);
    /// Sum of J^T K J, J the motion of a load's point with the hand's. Zero in the cases in which
    /// load_at_hand gives zero. The change of the lever under a constant load is not part of it.
    Matrix3 at_hand(const Vector3& handle) const;
    bool all_finite() const { return direct_.allFinite() && mixed_.allFinite() && turning_.allFinite(); }

  private:
    // With X the matrix of r x: sums of K, K X and X^T K X.
    Matrix3 direct_ = Matrix3::Zero(), mixed_ = Matrix3::Zero(), turning_ = Matrix3::Zero();
};

}  // namespace fulcrum
