// SPDX-License-Identifier: Apache-2.0
// The static cavity: its triangles with what closest-point queries need, and FCL's bounding volume hierarchy
// over them, which starts and checks every query (theory, section 2). Constant after construction: any thread
// may read.
#pragma once

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

/// A triangle near a point, how near, and a ball around it for quick rejection. Rounded so that nothing near
/// is missed.
struct ListedTriangle {
    std::int32_t triangle = -1;
    float distance = 0;           ///< m, rounded down
    float centre[3] = {0, 0, 0};  ///< m
    float radius = 0;             ///< m, rounded up
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

    /// Every triangle within `reach` of a point, through FCL's hierarchy, in the order of the hierarchy.
    /// Returns how many there are; only the first `capacity` are written. Allocates nothing.
    int list(const Vector3& point, double reach, ListedTriangle* found, int capacity) const;

    /// Exact closest point within reach by branch and bound in FCL's hierarchy. Allocates nothing.
    CavityPoint closest(const Vector3& point, double reach) const;

    /// Closest point on one triangle, signed by the pseudonormal of its feature (Baerentzen and Aanaes 2005).
    CavityPoint closest_on(std::int32_t triangle, const Vector3& point) const;

    /// The same, for a point within sqrt(reach2): false where the triangle is further. local_minimum says
    /// whether the wall around the foot is nowhere nearer: only such feet are contacts of their own.
    bool examine(std::int32_t triangle, const Vector3& point, double reach2, CavityPoint& result,
                 bool& local_minimum) const;

  private:
    struct Hierarchy;
    CavityPoint sign(std::int32_t triangle, const Vector3& point, const Vector3& foot,
                     TriangleFeature feature) const;

    TriangleMesh mesh_;
    MeshAdjacency adjacency_;
    FreeSide side_ = FreeSide::behind;
    std::vector<CavityTriangle> triangles_;
    std::vector<Vector3> normals_;               ///< area-weighted, for display and smooth contact
    std::vector<Vector3> vertex_pseudonormals_;  ///< angle-weighted
    std::vector<Vector3> edge_pseudonormals_;    ///< [3 t + e]
    std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace fulcrum
