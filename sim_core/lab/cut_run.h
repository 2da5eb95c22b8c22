// SPDX-License-Identifier: Apache-2.0
// A blade that cuts a sheet row by row in steps of 2 mm, for workloads and benchmarks of the topology.
#pragma once

#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum::lab {

/// Square sheet of about `triangles` triangles with edges of 3 mm; a band of 1 mm is cut along wavy rows 9 mm
/// apart, and when no row is left the sheet is reset.
class CutRun {
  public:
    static constexpr double cell = 0.003, width = 0.001, advance = 0.002;  // m
    explicit CutRun(int triangles);
    /// Moves the blade to its next step; not part of the timed work.
    void advance_blade();
    CutReport cut() { return mesh.cut(step, positions.data()); }
    CutMesh mesh;
    std::vector<Vector3> positions;
    BladeStep step;
    std::int64_t steps = 0;

  private:
    void begin_row();
    double side_;
    int cells_, row_ = 0, place_ = 0;
};

}  // namespace fulcrum::lab
