// SPDX-License-Identifier: Apache-2.0
// The static cavity: its triangles with what closest-point queries need, and FCL's bounding volume hierarchy
// over them, which starts and checks every query (theory, section 2). Constant after construction: any thread
// may read.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

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

inline constexpr int cluster_size = 8;

/// Up to eight triangles that lie together, a small subtree of FCL's hierarchy: what a sphere lists. For each
/// triangle four planes in single precision, side by side so that one instruction serves eight: its own, and
/// one through each edge, outward and upright on it.
struct alignas(32) TriangleCluster {
    float x[4][cluster_size], y[4][cluster_size], z[4][cluster_size], offset[4][cluster_size];
    /// Of each edge that keeps feet on it: the sine of the ridge's angle, so that the wedge in which feet
    /// fall on it is at most distance times it wide (a rim: 1e9); -1e9 where the triangle beyond has such
    /// feet.
    float wedge[3][cluster_size];
    std::int32_t triangle[cluster_size];
    float low[4], high[4];  ///< m, rounded outward; the fourth number is 0
    std::int32_t count;
};

/// A cluster near a point, and how near.
struct ListedCluster {
    std::int32_t cluster = -1;
    float distance = 0;  ///< m, to its box, rounded down
};

class CavityModel {
  public:
    /// Triangles without area are left out of queries (they keep their numbers). Throws InputError for a mesh
    /// without a usable triangle or with values that are not finite.
    CavityModel(const TriangleMesh& mesh, FreeSide side);
    ~CavityModel();
    CavityModel(CavityModel&&) noexcept;
    CavityModel& operator=(CavityModel&&) noexcept;

    const TriangleMesh& mesh() const { return mesh_; }
    const MeshAdjacency& adjacency() const { return adjacency_; }
    const std::vector<CavityTriangle>& triangles() const { return triangles_; }
    /// Area-weighted unit normals of the vertices, towards the free side.
    const std::vector<Vector3>& normals() const { return normals_; }
    FreeSide side() const { return side_; }
    std::size_t bytes() const;

    /// Every cluster whose box is within `reach` of a point, through FCL's hierarchy, in its order. Returns
    /// how many there are; only the first `capacity` are written. Allocates nothing.
    int list(const Vector3& point, double reach, ListedCluster* found, int capacity) const;
    const TriangleCluster& cluster(std::int32_t number) const {
        return clusters_[static_cast<std::size_t>(number)];
    }

    /// Whether a point must be held against some of a cluster's triangles, and which: those with concern < 0.
    /// A triangle is left out only where its foot of the point is further than reach, or is the foot of a
    /// neighbour that is at least as near: across an edge that is flat or a valley as seen from the free side
    /// the triangle beyond is nearer; on a ridge the lower number answers for both. Points behind a
    /// triangle's plane always concern it. Rounded to the safe side for coordinates below 1 m. point: x, y,
    /// z, 0.
    static bool concerns(const TriangleCluster& cluster, const float (&point)[4], float reach,
                         float (&concern)[cluster_size]) {
        using Eight = Eigen::Array<float, cluster_size, 1>;
        using Four = Eigen::Array<float, 4, 1>;
        const Eigen::Map<const Four> at(point), low(cluster.low), high(cluster.high);
        const Four outside = (low - at).max(at - high).max(0.0F);
        const float far = reach + plane_slack;
        if (outside.square().sum() > far * far) return false;
        Eight height[4];
        for (int plane = 0; plane < 4; ++plane) {
            const Eigen::Map<const Eight, Eigen::Aligned32> x(cluster.x[plane]), y(cluster.y[plane]),
                z(cluster.z[plane]), offset(cluster.offset[plane]);
            height[plane] = x * point[0] + y * point[1] + z * point[2] - offset;
        }
        Eight passed = height[1].max(height[2]).max(height[3]), kept = Eight::Constant(-1e9F);
        for (int edge = 0; edge < 3; ++edge) {
            const Eigen::Map<const Eight, Eigen::Aligned32> wedge(cluster.wedge[edge]);
            kept = kept.max(height[edge + 1].min(far * wedge - height[edge + 1]));
        }
        // Somebody else's: in front, beyond an edge, and in no wedge that this triangle keeps.
        const Eight front = height[0].min(passed).min(-kept);
        const Eight worst = (height[0].abs() - far).max(front - plane_slack);
        Eigen::Map<Eight>{concern} = worst;
        return worst.minCoeff() < 0;
    }

    /// The second look at one triangle that concerns() named: false where it would only keep a ridge whose
    /// wedge the point is not in.
    bool confirms(const TriangleCluster& cluster, int k, const float (&point)[4]) const {
        const auto height = [&](int plane) {
            return cluster.x[plane][k] * point[0] + cluster.y[plane][k] * point[1] +
                   cluster.z[plane][k] * point[2] - cluster.offset[plane][k];
        };
        if (height(0) < plane_slack) return true;
        float beyond = -1e9F;
        for (int edge = 0; edge < 3; ++edge) {
            const float out = height(edge + 1);
            beyond = std::max(beyond, out);
            if (cluster.wedge[edge][k] < 0 || out < -plane_slack) continue;
            const std::array<float, 4>& ridge =
                ridges_[static_cast<std::size_t>(3 * cluster.triangle[k] + edge)];
            if (ridge[0] * point[0] + ridge[1] * point[1] + ridge[2] * point[2] - ridge[3] > -plane_slack)
                return true;
        }
        return beyond < plane_slack;
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
    static constexpr float plane_slack = 2e-6F;  ///< m
    struct Hierarchy;
    void fill_cluster(TriangleCluster& cluster);
    CavityPoint sign(std::int32_t triangle, const Vector3& point, const Vector3& foot,
                     TriangleFeature feature) const;

    TriangleMesh mesh_;
    MeshAdjacency adjacency_;
    FreeSide side_ = FreeSide::behind;
    std::vector<CavityTriangle> triangles_;
    std::vector<TriangleCluster> clusters_;
    std::vector<std::array<float, 4>>
        ridges_;                    ///< [3 t + e]: plane through a ridge, outward of the triangle beyond
    std::vector<Vector3> normals_;  ///< area-weighted, for display and smooth contact
    std::vector<Vector3> vertex_pseudonormals_;  ///< angle-weighted
    std::vector<Vector3> edge_pseudonormals_;    ///< [3 t + e]
    std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace fulcrum
