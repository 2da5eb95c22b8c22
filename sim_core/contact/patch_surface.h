// SPDX-License-Identifier: Apache-2.0
// A patch of the bowel as the walk wants it: vertices are skinned, and normals made, the first time they are
// asked for in a tick. Haptic thread (and the world's, for jaws): no allocation.
#pragma once

#include "sim_core/contact/local_model.h"
#include "sim_core/contact/tool_contact.h"

namespace fulcrum {

class PatchSurface {
  public:
    /// Moves the rings on by `seconds` of their velocity and forgets all positions.
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
    /// Makes sure that the positions of a vertex and of its first two rings are there.
    void skin_neighbourhood(std::int32_t vertex);
    /// The patch as a view; only positions asked for before are valid.
    SurfaceView view() const;

  private:
    const SurfacePatch& patch_;
    ToolContactScratch& scratch_;
};

/// The static wall as the walk wants it.
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
