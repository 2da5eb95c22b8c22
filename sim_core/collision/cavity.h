// SPDX-License-Identifier: Apache-2.0
// The static cavity: its triangles with the data that closest-point queries need, and FCL's bounding volume
// hierarchy over them, in which every query starts (docs/THEORY.md, section 2). Constant after construction:
// any thread may read.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "sim_core/collision/box_tree.h"
#include "sim_core/collision/triangle_packet.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// Side of the triangles on which the bodies are: behind (inside a closed, outward oriented mesh) or in front
/// (on top of a floor whose normals point up).
enum class FreeSide : std::uint8_t { behind, front };

/// Closest point of the cavity to a query point.
struct CavityPoint {
    std::int32_t triangle = -1;          ///< -1: none within reach
    Vector3 position = Vector3::Zero();  ///< m, on the cavity
    Vector3 normal = Vector3::Zero();    ///< unit, from the wall to the query point, reversed if the point is
                                         ///< behind the wall
    double distance = 0;                 ///< m, signed: > 0 on the free side
};

/// Triangle a, b, c with its normal towards the free side (zero if it has no area).
struct CavityTriangle {
    Vector3 a = Vector3::Zero(), b = Vector3::Zero(), c = Vector3::Zero();  ///< m
    Vector3 normal = Vector3::Zero();                                       ///< unit
};

/// A packet near a point, and the distance that the point must move (m, rounded down; < 0: none) before a
/// triangle of it becomes relevant.
struct ListedPacket {
    std::int32_t packet = -1;
    float sleep = 0;
};

class CavityModel {
  public:
    /// Triangles without area are skipped in queries (they keep their numbers). Throws InputError for a mesh
    /// without a usable triangle or with values that are not finite or exceed 1,000 km.
    CavityModel(const TriangleMesh& mesh, FreeSide side);

    const TriangleMesh& mesh() const { return mesh_; }
    const MeshAdjacency& adjacency() const { return adjacency_; }
    const std::vector<CavityTriangle>& triangles() const { return triangles_; }
    /// Area-weighted unit normals of the vertices, towards the free side.
    const std::vector<Vector3>& normals() const { return normals_; }
    FreeSide side() const { return side_; }
    std::size_t bytes() const;

    /// Through the hierarchy and in its order: every packet with a triangle that is relevant
    /// (TrianglePacket::concern) to the point or to any point less than `margin` m from it. Returns their
    /// number; only the first `capacity` are written. boxes: packets whose box is within reach + margin;
    /// without one the wall is further away. Rounded conservatively for points within a metre of a mesh
    /// smaller than a metre. Does not allocate.
    int list(const Vector3& point, double reach, double margin, ListedPacket* found, int capacity,
             int& boxes) const;

    const TrianglePacket& packet(std::int32_t number) const {
        return packets_[static_cast<std::size_t>(number)];
    }

    /// Second test of a triangle that passed concern(): false if it would only report a ridge and the point
    /// is not in the wedge of that ridge.
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

    /// Exact closest point within reach by branch and bound in FCL's hierarchy. Does not allocate.
    CavityPoint closest(const Vector3& point, double reach) const;

    /// Closest point on one triangle, signed by the pseudonormal of its feature (Baerentzen and Aanaes 2005).
    CavityPoint closest_on(std::int32_t triangle, const Vector3& point) const;

    /// Closest point for a point within sqrt(reach2); false if the triangle is further away. local_minimum:
    /// true if no part of the wall around the foot is nearer; only such feet count as separate contacts.
    bool examine(std::int32_t triangle, const Vector3& point, double reach2, CavityPoint& result,
                 bool& local_minimum) const;

  private:
    static constexpr double sleep_slack = 4e-6;  ///< m, rounding error of concern() at two points
    void fill(TrianglePacket& packet, int lane, std::int32_t number);
    CavityPoint sign(std::int32_t triangle, const Vector3& point, const Vector3& foot,
                     TriangleFeature feature) const;

    TriangleMesh mesh_;
    MeshAdjacency adjacency_;
    FreeSide side_ = FreeSide::behind;
    std::vector<CavityTriangle> triangles_;
    std::vector<TrianglePacket> packets_;  ///< leaves of the hierarchy
    BoxTree boxes_;                        ///< over the packets
    std::vector<std::array<float, 4>>
        ridges_;                    ///< [3 t + e]: plane through a ridge, pointing out of the neighbour
    std::vector<Vector3> normals_;  ///< area-weighted, for display and smooth contact
    std::vector<Vector3> vertex_pseudonormals_;  ///< angle-weighted
    std::vector<Vector3> edge_pseudonormals_;    ///< [3 t + e]
};

}  // namespace fulcrum
