// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "assessment/task/task.h"

namespace fulcrum {

/// The hand that a goal asks for; none where either may do it.
inline std::optional<Hand> asked_hand(const Goal& goal) {
    for (const GoalKey& key : type_of(goal.kind).keys)
        if (key.name != nullptr && std::string_view(key.name) == "hand") return goal.hand;
    return std::nullopt;
}

}  // namespace fulcrum
