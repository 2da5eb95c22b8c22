// SPDX-License-Identifier: Apache-2.0
// How able a synthetic operator is.
#pragma once

#include <cstdint>
#include <string>

#include "sim_core/numerics/name_table.h"

namespace fulcrum {

enum class OperatorLevel : std::uint8_t { expert, intermediate, novice };

inline constexpr NameRow<OperatorLevel> operator_levels[] = {
    {OperatorLevel::expert, "expert", QT_TRANSLATE_NOOP("fulcrum::operators", "expert")},
    {OperatorLevel::intermediate, "intermediate", QT_TRANSLATE_NOOP("fulcrum::operators", "intermediate")},
    {OperatorLevel::novice, "novice", QT_TRANSLATE_NOOP("fulcrum::operators", "novice")},
};
static_assert(in_order(operator_levels));

/// The level that a word stands for. Throws InputError for an unknown one.
OperatorLevel operator_level(const std::string& name);

}  // namespace fulcrum
