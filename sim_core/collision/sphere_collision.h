// SPDX-License-Identifier: Apache-2.0
// Collision of the sphere chain with the cavity and with itself, by projection (Pan et al. 2011, Fig. 9;
// docs/THEORY.md, section 2).
//
// Projection finds the contacts, the rod's solve keeps them. Each contact is the plane of a unilateral
// constraint
//     g = n . (c - p) - rho >= 0            (cavity)
//     g = n . (c_i - c_j) - (rho_i + rho_j) >= 0   (spheres of the chain)
// Coherence: each sphere keeps a list of all triangles that could hold its closest point or a contact before
// it has moved by m. Each entry has the motion below which it cannot matter (the plane distances change by at
// most the sphere's motion), so a step looks only at the entries that the motion since listing has woken.
// While the sphere has moved less than m the list is complete, and closest point and all contact patches are
// exact. Otherwise it is listed again from FCL's hierarchy. Some spheres are relisted early in each step, so
// that a chain that moves as a rigid body is not relisted in one step. Pairs of spheres work likewise. The
// result does not depend on the history of the lists. Model (const) / state / result; no allocation after
// construction, no exceptions: world thread.
#pragma once

#include <vector>

#include "sim_core/collision/cavity.h"
#include "sim_core/collision/sphere_pairs.h"

namespace fulcrum {

struct SphereCollisionOptions {
    double list_margin =
        0.003;  ///< m of motion before a sphere is listed again; at most half the smallest radius
    double contact_margin =
        0.001;  ///< m: planes with a gap below it are reported, so that the solve can anticipate them
    double distinct_cosine =
        0.94;  ///< two patches are one where their normals' cosine is above this (20 degrees)
    double rest_exclusion =
        3.141592653589793;  ///< pairs closer than this many radii along the rest line are left out
    int projection_iterations = 3;
    int list_capacity =
        512;  ///< packets of triangles per sphere; beyond it the least urgent wait for the next
    int planes_per_sphere = 6;     ///< cavity planes per sphere
    int pair_capacity = 512;       ///< pairs of spheres in contact
    int near_row_capacity = 2048;  ///< rows of one sphere against eight near ones (SpherePairs)
};

/// The chain: rest arc lengths (ascending) and radii, m.
struct SphereChainShape {
    std::vector<double> arc_lengths, radii;
};

/// Cavity contact of a sphere.
struct CavityContact {
    std::int32_t sphere = -1, triangle = -1;
    Vector3 normal = Vector3::Zero();  ///< unit, towards the free side
    Vector3 point = Vector3::Zero();   ///< m, on the wall
    double gap = 0;                    ///< m at the centre given, < 0 penetrating
};

/// Result of a query. Vectors have their full capacity from the start; the counts give the valid part.
struct SphereContacts {
    std::vector<CavityContact> cavity;
    std::vector<SphereContact> pairs;
    int cavity_count = 0, pair_count = 0;
    double deepest_cavity = 0;    ///< m, deepest penetration of the wall, >= 0, at the given centres
    double deepest_pair = 0;      ///< m, of spheres, >= 0
    double residual_cavity = 0;   ///< m, deepest after the projection iterations, >= 0
    double residual_pair = 0;     ///< m
    int relisted = 0;             ///< spheres listed again
    bool list_overflow = false;   ///< list_capacity too small at this pose: those spheres queried the
                                  ///< hierarchy (exact but slow)
    bool plane_overflow = false;  ///< planes_per_sphere too small: the shallowest were dropped
    bool pair_overflow = false;   ///< pair_capacity or near_row_capacity too small: pairs were dropped

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(cavity, pairs, cavity_count, pair_count, deepest_cavity, deepest_pair, residual_cavity,
              residual_pair, relisted, list_overflow, plane_overflow, pair_overflow);
    }
};

/// Signed closest point of one sphere; triangle -1 if the wall is further away than rho + contact_margin.
struct SphereDepth {
    CavityPoint closest;
    double depth = 0;  ///< m, rho - signed distance; <= 0 if separated
};

