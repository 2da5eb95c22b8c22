// SPDX-License-Identifier: Apache-2.0
// Quality range of the surface on its cage: slivers of the mesh against the sharpness of a bend.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sim_core/lab/reference_skin.h"
#include "sim_core/lab/stability_rooms.h"

namespace fulcrum::lab {
namespace {

constexpr double length = 0.32, radius = 0.016;

// Every second circle of the tube moved to within an edge / aspect of the previous one, which turns half of
// the triangles into slivers.
TriangleMesh sliver_tube(double aspect) {
    constexpr int sections = 80, around = 32;
    TriangleMesh mesh = make_tube(length, sections, around, plain_radius(radius));
    const double edge = length / sections;
    for (int i = 1; i < sections; i += 2) {
        for (int k = 0; k < around; ++k) {
            mesh.vertices[static_cast<std::size_t>(i * around + k)].x() = edge * (i - 1) + edge / aspect;
        }
    }
    return mesh;
}

// Fraction of the surface, by rest area, whose outside faces the centre line (folded). Caps are skipped.
double folded_share(const BowelSkin& skin, const std::vector<RingFrame>& frames,
                    const std::vector<Vector3>& positions) {
    double folded = 0, all = 0;
    for (const Triangle& t : skin.rest().triangles) {
        const auto at = [&](const std::vector<Vector3>& points, std::size_t k) -> const Vector3& {
            return points[static_cast<std::size_t>(t[k])];
        };
        const std::vector<Vector3>& rest = skin.rest().vertices;
        const Vector3 area = area_vector(at(rest, 0), at(rest, 1), at(rest, 2));
        if (std::fabs(area.x()) > 0.9 * area.norm()) continue;
        const double s = (at(rest, 0).x() + at(rest, 1).x() + at(rest, 2).x()) / 3;
        const auto& arcs = skin.cage().arc_lengths;
        const auto ring = static_cast<std::size_t>(
            std::min_element(arcs.begin(), arcs.end(),
                             [s](double a, double b) { return std::fabs(a - s) < std::fabs(b - s); }) -
            arcs.begin());
        const Vector3 middle = (at(positions, 0) + at(positions, 1) + at(positions, 2)) / 3,
                      tangent = frames[ring].rotation.col(2);
        Vector3 outward = middle - frames[ring].position;
        outward -= tangent * tangent.dot(outward);
        all += area.norm();
        if (area_vector(at(positions, 0), at(positions, 1), at(positions, 2)).dot(outward) < 0)
            folded += area.norm();
    }
    return folded / all;
}

}  // namespace

std::vector<StabilityMap> skin_stability() {
    StabilityMap map;
    map.model = "skin";
    map.title = "Surface on its cage: slivers against the sharpness of a 90 degree bend";
    map.axes = {{"triangle_aspect", "", {1, 10, 100, 1e3, 1e4, 1e5, 1e6}, true},
                {"bend_radius_in_tube_radii", "", {0.5, 1, 1.5, 2, 3, 4, 6, 10, 12}, true}};
    map.measure = "share of the surface that is folded";
    for (const double aspect : map.axes[0].values) {
        TriangleMesh mesh = sliver_tube(aspect);
        const std::vector<Triangle> triangles = mesh.triangles;
        const SphereChain spheres = sample_spheres(length, 0.016, [](double) { return radius; });
        Cage cage = build_cage(mesh, length, spheres);
        const BowelSkin skin(std::move(mesh), std::move(cage));
        const double rest = enclosed_volume(skin.rest().vertices, triangles);
        std::vector<Vector3> positions(static_cast<std::size_t>(skin.vertices()));
        for (const double bend : map.axes[1].values) {
            StabilityCell cell;
            cell.at = {aspect, bend};
            const auto frames = quarter_bend_frames(skin.cage(), bend * radius);
            skin_all(skin, frames.data(), positions.data());
            cell.finite = std::all_of(positions.begin(), positions.end(),
                                      [](const Vector3& p) { return p.allFinite(); });
            cell.measure = folded_share(skin, frames, positions);
            const double volume_change = std::fabs(enclosed_volume(positions, triangles) / rest - 1);
            double farthest = 0;
            for (const Vector3& p : positions) farthest = std::max(farthest, p.norm());
            if (!cell.finite || farthest > 2 * length)
                cell.outcome = StabilityOutcome::fault;
            else if (cell.measure > 0 || !(volume_change <= 0.02))
                cell.outcome = StabilityOutcome::degraded;
            map.cells.push_back(cell);
        }
    }
    StabilityCurve fold;
    fold.name = "inner side folds";
    fold.formula =
        "bend radius = tube radius: the inner side of the tube is compressed to zero length and folds";
    fold.x = {1, 1e6};
    fold.y = {1, 1};
    StabilityCurve promise;
    promise.name = "accuracy guaranteed above";
    promise.formula =
        "bend radius = 3 tube radii: from here on no fold, and a volume within 2 %, are guaranteed "
        "(docs/QUALITY.md)";
    promise.x = {1, 1e6};
    promise.y = {3, 3};
    map.theory = {fold, promise};
    return {map};
}

}  // namespace fulcrum::lab
