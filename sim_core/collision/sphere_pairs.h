// SPDX-License-Identifier: Apache-2.0
// Self-collision of the sphere chain: which spheres touch or nearly touch, with coherence between steps.
//
// Spheres are grouped in eights along the chain, each group with a bounding box. A row is one sphere against
// one group. Rows that could touch before a sphere has moved by the margin are listed, each with the gap that
// the motion has to close first, and a step tests only the rows that the motion could have closed. Pairs
// nearer along the rest line than rest_exclusion radii are skipped. The result and its order do not depend on
// the history of the list. Model (const) / state; no allocation after construction, no exceptions: world
// thread.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/numerics/types.h"

namespace fulcrum {

/// Contact of spheres first < second; normal from second to first.
struct SphereContact {
    std::int32_t first = -1, second = -1;
    Vector3 normal = Vector3::Zero();
    double gap = 0;  ///< m
};

class SpherePairs {
  public:
    static constexpr int width = 8;

    /// m; arc_lengths ascending. margin: motion before the rows are listed again.
    SpherePairs(const std::vector<double>& arc_lengths, const std::vector<double>& radii,
                double rest_exclusion, double margin, double contact_margin, int row_capacity);

    /// One sphere against one group of eight.
    struct Row {
        std::int32_t sphere = -1, eight = -1;
        std::uint32_t lanes = 0;  ///< lanes that may touch at all
        float gap = 0;            ///< m, smallest gap when listed, rounded down
    };
    /// The lists: a cache, not part of the world's state.
    struct Lists {
        std::vector<float> x, y, z;  ///< m, current position of each sphere; padded to a multiple of eight
        std::vector<float> low[3], high[3];         ///< m, box of each group when listed
        std::vector<Vector3> listed_at;             ///< m
        std::vector<Row> rows;                      ///< by sphere, then by group
        std::int32_t count = -1;                    ///< rows listed; -1: never
        bool overflow = false;                      ///< row_capacity too small: pairs were dropped
        std::uint64_t rows_seen = 0, listings = 0;  ///< so far, for operation counts

        template <typename Visit>
        void fields(Visit&& visit) {
            visit(x, y, z, low, high, listed_at, rows, count, overflow, rows_seen, listings);
        }
    };
    Lists make_lists() const;
    std::size_t bytes() const;

    /// Writes every pair with a gap below contact_margin, ascending by first, then by second. Returns their
    /// number; only the first `capacity` are written. deepest: m, >= 0. Centres that are not finite are
    /// skipped.
    int find(const Vector3* centres, Lists& lists, SphereContact* found, int capacity, double& deepest) const;

  private:
    void list(const Vector3* centres, Lists& lists) const;
    int spheres() const { return static_cast<int>(radii_.size()); }
    int eights() const { return (spheres() + width - 1) / width; }
    bool excluded(int a, int b) const;

    std::vector<double> arc_lengths_, radii_;
    std::vector<float> radius_;  ///< m, padded to a multiple of eight, rounded up
    double rest_exclusion_ = 0, margin_ = 0, contact_margin_ = 0, largest_radius_ = 0;
    int row_capacity_ = 0;
};

}  // namespace fulcrum
