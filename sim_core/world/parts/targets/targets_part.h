// SPDX-License-Identifier: Apache-2.0
// Rigid spheres to touch (task A2). They neither move nor change: model only.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim_core/world/part/part.h"

namespace fulcrum {

class TargetsPart : public Part {
  public:
    /// The scene lists targets. Throws InputError where they are more than the local model holds.
    TargetsPart(const Scene& scene, std::uint64_t seed);
    void publish_model(int hand, const TickOutput& last, LocalModel& model) noexcept override;
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void add_costs(double us, std::vector<PartCost>& costs) const override;

  private:
    std::vector<TargetSphere> spheres_;
    std::vector<TargetModel> models_;
};

std::unique_ptr<Part> build_targets_part(const Scene& scene, std::uint64_t seed, const PartList& parts);

}  // namespace fulcrum
