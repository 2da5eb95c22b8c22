// SPDX-License-Identifier: Apache-2.0
// Fig. 12: classifies by their corners the triangles that were visible when a stroke began.
#include <cmath>

#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum {
namespace {

// Whether a point, seen along the blade's normal, lies in a triangle.
bool covers(const BladeRegion& region, const Vector3& point, const Vector3 corners[3]) {
    int left = 0, right = 0;
    for (int i = 0; i < 3; ++i) {
        const Vector3 a = corners[i] - point, b = corners[(i + 1) % 3] - point;
        const double turn =
            region.along.dot(a) * region.left.dot(b) - region.left.dot(a) * region.along.dot(b);
        left += turn >= 0 ? 1 : 0;
        right += turn <= 0 ? 1 : 0;
    }
    return left == 3 || right == 3;
}

}  // namespace

void CutMesh::note_cases() {
    const Vector3* positions = editor_.positions();
    for (const std::int32_t met : met_) {
        std::int32_t t = met;
        while (state_.triangles[t].stroke == state_.stroke && state_.triangles[t].parent >= 0)
            t = state_.triangles[t].parent;
        std::int32_t place = state_.stroke_place[t];
        if (place >= state_.stroke_triangles.size() || state_.stroke_triangles[place].triangle != t) {
            StrokeTriangle fresh;
            fresh.triangle = t;
            fresh.distance.setConstant(1e300);
            place = state_.stroke_triangles.size();
            if (!state_.stroke_triangles.push(fresh)) {
                ++state_.stroke_unnamed;
                continue;
            }
            state_.stroke_place[t] = place;
        }
        StrokeTriangle& row = state_.stroke_triangles[place];
        Vector3 corners[3];
        for (int i = 0; i < 3; ++i) {
            const auto c = static_cast<std::size_t>(i);
            corners[i] = positions[state_.triangles[t].vertices[c]];
            if (row.inside[c]) continue;
            double deepest = -1e300;
            for (int k = 0; k < region_.count; ++k)
                deepest = std::max(deepest, region_.planes[static_cast<std::size_t>(k)].distance(corners[i]));
            if (deepest < -tolerance_)
                row.inside[c] = true;
            else if (deepest <= tolerance_)
                row.on_border[c] = true;
            double side = 0;
            const double distance = region_.distance_from_path(corners[i], side);
            if (distance > row.distance[i]) continue;
            row.distance[i] = distance;
            row.side[c] = side >= 0 ? 1 : -1;
        }
        if (state_.stroke_step == 0) row.start = row.start || covers(region_, region_.from, corners);
        if (covers(region_, region_.to, corners)) row.end_step = state_.stroke_step;
    }
}

CutCases CutMesh::cases() const {
    CutCases cases;
    cases.unnamed = state_.stroke_unnamed;
    for (const StrokeTriangle& row : state_.stroke_triangles) {
        int inside = 0, border = 0, left = 0, right = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (row.inside[i]) {
                ++inside;
                continue;
            }
            border += row.on_border[i] ? 1 : 0;
            ++(row.side[i] > 0 ? left : right);
        }
        const bool terminal = row.start || row.end_step == state_.stroke_step - 1;
        std::size_t name = 0;
        if (inside == 3)
            name = 9;
        else if (inside == 2)
            name = left == 1 ? 3 : 4;
        else if (terminal)
            name = inside == 1 ? 2 : border > 0 ? 1 : 0;
        else if (inside == 1)
            name = left == 2 ? 5 : right == 2 ? 6 : 7;
        else
            name = 8;
        ++cases.count[name];
    }
    return cases;
}

}  // namespace fulcrum
