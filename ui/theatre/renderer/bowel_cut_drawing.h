// SPDX-License-Identifier: GPL-3.0-or-later
// A cut bowel to be drawn: which of its triangles are no longer whole, and what is left of those, with the
// thickness of the wall and its layers along every rim. What is left lies in the triangle it is a part of, so
// it takes place, normal and texture from that triangle's corners as they are drawn: no seam next to it.
#pragma once

#include <vector>

#include "sim_core/bowel/bowel_skin.h"
#include "sim_core/world/part/snapshot.h"
#include "ui/theatre/renderer/scene_renderer.h"
#include "ui/theatre/renderer/surface_mesh.h"

namespace fulcrum::ui {

class BowelCutDrawing {
  public:
    /// The skin must outlive this. domes: as make_bowel_surface.
    BowelCutDrawing(const BowelSkin& skin, bool domes);
    /// Adds to a frame that has the bowel's positions and normals; nothing where all of the skin is whole.
    /// What it adds points into this object and the view until the next call.
    void add(const BowelCutView& view, SceneFrame& frame);

  private:
    struct Corner {
        Vector3 position, normal, coordinates;
    };
    Corner corner_of_root(const SceneFrame& frame, std::int32_t root, std::size_t corner) const;
    Corner corner_of(const BowelCutView& view, const SceneFrame& frame, std::int32_t vertex,
                     std::int32_t root) const;
    std::int32_t add_vertex(const Corner& corner, std::int32_t place);
    void add_neighbours(const SceneFrame& frame, std::int32_t root);

    const BowelSkin& skin_;
    SurfaceMesh surface_;  // for its coordinates, split at the texture's seam
    std::vector<Vector3> positions_, normals_, coordinates_;
    std::vector<std::int32_t> places_;
    std::vector<Triangle> triangles_;
    std::vector<SheetEdge> beside_;
};

}  // namespace fulcrum::ui
