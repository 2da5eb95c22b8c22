// SPDX-License-Identifier: Apache-2.0
// A draft that began with one version of the curriculum, and another version that came into force since: the
// changes of both authors together, by stage, task and field. Pure.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"

namespace fulcrum {

/// What of a curriculum is merged as one.
enum class DraftPart : std::uint8_t {
    title,        ///< of the curriculum
    stage_order,  ///< of the curriculum
    stage,        ///< that there is this stage
    stage_title,
    task_order,  ///< of the curriculum
    task,        ///< that the curriculum has this task
    task_stage,  ///< this and all below: of a task
    after,
    rule,
    variants,
    devices,
    ratings,
    remedies
};

struct DraftDifference {
    DraftPart part = DraftPart::title;
    std::string of = {};  ///< id of the stage or of the task; empty for parts of the curriculum
};
inline bool operator==(const DraftDifference& a, const DraftDifference& b) {
    return a.part == b.part && a.of == b.of;
}

struct DraftMerge {
    Curriculum draft;
    std::vector<DraftDifference> taken;  ///< only the version in force changed it: its value is in `draft`
    /// Both changed it, each in another way, or one removed what the other changed: the draft's own value is
    /// in `draft`.
    std::vector<DraftDifference> collisions;
};

/// `base`: the version that the draft began with. Null where it is not known: who changed what cannot be
/// found out then, and every difference is a collision.
DraftMerge merge_draft(const Curriculum* base, const Curriculum& draft, const Curriculum& in_force);
/// Puts the value of the version in force in the place of the draft's own.
void take_part(Curriculum& draft, const Curriculum& in_force, const DraftDifference& part);
/// What is left of collisions after the draft was edited: a value that agrees by now is none, fields of a
/// task that was removed are one, and a task that was added again has those of its fields.
std::vector<DraftDifference> collisions_left(const std::vector<DraftDifference>& collisions,
                                             const Curriculum& draft, const Curriculum& in_force);

}  // namespace fulcrum
