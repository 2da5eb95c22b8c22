// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/membrane_reference.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {

constexpr double width = 0.2;  // m

std::vector<std::int32_t> held_edges(int side) {
    std::vector<std::int32_t> held;
    for (int row = 0; row < side; ++row) {
        held.push_back(row * side);
        held.push_back(row * side + side - 1);
    }
    return held;
}

MembraneMaterial material(double stiffness, double pre_strain) {
    MembraneMaterial m;
    m.structural_stiffness = stiffness;
    m.shear_stiffness = 0.5 * stiffness;
    m.bend_stiffness = 0.05 * stiffness;
    m.mass = 0.04;
    m.pre_strain = pre_strain;
    return m;
}

}  // namespace

TriangleMesh make_sheet(int columns, int rows, double sheet_width, double height) {
    TriangleMesh mesh;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c)
            mesh.vertices.emplace_back(sheet_width * c / (columns - 1), height * r / (rows - 1), 0);
    }
    for (int r = 0; r + 1 < rows; ++r) {
        for (int c = 0; c + 1 < columns; ++c) {
            const int a = r * columns + c, b = a + 1, d = a + columns, e = d + 1;
            if ((r + c) % 2 == 0) {
                mesh.triangles.push_back({a, b, e});
                mesh.triangles.push_back({a, e, d});
            } else {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({b, e, d});
            }
        }
    }
    return mesh;
}

HeldSheet::HeldSheet(int sheet_side, double stiffness, double pre_strain)
    : side(sheet_side),
      membrane(make_sheet(side, side, width, width), material(stiffness, pre_strain), held_edges(side)) {
    inputs.gravity = Vector3(0, 0, -9.81);
    inputs.reactions.resize(membrane.attached().size());
    move_edge(0);
}

void HeldSheet::move_edge(int frames) {
    const MembraneState rest = membrane.make_state();
    double sine = 0, cosine = 1;
    math::sin_cos(5.0 * 0.005 * (frames % 100000), sine, cosine);
    const Vector3 displacement = 0.010 * Vector3(0, sine, 1 - cosine);
    inputs.attachments.resize(membrane.attached().size());
    for (std::size_t a = 0; a < inputs.attachments.size(); ++a) {
        inputs.attachments[a] = rest.positions[static_cast<std::size_t>(membrane.attached()[a])];
        if (a % 2 == 1) inputs.attachments[a] += displacement;
    }
}

double energy_gap(const Membrane& membrane, const MembraneState& start, const MembraneState& end,
                  const MembraneState& reference, const MembraneInputs& inputs, double dt,
                  MembraneScratch& scratch) {
    MembraneState moved = start;
    for (std::size_t a = 0; a < inputs.attachments.size(); ++a)
        moved.positions[static_cast<std::size_t>(membrane.attached()[a])] = inputs.attachments[a];
    const double least = membrane.incremental_potential(start, reference, inputs, dt, scratch);
    const double most = membrane.incremental_potential(start, moved, inputs, dt, scratch);
    return std::max(0.0, membrane.incremental_potential(start, end, inputs, dt, scratch) - least) /
           (most - least);
}

}  // namespace fulcrum::lab
