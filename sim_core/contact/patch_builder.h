// SPDX-License-Identifier: Apache-2.0
// World side of the local model: selects the patch of the bowel nearest to a tool by sphere -> its rings ->
// their triangles, and searches it completely for the seed of the dynamic point. No bounding volume hierarchy
// of the deforming surface is ever refitted. World thread; no allocation after construction, no exceptions.
#pragma once

#include <vector>

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/bowel/wide_skin.h"
#include "sim_core/contact/local_model.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum {

struct PatchOptions {
    double radius =
        0.020;  ///< m, vertices within this distance of the patch's centre are taken, nearest first
    double reach = 0.030;  ///< m, a tool further away from the surface gets no patch
    TissueContact contact;
};

/// Contact state reported by the tick, so that the patch stays under the contact.
struct PatchRequest {
    ToolKinematics tool;
    double shaft_radius = 0.0025;      ///< m
    std::int32_t contact_vertex = -1;  ///< surface number, -1 without contact
    /// s for which the model will be in use: a tool so fast that it leaves the reach within this time gets
    /// its patch where its path meets the tube. 0: at its current position.
    double horizon = 0;
};

class PatchBuilder {
  public:
    /// tissue_patches: one per vertex, or empty (all -1). The skin must outlive this.
    PatchBuilder(const BowelSkin& skin, PatchOptions options, std::vector<std::int16_t> tissue_patches = {});

    /// Positions patches by the wider scope from now on; null: by the rows of BowelSkin. `wide` must outlive
    /// this.
    void set_scope(const WideSkin* wide) { wide_ = wide; }
    /// Uses this wall for the contact instead of a constant stiffness; null: the constant stiffness. nodule:
    /// m, height of the nodule under each vertex, or empty. The wall must outlive every model built.
    void set_wall(const LayeredWall* wall, std::vector<double> nodule = {});
    /// Force at which the wall is perforated, N; infinity: never.
    void set_puncture_force(double force) { options_.contact.puncture_force = force; }

    /// Work space of one thread.
    struct Scratch {
        std::vector<std::int32_t> local;  ///< surface vertex -> patch number, -1
        std::vector<std::int32_t> found;  ///< candidate vertices
        std::vector<double> distance;     ///< of the candidates to the centre, squared
        std::vector<Vector3> positions;   ///< of the candidates
        std::vector<std::int32_t> order;
        std::vector<std::int32_t> triangle_local;  ///< surface triangle -> patch number, -1
        /// The last patches that were connected, one for each hand: a tool that rests keeps its vertices, and
        /// their connections are then copied.
        std::vector<SurfacePatch> connected;
        std::size_t oldest = 0;
    };
    Scratch make_scratch() const;

    /// Sets patch and mode (surface, or none if the tool is out of reach). rings: one per ring of the skin,
    /// at model.tick. Does not change step, tick, topology version, grasp and targets.
    void build(const RingMotion* rings, const PatchRequest& request, Scratch& scratch,
               LocalModel& model) const;

    const PatchOptions& options() const { return options_; }
    const BowelSkin& skin() const { return skin_; }
    const std::vector<std::int16_t>& tissue_patches() const { return tissue_patches_; }

  private:
    void look_ahead(const RingMotion* rings, const PatchRequest& request, ToolKinematics& tool) const;
    double nearest_ring(const RingMotion* rings, const ToolKinematics& tool, int& nearest) const;
    /// Finds the triangles and neighbours of the patch's vertices, or copies them.
    void connect(Scratch& scratch, SurfacePatch& patch) const;
    void find_connections(Scratch& scratch, SurfacePatch& patch) const;

    const BowelSkin& skin_;
    PatchOptions options_;
    std::vector<std::int16_t> tissue_patches_;
    const WideSkin* wide_ = nullptr;
    std::vector<double> nodule_;
    std::vector<double> ring_radius_;  ///< m, largest distance of a template vertex
};

/// Divides the surface into patches of `rings_per_patch` rings by `sectors` of the circumference, which
/// identify the place of damage and of repeated contacts; numbers ascend along the bowel. Returns one number
/// per vertex.
std::vector<std::int16_t> divide_into_patches(const BowelSkin& skin, int rings_per_patch, int sectors);
/// Number of patches that divide_into_patches creates.
int patch_count(const BowelSkin& skin, int rings_per_patch, int sectors);

}  // namespace fulcrum
