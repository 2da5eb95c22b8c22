// SPDX-License-Identifier: Apache-2.0
// A patch of the bowel in the form that the surface walk needs: vertices are skinned and normals computed the
// first time they are needed in a tick. Haptic thread (and world thread, for jaws): no allocation.
#pragma once

#include "sim_core/contact/local_model.h"
#include "sim_core/contact/tool_contact.h"

namespace fulcrum {

class PatchSurface {
  public:
    /// Extrapolates the rings by `seconds` of their velocity and invalidates all positions.
    PatchSurface(const SurfacePatch& patch, double seconds, ToolContactScratch& scratch);

    const Triangle& corner(std::int32_t triangle) const {
        return patch_.triangles[static_cast<std::size_t>(triangle)];
    }
    std::int32_t neighbour(std::int32_t triangle, int edge) const {
        return patch_.triangle_neighbours[static_cast<std::size_t>(3 * triangle + edge)];
    }
    const Vector3& position(std::int32_t vertex);
    const Vector3& normal(std::int32_t vertex);
    /// Velocity of a vertex with its rings, m/s.
    Vector3 velocity(std::int32_t vertex) const;
    /// Computes the positions of a vertex and of its first two rings if they are missing.
    void skin_neighbourhood(std::int32_t vertex);
    /// The patch as a view; only positions computed before are valid.
    SurfaceView view() const;

  private:
    const SurfacePatch& patch_;
    ToolContactScratch& scratch_;
};

/// The static wall in the form that the surface walk needs.
class WallSurface {
  public:
    explicit WallSurface(const CavityModel& cavity) : cavity_(cavity) {}
    const Triangle& corner(std::int32_t triangle) const {
        return cavity_.mesh().triangles[static_cast<std::size_t>(triangle)];
    }
    std::int32_t neighbour(std::int32_t triangle, int edge) const {
        return cavity_.adjacency().triangle_neighbours[static_cast<std::size_t>(3 * triangle + edge)];
    }
    const Vector3& position(std::int32_t vertex) const {
        return cavity_.mesh().vertices[static_cast<std::size_t>(vertex)];
    }
    const Vector3& normal(std::int32_t vertex) const {
        return cavity_.normals()[static_cast<std::size_t>(vertex)];
    }

  private:
    const CavityModel& cavity_;
};

}  // namespace fulcrum
