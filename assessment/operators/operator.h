// SPDX-License-Identifier: Apache-2.0
// A synthetic operator: drives the device interface in a closed loop and sees what a trainee sees (the world
// after the last step, the task's display) after a reaction delay. Its attempts are marked as synthetic.
#pragma once

#include <cstdint>
#include <memory>

#include "assessment/operators/operator_level.h"
#include "assessment/task/monitor.h"
#include "assessment/task/task.h"
#include "sim_core/instrument/device.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"

namespace fulcrum {

struct Skill;

/// A rig that is also shown the world. observe() is called on the stepping thread before the ticks that may
/// use it.
class ObservingRig : public Rig {
  public:
    virtual void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept = 0;
};

/// The seed draws the individual of a level and its noise. Throws InputError for a task that it cannot
/// perform.
std::unique_ptr<ObservingRig> make_operator(OperatorLevel level, const TaskDefinition& task,
                                            const Scene& scene, std::uint64_t seed);

/// As above with the individual and the attempt apart: one `individual` makes many attempts, each with noise
/// of its own. The function above takes one seed for both.
std::unique_ptr<ObservingRig> make_operator(OperatorLevel level, const TaskDefinition& task,
                                            const Scene& scene, std::uint64_t individual,
                                            std::uint64_t attempt);

/// An operator of this skill, which need not be any level's.
std::unique_ptr<ObservingRig> make_operator(const Skill& skill, const TaskDefinition& task,
                                            const Scene& scene, std::uint64_t attempt);

}  // namespace fulcrum
