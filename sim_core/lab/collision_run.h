// SPDX-License-Identifier: Apache-2.0
// The reference chain of spheres: a bowel of 12.5 mm radius, a sphere every 4.5 mm, coiled in turns that lie
// on each other and on the wall of a bowl; it is drawn along its line at 50 mm/s and back, a frame every 5
// ms.
//
// With 200 spheres (0.9 m, 3.6 turns) 191 are within 1 mm of the wall and most touch it: nothing is won by
// being far. A frame moves a sphere by 0.22 to 0.25 mm (p10 to p50; 0.31 mm p99), which is the hand's own
// speed in the rod's warm frame. Every recorded place is first brought out of wall and neighbours by twelve
// projections.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/collision/sphere_collision.h"

namespace fulcrum::lab {

struct CollisionRunOptions {
    int spheres = 200;   ///< the bowl and the coil grow with them, so that each has as many neighbours
    int bowl_level = 5;  ///< 20 * 4^level triangles
    bool with_cavity = true;
    int frames = 60;                   ///< recorded one way
    SphereCollisionOptions collision;  ///< capacities for pairs are set to what a coil needs
};

struct CollisionRun {
    static constexpr double spacing = 0.0045, radius = 0.0125;  ///< m

    std::unique_ptr<CavityModel> cavity;
    std::unique_ptr<SphereCollision> collision;
    SphereCollision::Lists lists;
    SphereContacts contacts;
    std::vector<SphereDepth> depths;
    std::vector<std::vector<Vector3>> centres;  ///< of each frame, to and fro
    std::size_t frame = 0;

    const std::vector<Vector3>& now() const { return centres[frame]; }
    void advance() { frame = (frame + 1) % centres.size(); }
};

std::unique_ptr<CollisionRun> make_collision_run(CollisionRunOptions options = {});

}  // namespace fulcrum::lab
