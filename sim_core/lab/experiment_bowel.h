// SPDX-License-Identifier: Apache-2.0
// A complete bowel in free space for experiments: rod, spheres, cage, surface, collision with a floor and
// with itself.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/collision/sphere_collision.h"
#include "sim_core/lab/experiment.h"
#include "sim_core/lab/reference_skin.h"
#include "sim_core/rod/rod.h"

namespace fulcrum::lab {

struct ExperimentBowelSpec {
    double length = 0.9, radius = 0.015;  ///< m
    double sphere_spacing = 0.015;        ///< m
    int segments = 90;
    int sections = 260, around = 40;  ///< of the surface
    RodEnd ends[2] = {RodEnd::free, RodEnd::free};
    bool floor = false;  ///< floor at z = 0, bodies above it
};

class ExperimentBowel {
  public:
    explicit ExperimentBowel(const ExperimentBowelSpec& spec);
    Rod& rod() { return *rod_; }
    RodState& state() { return state_; }
    RodInputs& inputs() { return inputs_; }
    RodScratch& scratch() { return scratch_; }
    const BowelSkin& skin() const { return *skin_; }

    /// One implicit Euler step with the contacts found at its start.
    RodReport step(double dt);
    /// m, deepest overlap of spheres, and into the floor, at the present centre line.
    double self_overlap();
    double floor_overlap();

    ExperimentMesh surface() const;
    ExperimentMesh cage() const;
    std::vector<ExperimentMesh> spheres() const;
    std::vector<RingFrame> frames() const;

  private:
    void find_contacts();
    ExperimentBowelSpec spec_;
    std::unique_ptr<Rod> rod_;
    SphereChain chain_;
    std::unique_ptr<BowelSkin> skin_;
    std::unique_ptr<CavityModel> floor_;
    std::unique_ptr<SphereCollision> collision_;
    SphereCollision::Lists lists_;
    SphereContacts contacts_;
    std::vector<Vector3> centres_;
    RodState state_;
    RodInputs inputs_;
    RodScratch scratch_;
};

/// Ball of that radius, for spheres and marks.
TriangleMesh make_ball(const Vector3& centre, double radius, int bands = 12);
/// Box from one end to the other with that width and depth, for instruments.
TriangleMesh make_bar(const Vector3& from, const Vector3& to, double width);
/// Square of the plane z = 0, side 2 * half, facing up.
TriangleMesh make_floor(double half);

}  // namespace fulcrum::lab
