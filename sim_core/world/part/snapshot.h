// SPDX-License-Identifier: Apache-2.0
// What the world looks like after a step: read by the viewport, the task monitor and the synthetic operators,
// never by the tick. Vectors have their final size from the start, so copying a snapshot into a slot of the
// same scene allocates nothing.
#pragma once

#include <cstdint>
#include <vector>

#include "sim_core/instrument/poses.h"
#include "sim_core/numerics/types.h"
#include "sim_core/rigid/target_sphere.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/world/part/all_views.h"  // made by the build: every *_view.h of this folder

namespace fulcrum {

/// What jaws can hold.
enum class HeldBody : std::uint8_t { none, bowel, membrane, sheet, band, object };

/// What a pair of jaws holds. The world writes it, from the part that holds (Part::grasp); after the hold it
/// shows the last one, without reaction.
struct GraspState {
    bool held = false;
    double arc_length = 0;               ///< m along the bowel; -1 where it is a membrane that is held
    Vector3 offset = Vector3::Zero();    ///< wall point in the ring frame, m
    Vector3 point = Vector3::Zero();     ///< wall point, patient frame, m
    Vector3 reaction = Vector3::Zero();  ///< N, jaw on tissue
    std::int32_t patch = -1;             ///< of the bowel's wall, or which band or object; -1 of a membrane
    HeldBody body = HeldBody::none;
    std::int8_t tissue = -1;  ///< index in Scene::tissues of what is or was last held; -1: nothing yet
    bool slipped =
        false;  ///< the last hold ended because its reaction left the friction cone, not by opening the jaws
};

struct WorldSnapshot {
    std::uint32_t step = 0;
    std::uint32_t tick = 0;     ///< last input tick the step consumed
    std::uint32_t outcome = 0;  ///< StepRecord::outcome
    ToolPose tools[hand_count];
    /// m, from the tips above to where the instruments are drawn: at the surface of what they touch.
    Vector3 lift[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    CameraPose camera;
    GraspState grasps[hand_count];
    std::vector<Event> events;  ///< what this step did to tissue, for the monitor to pass on; fixed capacity,
                                ///< event_count valid
    std::int32_t event_count = 0;
    std::vector<FieldView> field;  ///< one with Scene::bands or Scene::structures; empty without
    // The view of each part.
#define WORLD_PART(name, view) view name;
#define PART_WITHOUT_VIEW(name)
#include "sim_core/world/part/world_parts.inc"

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(step, tick, outcome, tools, lift, camera, grasps, events, event_count, field);
#define WORLD_PART(name, view) visit(name);
#define PART_WITHOUT_VIEW(name)
#include "sim_core/world/part/world_parts.inc"
    }
};

}  // namespace fulcrum
