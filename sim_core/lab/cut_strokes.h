// SPDX-License-Identifier: Apache-2.0
// Random strokes over cuttable surfaces, at rest and deforming, and the extremes of docs/QUALITY.md: every
// step is validated where it touched the surface, the whole surface every tenth stroke (extremes: after every
// step). The property tests run few strokes, `fulcrum lab strokes` many. Deterministic except for the times.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim_core/cutting/cut_mesh.h"
#include "sim_core/lab/result_page.h"

namespace fulcrum::lab {

struct StrokeTally {
    int strokes = 0, steps = 0, refused = 0, cuts = 0, nothing = 0, full = 0;
    int roll_backs = 0;  ///< attempts rolled back
    int retried = 0;     ///< steps that succeeded on a later attempt
    int uncut = 0;       ///< steps without a valid attempt
    int widened = 0;     ///< bands too thin for the triangles they met
    int violations = 0;  ///< violated invariants; the run ends at the first
    int pieces = 0;      ///< pieces dropped
    int flat = 0;        ///< roots without area
    std::string complaint;
    double area_error = 0;       ///< worst, relative
    std::vector<float> step_us;  ///< processor time of each CutMesh::cut (not refused ones)
    void count(const CutReport& report, double step_width);
    void add(const StrokeTally& other);
};

/// Icosahedron subdivided `times` times, radius in m.
TriangleMesh make_sphere(int times, double radius);

struct StrokeSurface {
    std::string name;
    TriangleMesh mesh;
};
/// Sheet, sphere, tube, bowel.
std::vector<StrokeSurface> stroke_surfaces();

/// Strokes of one to four steps of a blade 0.2 to 6 mm wide that begin anywhere: inside a triangle, at a
/// vertex, on or along an edge. deform: the shape changes from stroke to stroke, with stretches of up to a
/// third.
StrokeTally run_strokes(const TriangleMesh& mesh, bool deform, int strokes, std::uint64_t seed);

/// Names of the stress cases.
std::vector<std::string> stress_names();
/// One mesh of a stress case, cut with blades from 0.1 um to 100 mm, including non-finite ones.
void run_stress(std::size_t which, std::uint64_t seed, StrokeTally& tally);

/// `fulcrum lab strokes [N]`: N strokes over the surfaces, N/30 meshes over the stress cases.
ResultPage cut_strokes_page(int strokes);

}  // namespace fulcrum::lab
