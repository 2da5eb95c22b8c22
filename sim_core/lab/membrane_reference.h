// SPDX-License-Identifier: Apache-2.0
// Sheets in closed form for studies, workloads and tests, and the held sheet on which the membrane's errors
// are measured.
#pragma once

#include <vector>

#include "sim_core/membrane/membrane.h"

namespace fulcrum::lab {

/// rows x columns vertices, vertex = row * columns + column, over width (x) and height (y) at z = 0;
/// diagonals alternate. Sizes in m; at least 2 x 2.
TriangleMesh make_sheet(int columns, int rows, double width, double height);

/// A square sheet of 0.2 m and 40 g held along x = 0 and x = 0.2 m, springs pre-stretched by 5 %: in size and
/// support a mesentery between its root and the bowel. Only the resolution depends on `side`.
struct HeldSheet {
    explicit HeldSheet(int side, double stiffness = 100, double pre_strain = 0.05);
    int side;
    Membrane membrane;
    MembraneInputs inputs;  ///< gravity along -z, attachments at their rest positions
    /// The edge at x = 0.2 m after `frames` frames of 5 ms: on a circle of 10 mm normal to the sheet at 50
    /// mm/s.
    void move_edge(int frames);
};

/// Potential of `end` above the reference's, divided by that of the start with moved attachments above the
/// reference's (dt = 0: static).
double energy_gap(const Membrane& membrane, const MembraneState& start, const MembraneState& end,
                  const MembraneState& reference, const MembraneInputs& inputs, double dt,
                  MembraneScratch& scratch);

}  // namespace fulcrum::lab
