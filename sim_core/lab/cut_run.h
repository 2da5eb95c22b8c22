// SPDX-License-Identifier: Apache-2.0
// A blade that divides a sheet row by row in steps of 2 mm, for workloads and benchmarks of the topology.
#pragma once

#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum::lab {

/// Square sheet of about `triangles` triangles with edges of 3 mm; a band of 1 mm is cut along waving rows
/// 9 mm apart, and when the sheet is used up it is made whole again.
class CutRun {
  public:
    static constexpr double cell = 0.003, width = 0.001, advance = 0.002;  // m
    explicit CutRun(int triangles);
    /// Leads the blade on to its next step; not part of what is timed.
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
