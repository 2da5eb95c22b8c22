// SPDX-License-Identifier: Apache-2.0
// The blade law: how a blade goes into tissue, on in it and out of it, whatever the tissue (Eqs. 6 and 7,
// docs/THEORY.md 5). A hand's blade is
//   away      until the tool presses on tissue, then
//   touching  until its force across the surface is above `penetrate` and that along it above
//             `static_friction` while its button is held, then
//   cutting   it advances while the force along it is above `dynamic_friction`, until it leaves the tissue or
//             the button opens, then
//   clearing  until it has come clear; only then does it touch again.
// A part supplies what is near, how much of it is under the tool, how stiff it is, and how a cut is made.
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim_core/cutting/blade.h"
#include "sim_core/instrument/device.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

enum class BladeTouch : std::uint8_t { away, touching, cutting, clearing };

/// A hand's blade at the tissue of one part. Copyable state, to which the part adds its own.
struct BladeHand {
    BladeTouch touch = BladeTouch::away;
    Vector3 normal = Vector3::UnitZ();   ///< outward, of the surface there
    double cover = 0;                    ///< 0 .. 1, share of the contact that there is tissue for
    bool linked = false;                 ///< a spring along the surface holds the tool on its place
    Vector3 target = Vector3::Zero();    ///< m, where the tool would have that place
    Vector3 reaction = Vector3::Zero();  ///< N, tool on tissue
};

/// How a tool is on the tissue near it; `through`: in a gap of it, past the surface.
enum class BladePress : std::uint8_t { none, pressed, through };

/// What the law asks of the tissue after it was solved.
struct BladeContact {
    Vector3 here = Vector3::Zero();        ///< m, place that the tool is linked to
    Vector3 normal = Vector3::UnitZ();     ///< of the contact plane, out of the tissue
    Vector3 outward = Vector3::UnitZ();    ///< towards the tool, by which it comes out
    Vector3 reaction = Vector3::Zero();    ///< N, tool on tissue
    double stiffness = 0;                  ///< N/m
    double friction = 0;                   ///< of a touching tool
    double grip = 0;                       ///< N, dynamic friction of the tissue that the blade is in
    double ease = 1;                       ///< share of the tissue's forces that the blade needs
    const CuttingSpec* cutting = nullptr;  ///< null: no blade cuts it
    bool bites = false;                    ///< the tool is a blade and its button is held
};

namespace blade_law {

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

/// First half, before the tissue is solved. reaches: the tool may be on the tissue. `tissue` has
///   forget()           the tool is away from it
///   lost()             what it was in or on is gone
///   stay()             it is in the tissue: where its place is now
///   leave()            its cut ends
///   find()             looks for tissue near; false: nothing changes, or the tissue has said so itself
///   clear()            whether a tool that was in the tissue has come clear
///   between(clear)     of such a tool; true: that was all in this step
///   cover()            0 .. 1, share of the tool's width with tissue under it
///   press()            BladePress
///   fall_through()     it went through a gap
///   touch(fresh)       it presses; fresh: it did not in the step before
///   release()          it presses no longer
template <typename Tissue>
void approach(BladeHand& hand, bool reaches, double dt, Tissue&& tissue) noexcept {
    if (!reaches) {
        if (hand.touch == BladeTouch::cutting) tissue.leave();
        hand.touch = BladeTouch::away;
        tissue.forget();
        return;
    }
    const bool lost = tissue.lost();
    if (hand.touch == BladeTouch::cutting) {
        if (!lost) {
            tissue.stay();
            return;
        }
        tissue.leave();
    }
    if (!tissue.find()) return;
    if (hand.touch == BladeTouch::clearing) {
        const bool clear = tissue.clear();
        if (clear) hand.touch = BladeTouch::away;
        if (tissue.between(clear)) return;
    }
    hand.cover += (tissue.cover() - hand.cover) * dt / (cover_time + dt);
    const BladePress press = tissue.press();
    if (press == BladePress::through) {
        hand.touch = BladeTouch::clearing;
        tissue.fall_through();
    } else if (press == BladePress::pressed) {
        if (hand.touch == BladeTouch::clearing) return;
        const bool fresh = hand.touch == BladeTouch::away || lost;
        hand.touch = BladeTouch::touching;
        tissue.touch(fresh);
    } else if (hand.touch == BladeTouch::touching) {
        hand.touch = BladeTouch::away;
        tissue.release();
    }
}

/// Second half, after it. `tissue` has
///   contact()          BladeContact
///   enter(here, along) the blade goes into it; along: m, of its spring
///   slide(to)          the contact goes with the tool to a point
///   leave()            the blade comes out
///   lead(by)           by: m, the blade's advance; returns what the tissue lets it have of that
///   advance(here, by)  the cut
template <typename Tissue>
void follow(BladeHand& hand, const ToolKinematics& tool, double tip_radius, Tissue&& tissue) noexcept {
    if (!hand.linked || (hand.touch != BladeTouch::touching && hand.touch != BladeTouch::cutting)) return;
    const BladeContact at = tissue.contact();
    const Vector3 along = along_surface(hand.target - at.here, at.normal);
    if (hand.touch == BladeTouch::touching) {
        const double pull = at.stiffness * hand.cover * along.norm();
        const TouchMove move =
            next_touch(at.normal, at.reaction, at.bites, at.cutting, at.ease, at.friction, pull);
        if (move.enters) {
            tissue.enter(at.here, along);
        } else if (move.slides > 0) {
            tissue.slide(at.here + move.slides * along);
        }
        return;
    }
    if (drawn_out(tool, tip_radius, at.here, at.outward)) {
        tissue.leave();
        return;
    }
    const double share = advance_share(at.stiffness * along.norm(), at.grip);
    if (!(share > 0)) return;
    Vector3 excess = tissue.lead(share * along);
    if (clip_advance(excess)) tissue.advance(at.here, excess);
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

}  // namespace blade_law
}  // namespace fulcrum
