// SPDX-License-Identifier: Apache-2.0
// The wall of the body that instruments feel and the bowel lies on: the cavity, or the presacral fascia.
#pragma once

#include <cstdint>
#include <memory>

#include "sim_core/world/part/part.h"

namespace fulcrum {

class WallPart : public Part {
  public:
    WallPart(const TriangleMesh& mesh, FreeSide side) : model_(mesh, side) {}
    const CavityModel* wall() const noexcept override { return &model_; }
    void add_costs(double us, std::vector<PartCost>& costs) const override;

  private:
    CavityModel model_;
};

std::unique_ptr<Part> build_wall_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
