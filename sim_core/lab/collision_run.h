// SPDX-License-Identifier: Apache-2.0
// The reference chain of spheres: a bowel of 12.5 mm radius, a sphere every 4.5 mm, coiled in turns that
// touch each other and the wall of a bowl. It is drawn along its line at 50 mm/s and back, one frame every 5
// ms.
//
// With 200 spheres (0.9 m, 3.6 turns) 191 are within 1 mm of the wall and most touch it, so no sphere can be
// skipped for being far away. A frame moves a sphere by 0.22 to 0.25 mm (p10 to p50; 0.31 mm p99), the hand's
// speed in the rod's warm frame. Every recorded pose is first freed from wall and neighbours by twelve
// projections.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/collision/sphere_collision.h"

namespace fulcrum::lab {

struct CollisionRunOptions {
    int spheres = 200;  ///< the bowl and the coil grow with them, so that each keeps its number of neighbours
    int bowl_level = 5;  ///< 20 * 4^level triangles
    bool with_cavity = true;
    int frames = 60;                   ///< recorded in one direction
    SphereCollisionOptions collision;  ///< capacities for pairs are set for the coil
};

struct CollisionRun {
    static constexpr double spacing = 0.0045, radius = 0.0125;  ///< m

    std::unique_ptr<CavityModel> cavity;
    std::unique_ptr<SphereCollision> collision;
    SphereCollision::Lists lists;
    SphereContacts contacts;
    std::vector<SphereDepth> depths;
    std::vector<std::vector<Vector3>> centres;  ///< of each frame, forward and back
    std::size_t frame = 0;

    const std::vector<Vector3>& now() const { return centres[frame]; }
    void advance() { frame = (frame + 1) % centres.size(); }
};

std::unique_ptr<CollisionRun> make_collision_run(CollisionRunOptions options = {});

}  // namespace fulcrum::lab
