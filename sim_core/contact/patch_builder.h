// SPDX-License-Identifier: Apache-2.0
// World side of the local model: picks the patch of the bowel nearest a tool by sphere -> its rings -> their
// triangles, and searches it fully for the seed of the dynamic point. No bounding volume hierarchy of the
// deforming surface is ever refitted. World thread; nothing allocates after construction, nothing throws.
#pragma once

#include <vector>

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/bowel/wide_skin.h"
#include "sim_core/contact/local_model.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

struct PatchOptions {
    double radius = 0.020;  ///< m, vertices within it of the patch's centre are taken, nearest first
    double reach = 0.030;   ///< m, a tool further than this from the surface gets no patch
    TissueContact contact;
};

/// What the tick reported about its contact, so that the patch stays under it.
struct PatchRequest {
    ToolKinematics tool;
    double shaft_radius = 0.0025;      ///< m
    std::int32_t contact_vertex = -1;  ///< surface number, -1 without contact
    /// s that the model will be in use: a tool so fast that it leaves the reach within them gets its patch
    /// where its way meets the tube. 0: where it is.
    double horizon = 0;
};

class PatchBuilder {
  public:
    /// tissue_patches: one a vertex, or empty (all -1). The skin must outlive this.
    PatchBuilder(const BowelSkin& skin, PatchOptions options, std::vector<std::int16_t> tissue_patches = {});

    /// From now on a patch stands where the wider scope puts it; null: where BowelSkin's rows do. It must
    /// outlive this.
    void set_scope(const WideSkin* wide) { wide_ = wide; }
    /// The contact answers by this wall instead of by a constant stiffness; null: by the stiffness. nodule:
    /// m, height of the nodule under each vertex, or empty. The wall must outlive every model built.
    void set_wall(const LayeredWall* wall, std::vector<double> nodule = {});
    /// N, at which the wall gives way; infinity: never.
    void set_puncture_force(double force) { options_.contact.puncture_force = force; }

    /// Working space of one thread.
    struct Scratch {
        std::vector<std::int32_t> local;  ///< surface vertex -> patch number, -1
        std::vector<std::int32_t> found;  ///< candidate vertices
        std::vector<double> distance;     ///< theirs to the centre, squared
        std::vector<Vector3> positions;   ///< theirs
        std::vector<std::int32_t> order;
        std::vector<std::int32_t> triangle_local;  ///< surface triangle -> patch number, -1
    };
    Scratch make_scratch() const;

    /// Fills patch and mode (surface, or none where the tool is out of reach). rings: one a ring of the skin,
    /// at model.tick. Leaves step, tick, topology version, grasp, targets alone.
    void build(const RingMotion* rings, const PatchRequest& request, Scratch& scratch,
               LocalModel& model) const;

    const PatchOptions& options() const { return options_; }
    const BowelSkin& skin() const { return skin_; }
    const std::vector<std::int16_t>& tissue_patches() const { return tissue_patches_; }

  private:
    void look_ahead(const RingMotion* rings, const PatchRequest& request, ToolKinematics& tool) const;
    double nearest_ring(const RingMotion* rings, const ToolKinematics& tool, int& nearest) const;
    void connect(Scratch& scratch, SurfacePatch& patch) const;

    const BowelSkin& skin_;
    PatchOptions options_;
    std::vector<std::int16_t> tissue_patches_;
    const WideSkin* wide_ = nullptr;
    std::vector<double> nodule_;
    std::vector<double> ring_radius_;  ///< m, largest distance of a template vertex
};

/// Divides the surface into patches of `rings_per_patch` rings by `sectors` of the circumference, for damage
/// and for "the same place again"; numbers rise along the bowel. Returns one number a vertex.
std::vector<std::int16_t> divide_into_patches(const BowelSkin& skin, int rings_per_patch, int sectors);
/// How many numbers divide_into_patches uses.
int patch_count(const BowelSkin& skin, int rings_per_patch, int sectors);

}  // namespace fulcrum
