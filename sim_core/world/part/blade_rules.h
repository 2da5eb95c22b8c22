// SPDX-License-Identifier: Apache-2.0
// How a blade goes into tissue, on in it and out of it, whatever the tissue (Eqs. 6 and 7, docs/THEORY.md 5):
// what sheets and the bowel's wall have in common. A hand's blade is touching -> in the tissue when its force
// across the surface is above `penetrate` and that along it above `static_friction` while its button is held
// -> advances while the force along it is above `dynamic_friction` -> out when it leaves the tissue or the
// button opens; then it does not touch again until it has come clear.
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim_core/cutting/blade.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

enum class BladeTouch : std::uint8_t { away, touching, cutting, clearing };

namespace blade_rules {

inline constexpr double least_advance = 0.00035;  // m that a blade's way gathers before it is cut
inline constexpr double longest_advance = 0.005;  // m in one step of the world
inline constexpr double overlap = 0.0003;         // m by which a step begins in the cut of the one before
inline constexpr double ahead = 0.0002;           // m before the blade, where the tissue is that it is in
inline constexpr double blade_reach = 0.003;      // m along the normal to either side
inline constexpr double out_by = 0.001;           // m beyond the tip's radius: the blade is out of the tissue
inline constexpr double off_by = 0.002;           // m from the nearest tissue: it has run over the rim
inline constexpr double clear_by = 0.0005;        // m beyond the tip's radius
inline constexpr double cover_time =
    0.015;  // s in which a contact comes and goes with the tissue that is there
inline constexpr double least_cover = 0.02;                  // below it there is no contact
inline constexpr double no_cover = 0.30, full_cover = 0.60;  // share of the tool's width with tissue

inline bool button(const ToolKinematics& tool) {
    return (tool.buttons & button_primary) != 0;
}

/// What of a way lies along a surface whose normal n is.
inline Vector3 along_surface(const Vector3& way, const Vector3& n) {
    return way - way.dot(n) * n;
}

/// Whether a blade at work in the tissue has left it: its button is open, or its tip is too far out.
inline bool drawn_out(const ToolKinematics& tool, double tip_radius, const Vector3& here,
                      const Vector3& out) {
    return !button(tool) || (tool.tip - here).dot(out) > tip_radius + out_by;
}

/// What a touching tool does next.
struct TouchMove {
    bool enters = false;
    double slides = 0;  ///< share of `way` that the contact goes with it
};
/// Eq. 6, the force on the contact plane, and Eq. 7. n: out of the tissue, towards the tool; reaction: N,
/// tool on tissue; cutting: of the tissue, null where no blade cuts it; ease: share of its forces that are
/// needed; friction: of the contact; pull: N, what its spring along the surface would have.
inline TouchMove next_touch(const Vector3& n, const Vector3& reaction, bool bites, const CuttingSpec* cutting,
                            double ease, double friction, double pull) {
    TouchMove move;
    const double across = std::max(0.0, -reaction.dot(n));
    const double along = (reaction - reaction.dot(n) * n).norm();
    if (bites && cutting != nullptr && across > ease * cutting->penetrate &&
        along > ease * cutting->static_friction) {
        move.enters = true;
        return move;
    }
    const double most = friction * across;
    if (pull > most && pull > 0) move.slides = 1 - most / pull;
    return move;
}

/// Share of `way` by which a blade in the tissue moves on: until its spring's pull is the dynamic friction.
inline double advance_share(double pull, double friction) {
    return pull > friction ? 1 - friction / pull : 0.0;
}

/// False where the way is too short to be cut yet; else it is what one step cuts.
inline bool clip_advance(Vector3& excess) {
    const double size = excess.norm();
    if (size < least_advance) return false;
    if (size > longest_advance) excess *= longest_advance / size;
    return true;
}

inline BladeStep make_step(const Vector3& here, const Vector3& excess, const Vector3& normal, double width,
                           std::int32_t root) {
    BladeStep blade;
    blade.from = here - overlap * excess.normalized();
    blade.to = here + excess;
    blade.normal = normal;
    blade.width = width;
    blade.depth = blade_reach;
    blade.root = root;
    return blade;
}

/// How much of a tool's width has tissue under it, 0 .. 1: a lip thinner than the tool carries nothing.
/// covered(point): whether there is any under it, along the normal.
template <typename Covered>
double cover_under(const Vector3& foot, const Vector3& normal, double radius, Covered&& covered) {
    const Vector3 x = normal.unitOrthogonal(), y = normal.cross(x);
    constexpr double ring[6][2] = {{1, 0},  {0.5, 0.866},   {-0.5, 0.866},
                                   {-1, 0}, {-0.5, -0.866}, {0.5, -0.866}};
    int count = 0;
    for (int k = 0; k < 13; ++k) {
        const double size = k == 0 ? 0.0 : (k <= 6 ? 0.5 : 0.95) * radius;
        const double* way = ring[k % 6];
        if (covered(Vector3(foot + size * (way[0] * x + way[1] * y)))) ++count;
    }
    return std::clamp((count / 13.0 - no_cover) / (full_cover - no_cover), 0.0, 1.0);
}

/// Whether a point lies in a triangle as seen along n.
inline bool covers(const Vector3& p, const Vector3& n, const Vector3& a, const Vector3& b, const Vector3& c) {
    const double u = (b - a).cross(p - a).dot(n), v = (c - b).cross(p - b).dot(n),
                 w = (a - c).cross(p - c).dot(n);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// Squared distance of a point from the box about a triangle.
inline double box_distance(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
    const Vector3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    return (low - p).cwiseMax(p - high).cwiseMax(Vector3::Zero()).squaredNorm();
}

}  // namespace blade_rules
}  // namespace fulcrum
