// SPDX-License-Identifier: Apache-2.0
// The static cavity: its triangles with what closest-point queries need, and FCL's bounding volume hierarchy
// over them, which starts and checks every query (docs/THEORY.md 2). Constant after construction: any thread
// may read.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "sim_core/collision/box_tree.h"
#include "sim_core/collision/triangle_packet.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// On which side of the triangles the bodies live: behind (inside a closed, outward oriented mesh) or in
/// front (on top of a floor whose normals point up).
enum class FreeSide : std::uint8_t { behind, front };

/// Closest point of the cavity to a query point.
struct CavityPoint {
    std::int32_t triangle = -1;          ///< -1: none within reach
    Vector3 position = Vector3::Zero();  ///< m, on the cavity
    Vector3 normal =
        Vector3::Zero();  ///< unit, from the wall to the query point, reversed if that is behind the wall
    double distance = 0;  ///< m, signed: > 0 on the free side
};

/// Triangle a, b, c with its normal towards the free side (zero without area).
struct CavityTriangle {
    Vector3 a = Vector3::Zero(), b = Vector3::Zero(), c = Vector3::Zero();  ///< m
    Vector3 normal = Vector3::Zero();                                       ///< unit
};

/// A packet near a point, and how far the point must move (m, rounded down; < 0: not at all) before a
/// triangle of it concerns the point.
struct ListedPacket {
    std::int32_t packet = -1;
    float sleep = 0;
};

class CavityModel {
  public:
    /// Triangles without area are left out of queries (they keep their numbers). Throws InputError for a mesh
    /// without a usable triangle or with values that are not finite or beyond 1,000 km.
    CavityModel(const TriangleMesh& mesh, FreeSide side);

    const TriangleMesh& mesh() const { return mesh_; }
    const MeshAdjacency& adjacency() const { return adjacency_; }
    const std::vector<CavityTriangle>& triangles() const { return triangles_; }
    /// Area-weighted unit normals of the vertices, towards the free side.
    const std::vector<Vector3>& normals() const { return normals_; }
    FreeSide side() const { return side_; }
    std::size_t bytes() const;

    /// Every packet with a triangle that concerns (TrianglePacket::concern) a point, or another one less than
    /// `margin` m from it, through the hierarchy, in its order. Returns how many there are; only the first
    /// `capacity` are written. boxes: packets whose box is within reach + margin; without one the wall is
    /// further. Rounded to the safe side for points within a metre of a mesh within a metre. Allocates
    /// nothing.
    int list(const Vector3& point, double reach, double margin, ListedPacket* found, int capacity,
             int& boxes) const;

    const TrianglePacket& packet(std::int32_t number) const {
        return packets_[static_cast<std::size_t>(number)];
    }

    /// The second look at a triangle that concerns a point: false where it would only keep a ridge whose
    /// wedge the point is not in.
    bool confirms(const TrianglePacket& packet, int lane, const FloatPoint& at) const {
        constexpr float slack = TrianglePacket::slack;
        if (packet.height(0, lane, at) < slack) return true;
        float beyond = -1e9F;
        for (int edge = 0; edge < 3; ++edge) {
            const float out = packet.height(edge + 1, lane, at);
            beyond = std::max(beyond, out);
            if (packet.wedge[edge][lane] < 0 || out < -slack) continue;
            const std::array<float, 4>& ridge =
                ridges_[static_cast<std::size_t>(3 * packet.triangle[lane] + edge)];
            if (ridge[0] * at.x + ridge[1] * at.y + ridge[2] * at.z - ridge[3] > -slack) return true;
        }
        return beyond < slack;
    }

    /// Exact closest point within reach by branch and bound in FCL's hierarchy. Allocates nothing.
    CavityPoint closest(const Vector3& point, double reach) const;

    /// Closest point on one triangle, signed by the pseudonormal of its feature (Baerentzen and Aanaes 2005).
    CavityPoint closest_on(std::int32_t triangle, const Vector3& point) const;

    /// The same, for a point within sqrt(reach2): false where the triangle is further. local_minimum says
    /// whether the wall around the foot is nowhere nearer: only such feet are contacts of their own.
    bool examine(std::int32_t triangle, const Vector3& point, double reach2, CavityPoint& result,
                 bool& local_minimum) const;

  private:
    static constexpr double sleep_slack = 4e-6;  ///< m, rounding of concern() at two points
    void fill(TrianglePacket& packet, int lane, std::int32_t number);
    CavityPoint sign(std::int32_t triangle, const Vector3& point, const Vector3& foot,
                     TriangleFeature feature) const;

    TriangleMesh mesh_;
    MeshAdjacency adjacency_;
    FreeSide side_ = FreeSide::behind;
    std::vector<CavityTriangle> triangles_;
    std::vector<TrianglePacket> packets_;  ///< the leaves of the hierarchy
    BoxTree boxes_;                        ///< over the packets
    std::vector<std::array<float, 4>>
        ridges_;                    ///< [3 t + e]: plane through a ridge, outward of the triangle beyond
    std::vector<Vector3> normals_;  ///< area-weighted, for display and smooth contact
    std::vector<Vector3> vertex_pseudonormals_;  ///< angle-weighted
    std::vector<Vector3> edge_pseudonormals_;    ///< [3 t + e]
};

}  // namespace fulcrum
