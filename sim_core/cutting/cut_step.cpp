// SPDX-License-Identifier: Apache-2.0
// One step of the blade: list, clip, remove, tidy, validate, commit (cut_mesh.h).
#include <algorithm>
#include <cmath>

#include "sim_core/cutting/cut_mesh.h"

namespace fulcrum {
namespace {

// A vertex this near to a border counts as on it; each retry moves borders further to nearby vertices. In
// widths, but at least this fraction of the radius of the coarsest root met: triangles smaller in both
// directions have negligible area in their root (least_share).
struct Snap {
    double of_width, of_root;
};
constexpr Snap snaps[] = {{2e-3, 2e-5}, {2e-2, 5e-5}, {1e-1, 1e-4}};
constexpr double least_width =
    1e-3;  // of a band, as a fraction of the coarsest root met: needed by its corners
// A part with a smaller share is not created: the border goes through the nearer end of the edge if that end
// is within this fraction of the width, or of the coarsest root.
constexpr double meagre = 4 * least_share;
constexpr double give_of_width = 0.5, give_of_root = 3e-3;

}  // namespace

void CutMesh::begin_stroke() {
    ++state_.stroke;
    state_.stroke_step = 0;
    state_.stroke_unnamed = 0;
    state_.stroke_triangles.clear();
}

CutReport CutMesh::cut(const BladeStep& step, Vector3* positions) {
    CutReport report;
    const BladeFault fault = make_region(step, region_);
    if (fault == BladeFault::no_advance) return report;
    if (fault != BladeFault::none) {
        report.outcome = CutOutcome::invalid;
        return report;
    }
    if (step.root < 0 || step.root >= model_->root_count) return report;
    report.width = step.width;
    for (const Snap& snap : snaps) {
        report.outcome = attempt(step, positions, snap.of_width, snap.of_root, report);
        if (report.outcome != CutOutcome::rolled_back) break;
        ++report.roll_backs;
    }
    if (report.outcome == CutOutcome::cut) ++state_.stroke_step;
    return report;
}

CutOutcome CutMesh::attempt(const BladeStep& step, Vector3* positions, double of_width, double of_root,
                            CutReport& report) {
    const double removed_before = state_.area_removed;
    double tolerance = of_width * report.width, coarsest = 0, depth = region_.reach;
    // A wider band may meet a coarser root: repeat.
    for (;;) {
        if (!list_triangles(step.root, tolerance, positions)) return CutOutcome::invalid;
        for (const std::int32_t t : met_)
            coarsest = std::max(coarsest, model_->radii[static_cast<std::size_t>(state_.triangles[t].root)]);
        const double width = std::max(report.width, least_width * coarsest);
        const double least = std::max(of_width * width, of_root * coarsest);
        const bool thin = width > report.width || depth < 4 * least;
        if (!thin && least <= tolerance) break;
        tolerance = std::max(least, tolerance);
        if (!thin) continue;
        BladeStep wider = step;
        wider.width = report.width = width;
        wider.depth = depth = std::max(step.depth, 4 * least);
        const BladeFault fault = make_region(wider, region_);
        if (fault != BladeFault::none)
            return fault == BladeFault::no_advance ? CutOutcome::nothing : CutOutcome::invalid;
    }
    tolerance_ = tolerance;
    give_ = std::max(give_of_width * report.width, give_of_root * coarsest);
    report.met = met_.size();
    if (met_.size() == 0) return CutOutcome::nothing;
    double nearest = 1e300;
    for (const std::int32_t t : met_) {
        const CutTriangle& row = state_.triangles[t];
        const Vector3 centre =
            (positions[row.vertices[0]] + positions[row.vertices[1]] + positions[row.vertices[2]]) / 3;
        const double distance = (centre - step.to).squaredNorm();
        if (distance >= nearest) continue;
        nearest = distance;
        report.root = row.root;
    }
    editor_.begin(*model_, state_, positions);
    const bool done = clip(tolerance) && (band_.size() == 0 || editor_.remove(band_)) && tidy() &&
                      editor_.wrong_here() == nullptr && sort_fragments();
    if (!done) {
        report.lacking = editor_.lacking();
        editor_.roll_back();
        return report.lacking == CutLimit::none ? CutOutcome::rolled_back : CutOutcome::full;
    }
    note_cases();
    editor_.commit();
    report.removed_area = state_.area_removed - removed_before;
    return CutOutcome::cut;
}

bool CutMesh::list_triangles(std::int32_t root, double inset, const Vector3* positions) {
    // Search along the surface from root to root: over triangles near the band, and over roots that have lost
    // area, as far as the band could reach at rest.
    met_.clear();
    queue_.clear();
    ++mark_;
    const double margin = 2 * region_.half_width;
    const double reach = 2 * region_.radius;
    const Vector3& centre = model_->centres[static_cast<std::size_t>(root)];
    const double spread = model_->radii[static_cast<std::size_t>(root)];
    root_mark_[root] = mark_;
    queue_.push(root);
    for (std::int32_t head = 0; head < queue_.size(); ++head) {
        const std::int32_t r = queue_[head];
        bool near = head == 0;
        for (std::int32_t t = state_.roots[r].first_visible; t >= 0; t = state_.triangles[t].next_in_root) {
            const Triangle& v = state_.triangles[t].vertices;
            const Vector3 &a = positions[v[0]], &b = positions[v[1]], &c = positions[v[2]];
            if (!std::isfinite(a.sum() + b.sum() + c.sum())) return false;
            if (!region_.near(a, b, c, margin)) continue;
            near = true;
            if (region_.meets(a, b, c, inset)) met_.push(t);
        }
        if (!near && state_.roots[r].removed_share > 0) {
            const auto here = static_cast<std::size_t>(r);
            const double far = reach + spread + model_->radii[here];
            near = (model_->centres[here] - centre).squaredNorm() < far * far;
        }
        if (!near) continue;
        for (int e = 0; e < 3; ++e) {
            const std::int32_t next =
                model_->adjacency
                    .triangle_neighbours[3 * static_cast<std::size_t>(r) + static_cast<std::size_t>(e)];
            if (next < 0 || root_mark_[next] == mark_) continue;
            root_mark_[next] = mark_;
            queue_.push(next);
        }
    }
    return true;
}

const CutMesh::VertexSides& CutMesh::find_sides(std::int32_t vertex) {
    const Vector3& x = editor_.positions()[vertex];
    unsigned outside = 0, inside = 0;
    for (int k = 0; k < region_.count; ++k) {
        const double distance = region_.planes[static_cast<std::size_t>(k)].distance(x);
        outside |= static_cast<unsigned>(distance > tolerance_) << k;
        inside |= static_cast<unsigned>(distance < -tolerance_) << k;
    }
    sides_[vertex] = {editor_.stamp(), static_cast<std::uint16_t>(outside),
                      static_cast<std::uint16_t>(inside)};
    return sides_[vertex];
}

bool CutMesh::clip(double tolerance) {
    tolerance_ = tolerance;
    band_.clear();
    ++mark_;
    for (const std::int32_t t : met_) {
        band_.push(t);
        triangle_mark_[t] = mark_;
    }
    for (int k = 0; k < region_.count; ++k)
        if (!clip_by(k)) return false;
    return true;
}

bool CutMesh::clip_by(int plane) {
    const auto k = static_cast<std::size_t>(plane);
    const unsigned bit = 1U << plane;
    CutList<std::int32_t>& made = editor_.made();
    std::int32_t kept = 0;
    for (std::int32_t i = 0; i < band_.size(); ++i) {
        const std::int32_t t = band_[i];
        while (editor_.visible(t)) {
            const Triangle v = state_.triangles[t].vertices;
            const unsigned outside[3] = {sides(v[0]).outside & bit, sides(v[1]).outside & bit,
                                         sides(v[2]).outside & bit};
            if ((outside[0] | outside[1] | outside[2]) == 0) break;
            int edge = 0;
            while (edge < 3) {
                const auto e = static_cast<std::size_t>(edge), f = e == 2 ? 0 : e + 1;
                if ((outside[e] != 0 && (sides(v[f]).inside & bit) != 0) ||
                    (outside[f] != 0 && (sides(v[e]).inside & bit) != 0))
                    break;
                ++edge;
            }
            if (edge == 3) break;
            const std::int32_t a = v[static_cast<std::size_t>(edge)],
                               b = v[static_cast<std::size_t>((edge + 1) % 3)];
            const std::int32_t other = neighbour_at(state_.triangles[t], edge);
            const bool other_in_band = other >= 0 && triangle_mark_[other] == mark_;
            const double at_a = region_.planes[k].distance(editor_.positions()[a]);
            const double at_b = region_.planes[k].distance(editor_.positions()[b]);
            const double near = std::min(std::abs(at_a), std::abs(at_b));
            const double whole =
                std::min(state_.triangles[t].share, other < 0 ? 1.0 : state_.triangles[other].share);
            if (whole * near < meagre * std::abs(at_a - at_b) && near < give_) {
                VertexSides& end = sides_[std::abs(at_a) < std::abs(at_b) ? a : b];
                end.outside = static_cast<std::uint16_t>(end.outside & ~bit);
                end.inside = static_cast<std::uint16_t>(end.inside & ~bit);
                continue;
            }
            made.clear();
            const std::int32_t m = editor_.split_edge(t, edge, at_a / (at_a - at_b));
            if (m < 0) return false;
            // On this plane by construction, and on every plane that contains both ends of the edge.
            sides(m);
            const unsigned off = sides_[a].outside | sides_[a].inside | sides_[b].outside | sides_[b].inside;
            sides_[m].outside = static_cast<std::uint16_t>(sides_[m].outside & off & ~bit);
            sides_[m].inside = static_cast<std::uint16_t>(sides_[m].inside & off & ~bit);
            // The first two are the halves of t, the next two those of its neighbour.
            for (std::int32_t n = 0; n < made.size(); ++n) {
                if (n >= 2 && !other_in_band) break;
                if (triangle_mark_[made[n]] == mark_) continue;
                triangle_mark_[made[n]] = mark_;
                if (!band_.push(made[n])) return false;
            }
        }
    }
    // Triangles beyond this plane are kept unchanged.
    for (std::int32_t i = 0; i < band_.size(); ++i) {
        const std::int32_t t = band_[i];
        bool beyond = !editor_.visible(t);
        if (!beyond) {
            const Triangle& v = state_.triangles[t].vertices;
            beyond = ((sides(v[0]).outside | sides(v[1]).outside | sides(v[2]).outside) & bit) != 0;
        }
        if (beyond)
            triangle_mark_[t] = 0;
        else
            band_[kept++] = t;
    }
    band_.resize(kept);
    return true;
}

CutReport CutMesh::remove_piece(std::int32_t piece, Vector3* positions) {
    CutReport report;
    band_.clear();
    for (std::int32_t t = 0; t < state_.triangle_count; ++t)
        if (visible(t) && piece_of_[t] == piece) band_.push(t);
    if (band_.size() == 0) return report;
    const double removed_before = state_.area_removed;
    report.met = band_.size();
    editor_.begin(*model_, state_, positions);
    const bool done = editor_.remove(band_) && editor_.wrong_here() == nullptr && sort_fragments();
    if (!done) {
        report.lacking = editor_.lacking();
        editor_.roll_back();
        report.outcome = report.lacking == CutLimit::none ? CutOutcome::rolled_back : CutOutcome::full;
        return report;
    }
    editor_.commit();
    report.outcome = CutOutcome::cut;
    report.removed_area = state_.area_removed - removed_before;
    return report;
}

}  // namespace fulcrum
