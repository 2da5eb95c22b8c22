// SPDX-License-Identifier: Apache-2.0
// The bowel's surface bound to its cage: a constant model, and functions that evaluate it for given ring
// frames. Any thread may read a BowelSkin at any time. Lengths in m; frames and results in the patient frame.
#pragma once

#include <vector>

#include "sim_core/bowel/cage.h"
#include "sim_core/bowel/ring_windows.h"
#include "sim_core/bowel/skin.h"
#include "sim_core/geometry/mesh.h"

namespace fulcrum {

/// Binds single points of the rest pose to the rings; the cage must outlive it. Not thread safe: owns
/// scratch.
class SkinBinder {
  public:
    explicit SkinBinder(const Cage& cage);
    /// Gap between two rings that contains a rest point.
    int gap_of(const Vector3& point) const;
    /// Row of a point in that gap: local mean value coordinates, blended windows, k = 1.
    SkinRow bind(int gap, const Vector3& point);

  private:
    const Cage* cage_;
    RingWindows windows_;
    WindowWeights weights_;
};

/// Built once when a scene loads; vertices and triangles keep the numbers of the given mesh. For drawing see
/// display_skin.h.
class BowelSkin {
  public:
    /// Binds the surface with local mean value coordinates in blended windows (k = 1). Throws InputError as
    /// build_cage does.
    BowelSkin(TriangleMesh surface, Cage cage);

    const TriangleMesh& rest() const { return rest_; }
    const MeshAdjacency& adjacency() const { return adjacency_; }
    const Cage& cage() const { return cage_; }
    int rings() const { return cage_.rings(); }
    int vertices() const { return static_cast<int>(rows_.size()); }
    const std::vector<SkinRow>& rows() const { return rows_; }
    /// Rest normals, area-weighted, unit.
    const std::vector<Vector3>& rest_normals() const { return rest_normals_; }
    /// Rest area of each vertex, m2: a third of the triangles around it.
    const std::vector<double>& vertex_areas() const { return vertex_areas_; }
    /// Vertices whose row begins at ring r: by_ring()[by_ring_offsets()[r] .. by_ring_offsets()[r + 1]).
    const std::vector<std::int32_t>& by_ring() const { return by_ring_; }
    const std::vector<std::int32_t>& by_ring_offsets() const { return by_ring_offsets_; }
    std::size_t bytes() const;

  private:
    TriangleMesh rest_;
    MeshAdjacency adjacency_;
    Cage cage_;
    std::vector<SkinRow> rows_;
    std::vector<Vector3> rest_normals_;
    std::vector<double> vertex_areas_;
    std::vector<std::int32_t> by_ring_, by_ring_offsets_;
};

/// Positions of all vertices in double precision. positions: one per vertex.
void skin_all(const BowelSkin& skin, const RingFrame* frames, Vector3* positions);

/// Velocity of a row's vertex under moving rings, m/s.
Vector3 skin_velocity(const SkinRow& row, const RingMotion* rings);

/// Force and moment about a ring's position, patient frame.
struct RingWrench {
    Vector3 force = Vector3::Zero();   ///< N
    Vector3 moment = Vector3::Zero();  ///< N m
};

/// Adds the action of a force on a row's vertex to its rings, by virtual work (transposed skinning): the
/// power of the force on the moving vertex equals that of the wrenches on the moving rings. wrenches is
/// indexed by ring.
void add_ring_wrenches(const SkinRow& row, const RingFrame* frames, const Vector3& force,
                       RingWrench* wrenches);

}  // namespace fulcrum
