// SPDX-License-Identifier: Apache-2.0
// Sheets shared by the membrane's tests.
#pragma once

#include "sim_core/lab/membrane_reference.h"
#include "sim_core/membrane/membrane.h"
#include "sim_core/numerics/random.h"

namespace fulcrum::test {

inline TriangleMesh sheet(int columns, int rows) {
    return lab::make_sheet(columns, rows, 0.1, 0.1);
}

inline void shake(std::vector<Vector3>& vectors, double size, std::uint64_t seed) {
    Random random(seed);
    for (Vector3& v : vectors) v += size * Vector3(random.normal(), random.normal(), random.normal());
}

inline Vector3 momentum(const Membrane& membrane, const MembraneState& state) {
    Vector3 sum = Vector3::Zero();
    for (std::size_t v = 0; v < state.velocities.size(); ++v)
        sum += membrane.masses()[v] * state.velocities[v];
    return sum;
}

}  // namespace fulcrum::test
