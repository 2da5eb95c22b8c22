// SPDX-License-Identifier: Apache-2.0
// `fulcrum lab run` with "model": "cut": strokes of a blade over a mesh at rest (docs/FORMATS.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim_core/cutting/cut_mesh.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum::lab {

/// {"model": "cut", "mesh", "width_m", "strokes": [[[x, y, z], ...], ...]} and, with defaults, "fixed" (none)
/// and "ends" ("square"; "round" adds half an octagon of the blade's width) gives {"visible_triangles",
/// "vertices", "area_before_m2", "area_after_m2", "area_removed_m2", "pieces", "dropped_pieces", "cases",
/// "min_angle_deg", "time_us_per_step", "rolled_back", "uncut_steps", "violation"}. Throws InputError.
nlohmann::json run_cut_study(const JsonDocument& study);

/// A blade moved over a mesh at rest: strokes of any length, in steps of about two widths, each with the
/// surface's local normal.
class RestBlade {
  public:
    struct Tally {
        CutCases cases;               ///< of all strokes
        std::vector<double> step_us;  ///< time of each CutMesh::cut
        std::int32_t roll_backs = 0, uncut = 0, dropped = 0;
        bool full = false;  ///< a capacity was exhausted; nothing was cut after it
    };
    /// Throws InputError as CutMesh does.
    RestBlade(const TriangleMesh& mesh, const std::vector<std::int32_t>& fixed, const CutCapacity& capacity);
    /// Performs a stroke. If any vertex is fixed, pieces without a path to a fixed vertex fall and are
    /// removed. False if a capacity was exhausted.
    bool stroke(const std::vector<Vector3>& path, double width, BladeEnd ends, Tally& tally);
    /// Number of steps that stroke() makes along a path.
    static std::int32_t steps_of(const std::vector<Vector3>& path, double width);
    const CutMesh& mesh() const { return mesh_; }
    const std::vector<Vector3>& positions() const { return positions_; }

  private:
    /// Root nearest to a point, searched from the last one, and the closest point on it.
    std::int32_t follow(const Vector3& point, double near, Vector3& foot, Vector3& normal);
    void drop_pieces(Tally& tally);

    CutMesh mesh_;
    std::vector<Vector3> positions_, normals_;
    bool held_ = false;
    std::int32_t root_ = -1;
};

/// Smallest angle of any visible triangle at rest, degrees; 180 if none is left.
double least_angle_deg(const CutMesh& mesh);
/// Area of the visible triangles computed from their vertices at rest, m2.
double area_at_rest(const CutMesh& mesh);

}  // namespace fulcrum::lab