/// Operation counts so far, for size sweeps.
struct CollisionCounts {
    std::uint64_t packets = 0;    ///< of eight triangles, tested by steps
    std::uint64_t triangles = 0;  ///< measured exactly
    std::uint64_t listed = 0;     ///< packets tested by listings
};

class SphereCollision {
  public:
    /// cavity may be null (self-collision only) and must outlive this. Throws InputError if arc lengths and
    /// radii differ in number or are not finite and positive.
    SphereCollision(const CavityModel* cavity, SphereChainShape chain, SphereCollisionOptions options = {});

    int spheres() const { return static_cast<int>(chain_.radii.size()); }
    const SphereCollisionOptions& options() const { return options_; }
    SphereContacts make_contacts() const;
    std::size_t bytes() const;

    /// The lists: a cache, not part of the world's state.
    struct Lists {
        std::vector<std::int32_t> packets;  ///< [sphere * list_capacity + k], in bands of sleep distance
        std::vector<std::int32_t>
            band_ends;                     ///< [sphere * bands + b]: end of the packets that wake in band b
        std::vector<double> band;          ///< m, of each sphere: width of a band
        std::vector<ListedPacket> direct;  ///< work space of a listing
        std::vector<std::int32_t> counts;  ///< per sphere: packets listed; < 0: query the hierarchy
        std::vector<Vector3> listed_at;    ///< m
        std::vector<Vector3> last_at;      ///< m, at the previous call
        std::vector<double> free_motion;   ///< m the sphere may move before it is listed again
        SpherePairs::Lists pairs;
        CollisionCounts counts_so_far;
        std::vector<Vector3> projected;   ///< centres during and after projection
        std::vector<std::uint8_t> moved;  ///< per sphere: 1 if the last projection moved it
        std::vector<double> depth;        ///< m, penetration of each sphere in the wall
        std::int32_t turn = 0;            ///< sphere whose early listing is next

        template <typename Visit>
        void fields(Visit&& visit) {
            visit(packets, band_ends, band, direct, counts, listed_at, last_at, free_motion, pairs,
                  counts_so_far, projected, moved, depth, turn);
        }
    };
    Lists make_lists() const;

    /// Contacts at the given centres (one per sphere), plus those encountered during projection; ordered by
    /// sphere. Projected centres are stored in lists.projected. A centre that is not finite or further away
    /// than 1,000 km is skipped.
    void collide(const Vector3* centres, Lists& lists, SphereContacts& contacts) const;

    /// Cavity only, centres as given, no projection: closest point and depth of each sphere (results: one per
    /// sphere). Returns the number of spheres listed again.
    int depths(const Vector3* centres, Lists& lists, SphereDepth* results) const;

    /// The chain against itself only, centres as given, no projection: sets pairs, pair_count, pair_overflow
    /// and deepest_pair.
    void touching_pairs(const Vector3* centres, Lists& lists, SphereContacts& contacts) const;

  private:
    static constexpr std::int32_t never_listed = -1, overflowed = -2, behind_wall = -3;
    static constexpr int candidate_capacity = 64, bands = 16;
    struct Candidates {
        CavityPoint points[candidate_capacity];  ///< distinct patches, nearest first
        int count = 0;
        bool overflow = false;
    };
    bool refresh(int sphere, const Vector3& centre, Lists& lists, double good_for = 1.0) const;
    int refresh_early(const Vector3* centres, Lists& lists) const;
    void bin(int sphere, int count, Lists& lists) const;
    void gather(int sphere, const Vector3& centre, Lists& lists, bool only_nearest, Candidates& found) const;
    void keep_distinct(Candidates& found) const;
    void add_planes(int sphere, const Vector3& start, const Candidates& found, bool only_new,
                    SphereContacts& contacts) const;
    void project(Lists& lists, SphereContacts& contacts, const Vector3* centres) const;

    const CavityModel* cavity_ = nullptr;
    SphereChainShape chain_;
    SphereCollisionOptions options_;
    SpherePairs pairs_;
};

}  // namespace fulcrum
