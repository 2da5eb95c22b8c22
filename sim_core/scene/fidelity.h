// SPDX-License-Identifier: Apache-2.0
// Named fidelities: one level for every row of the speed-accuracy table.
#pragma once

#include <iterator>
#include <string>
#include <vector>

#include "sim_core/scene/scene.h"
#include "sim_core/scene/standard_names.h"

namespace fulcrum {

enum class FidelityLevel : std::uint8_t { fast, standard, fine };
inline constexpr NameRow<FidelityLevel> fidelity_levels[] = {
    {FidelityLevel::fast, "fast", QT_TRANSLATE_NOOP("fulcrum::fidelity", "fast")},
    {FidelityLevel::standard, standard_fidelity, QT_TRANSLATE_NOOP("fulcrum::fidelity", "standard")},
    {FidelityLevel::fine, "fine", QT_TRANSLATE_NOOP("fulcrum::fidelity", "fine")}};
static_assert(in_order(fidelity_levels));

/// The reference of comparisons.
inline std::string finest_fidelity() {
    return fidelity_levels[std::size(fidelity_levels) - 1].name;
}
Fidelity fidelity_of(FidelityLevel level);
/// By its name. Throws InputError listing the names for any other.
Fidelity named_fidelity(const std::string& name);

}  // namespace fulcrum
