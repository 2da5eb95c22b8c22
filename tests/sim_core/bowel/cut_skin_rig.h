// SPDX-License-Identifier: Apache-2.0
// A haustral tube whose surface is cut along paths given by (x, angle) on it at rest, in any shape of its
// cage.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim_core/bowel/cut_skin.h"
#include "sim_core/numerics/functions.h"
#include "tests/support/tube.h"

namespace fulcrum::test {

/// (m along the tube, rad around it).
struct TubePoint {
    double x = 0, angle = 0;
};

struct CutTube {
    static constexpr double length = 0.16, radius = 0.016, blade_width = 0.0006;

    explicit CutTube(int steps = 400)
        : skin(make_skin(length, radius, 0.016, 96, 48, haustral_radius(radius))),
          binder(skin.cage()),
          frames(rest_frames(skin.cage())),
          cut(skin, held(skin), steps) {}

    /// Both ends.
    static std::vector<std::int32_t> held(const BowelSkin& skin) {
        std::vector<std::int32_t> vertices;
        for (std::int32_t v = 0; v < skin.vertices(); ++v) {
            const double x = skin.rest().vertices[static_cast<std::size_t>(v)].x();
            if (x < 0.004 || x > length - 0.004) vertices.push_back(v);
        }
        return vertices;
    }
    Vector3 at_rest(const TubePoint& p) const {
        double sine = 0, cosine = 1;
        math::sin_cos(p.angle, sine, cosine);
        const double r = haustral_radius(radius)(p.x, p.angle);
        return {p.x, r * cosine, r * sine};
    }
    Vector3 now(const Vector3& rest) { return skin_vertex(binder.bind(binder.gap_of(rest), rest), frames); }
    CutSkin::Report step(const TubePoint& from, const TubePoint& to) {
        BladeStep blade;
        const Vector3 first = at_rest(from), last = at_rest(to);
        blade.from = now(first);
        blade.to = now(last);
        const Vector3 middle = 0.5 * (first + last), outward(0, middle.y(), middle.z());
        blade.normal =
            now(middle + 0.001 * outward.normalized()) - now(middle - 0.001 * outward.normalized());
        blade.width = blade_width;
        blade.depth = 0.003;
        blade.end = BladeEnd::round;
        std::vector<Vector3> positions(static_cast<std::size_t>(cut.surface().capacity().vertices));
        cut.place_all(frames.data(), positions.data());
        blade.root = cut.surface().nearest_root(blade.from, positions.data());
        return cut.cut(blade, frames.data());
    }
    /// Makes a stroke; returns the pieces that were detached.
    CutSkin::Report stroke(const std::vector<TubePoint>& path) {
        cut.begin_stroke();
        CutSkin::Report sum;
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            const CutSkin::Report one = step(path[i], path[i + 1]);
            sum.cut.removed_area += one.cut.removed_area;
            sum.cut.roll_backs += one.cut.roll_backs;
            if (one.cut.outcome == CutOutcome::cut) sum.cut.outcome = CutOutcome::cut;
            sum.parted += one.parted;
            sum.parted_area += one.parted_area;
        }
        return sum;
    }
    /// A circle of that radius (m) on the wall, a little more than once around.
    static std::vector<TubePoint> circle(const TubePoint& centre, double size) {
        std::vector<TubePoint> path;
        constexpr int steps = 28;
        for (int i = 0; i <= steps + 1; ++i) {
            double sine = 0, cosine = 1;
            math::sin_cos(6.283185307179586 * i / steps, sine, cosine);
            path.push_back({centre.x + size * cosine, centre.angle + size / radius * sine});
        }
        return path;
    }
    static std::vector<TubePoint> line(const TubePoint& from, const TubePoint& to, int steps) {
        std::vector<TubePoint> path;
        for (int i = 0; i <= steps; ++i) {
            const double u = static_cast<double>(i) / steps;
            path.push_back({(1 - u) * from.x + u * to.x, (1 - u) * from.angle + u * to.angle});
        }
        return path;
    }

    BowelSkin skin;
    SkinBinder binder;
    std::vector<RingFrame> frames;
    CutSkin cut;
};

}  // namespace fulcrum::test
