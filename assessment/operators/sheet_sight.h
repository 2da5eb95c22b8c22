// SPDX-License-Identifier: Apache-2.0
// The marked line of a sheet, or of the septum that is worked on, as an operator sees it.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "assessment/operators/behaviour.h"

namespace fulcrum {

/// The sheet about a place of its line.
struct Site {
    Vector3 point = Vector3::Zero();
    Vector3 along = Vector3::UnitX();   ///< unit, towards the line's end
    Vector3 across = Vector3::UnitY();  ///< unit, in the sheet, towards the flap
    Vector3 up = Vector3::UnitZ();      ///< unit, towards the blade's trocar
    Vector3 rim = Vector3::Zero();      ///< m, the flap's edge opposite the place
};

struct SheetSight {
    int cutter = 1;     ///< hand of the blade
    int septa = 1;      ///< pieces of the line
    double septum = 0;  ///< m of each; 0: one sheet
    int level = 0;      ///< of the septa, that is worked on

    bool of_septa() const noexcept { return septum > 0; }
    int level_of(double place) const noexcept {
        return of_septa() ? std::clamp(static_cast<int>((place + 1e-6) / septum), 0, septa - 1) : 0;
    }

    /// Points of the line on the septum that is worked on: [first, last).
    std::pair<std::size_t, std::size_t> points(const Perception& seen, const Body& body) const noexcept {
        const std::size_t count = std::min(seen.line.size(), body.eyes->line_positions().size());
        const std::size_t each = count / static_cast<std::size_t>(septa);
        if (each < 2) return {0, count};
        return {static_cast<std::size_t>(level) * each, (static_cast<std::size_t>(level) + 1) * each};
    }

    Site site_at(const Perception& seen, const Body& body, double place) const noexcept {
        const std::vector<double>& s = body.eyes->line_positions();
        const auto [first, count] = points(seen, body);
        std::size_t upper = first + 1;
        while (upper + 1 < count && s[upper] < place) ++upper;
        const double gap = s[upper] - s[upper - 1];
        const double share = gap > 0 ? (place - s[upper - 1]) / gap : 0.0;  // outside 0 .. 1: straight on
        Site site;
        const Vector3 step = seen.line[upper] - seen.line[upper - 1];
        site.point = seen.line[upper - 1] + share * step;
        if (step.norm() > 0) site.along = step.normalized();
        if (of_septa()) {
            // Across is towards the rectum.
            double away = 1e9;
            for (const Vector3& node : seen.nodes) {
                if ((node - site.point).norm() >= away) continue;
                away = (node - site.point).norm();
                site.rim = node;
            }
        }
        double nearest = of_septa() ? -1 : 1e9;
        for (const Vector3& point : seen.flap) {
            const double off = std::abs((point - site.point).dot(site.along));
            if (off >= nearest) continue;
            nearest = off;
            site.rim = point;
        }
        Vector3 across = site.rim - site.point;
        across -= across.dot(site.along) * site.along;
        if (across.norm() > 1e-6) site.across = across.normalized();
        site.up = site.along.cross(site.across).normalized();
        if (site.up.dot(body.limb[cutter]->trocar().position - site.point) < 0) site.up = -site.up;
        return site;
    }

    /// Where along the line a point lies.
    double place_of(const Perception& seen, const Body& body, const Vector3& point) const noexcept {
        const std::vector<double>& s = body.eyes->line_positions();
        const auto [begin, count] = points(seen, body);
        double best = 1e9, place = 0;
        for (std::size_t i = begin; i + 1 < count; ++i) {
            const Vector3 step = seen.line[i + 1] - seen.line[i];
            double share = (point - seen.line[i]).dot(step) / std::max(1e-12, step.squaredNorm());
            const bool first = i == begin, last = i + 2 == count;
            share = std::clamp(share, first ? -1.0 : 0.0, last ? 2.0 : 1.0);
            const double off = (point - seen.line[i] - share * step).norm();
            if (off >= best) continue;
            best = off;
            place = s[i] + share * (s[i + 1] - s[i]);
        }
        return place;
    }

    double arc_in_front(const Perception& seen, const Body& body) const noexcept {
        const Vector3 middle = site_at(seen, body, (level + 0.5) * septum).point;
        const std::vector<double>& arcs = body.eyes->arc_lengths();
        double away = 1e9, arc = 0;
        for (std::size_t i = 0; i < std::min(seen.nodes.size(), arcs.size()); ++i) {
            if ((seen.nodes[i] - middle).norm() >= away) continue;
            away = (seen.nodes[i] - middle).norm();
            arc = arcs[i];
        }
        return arc;
    }
};

}  // namespace fulcrum
