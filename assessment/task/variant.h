// SPDX-License-Identifier: Apache-2.0
// Variants of a task: the same goals and gates in several scenes, so that nobody learns one picture by heart.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim_core/scene/standard_names.h"

namespace fulcrum {

struct TaskDefinition;

/// Every task has the standard_variant, in the scene that the task itself names.
struct TaskVariant {
    std::string id;     ///< "narrow", as in its scene (Scene::variant) and in attempts
    std::string title;  ///< on screens, "Narrow pelvis"
    std::string scene;  ///< file name in assets/scenes
    /// Id of the variant with whose benchmark sets its attempts are compared: its own, or that of another
    /// variant of the task in which experts need the same time, paths and forces.
    std::string family;
};

/// `id` empty: the standard one. Throws InputError with the known ids.
const TaskVariant& require_variant(const TaskDefinition& task, const std::string& id);
/// The family of a variant that an attempt names; a variant that the task no longer has is its own family.
std::string variant_family(const TaskDefinition& task, const std::string& id);
/// The variant practised least, of several the one listed first. `attempts`: how many, by variant.
std::string next_variant(const TaskDefinition& task, const std::map<std::string, int>& attempts);

}  // namespace fulcrum
