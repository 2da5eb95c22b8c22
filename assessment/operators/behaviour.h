// SPDX-License-Identifier: Apache-2.0
// Decisions of an operator, for each kind of task. A behaviour sees the display of one reaction time ago and
// moves two limbs.
#pragma once

#include <cstdint>
#include <memory>

#include "assessment/operators/limb.h"
#include "assessment/operators/perception.h"
#include "assessment/task/task.h"

namespace fulcrum {

class ScopeLimb;

/// The operator's limbs and view, as used by a behaviour. Limbs that the scene lacks are null.
struct Body {
    Limb* limb[hand_count] = {nullptr, nullptr};
    ScopeLimb* scope = nullptr;  ///< where the scene has a scope and no instruments
    const DelayLine* eyes = nullptr;
    Vector3 view =
        Vector3(0, -1, -1).normalized();  ///< unit, the camera's line of sight: depth is misjudged along it
    Vector3 gaze = Vector3::Zero();       ///< m, the point that the behaviour looks at; the camera follows
};

class Behaviour {
  public:
    virtual ~Behaviour() = default;
    /// Decides; called once every decision period. Must not allocate or throw.
    virtual void decide(const Perception& seen, Body& body) noexcept = 0;
};

/// touch_targets: each lit sphere is touched and held, the other hand waits.
std::unique_ptr<Behaviour> make_targeting(const TaskDefinition& task, const Scene& scene, const Skill& skill);
/// run_bowel and lift_and_hold: hand over hand along the bowel, then one hand lifts and holds.
std::unique_ptr<Behaviour> make_bowel_handling(const TaskDefinition& task, const Scene& scene,
                                               const Skill& skill);
/// take_tension, divide_line and let_go: one hand keeps the sheet taut, the other divides it.
/// `attempt` is the seed of what the operator believes of a plane that is not seen.
std::unique_ptr<Behaviour> make_sheet_division(const TaskDefinition& task, const Scene& scene,
                                               const Skill& skill, std::uint64_t attempt);

/// divide_bands and stop_bleeding: take, lift, divide, clip what bleeds.
std::unique_ptr<Behaviour> make_band_handling(const TaskDefinition& task, const Scene& scene,
                                              const Skill& skill);
/// transfer_objects: one hand lifts each ring, the other takes it in the air and puts it around a peg.
std::unique_ptr<Behaviour> make_object_handling(const TaskDefinition& task, const Scene& scene,
                                                const Skill& skill);
/// frame_targets and follow_tip: the scope is brought to each target, then after the moving tip.
std::unique_ptr<Behaviour> make_scope_handling(const TaskDefinition& task, const Scene& scene,
                                               const Skill& skill);

}  // namespace fulcrum
