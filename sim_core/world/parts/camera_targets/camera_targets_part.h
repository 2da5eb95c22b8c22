// SPDX-License-Identifier: Apache-2.0
// Cups to look into, a tip to follow, and what the lens touches of them (task A1). State: the time that the
// tip has moved, and whether the lens touches.
#pragma once

#include <memory>
#include <vector>

#include "sim_core/world/part/part.h"
#include "sim_core/world/part/step_events.h"
#include "sim_core/world/parts/camera_targets/camera_targets_layout.h"

namespace fulcrum {

class CameraTargetsPart : public Part {
  public:
    /// The scene has camera targets and a camera. Throws InputError where the cups do not fit.
    CameraTargetsPart(const Scene& scene, std::uint64_t seed);
    void begin_step() noexcept override { events_.clear(); }
    void apply(const StepInput& input) noexcept override;
    void size_snapshot(WorldSnapshot& snapshot) const override;
    void fill_snapshot(WorldSnapshot& snapshot) const noexcept override;
    void list_state(StateList& list) override;
    void add_costs(double us, std::vector<PartCost>& costs) const override;

  private:
    /// m, from the lens to the nearest cup or the tip.
    double lens_distance(const Vector3& lens) const noexcept;

    CameraTargetsSpec spec_;
    ScopeModel scope_;
    TipPath path_;
    std::vector<CameraTarget> cups_;
    int tissue_ = -1;
    double time_ = 0;  ///< s
    std::uint8_t touching_ = 0;
    StepEvents<2> events_;
};

std::unique_ptr<Part> build_camera_targets_part(const Scene& scene, std::uint64_t seed,
                                                const PartList& parts);

}  // namespace fulcrum
