// SPDX-License-Identifier: Apache-2.0
// What blades meet in a scene's tissues, as values that a site may set in place of the scene file's own
// (Eqs. 6 and 7, docs/THEORY.md 5). A site's values become a scene's text again, so that schema
// and reader check them as they check a file, and a record can carry the scene as it was used. Any thread but
// the haptic and world threads.
#pragma once

#include <map>
#include <string>

#include "sim_core/scene/scene.h"

namespace fulcrum {

/// The keys of a scene's `cutting`: what the reader reads, and what a site may set.
struct CuttingKey {
    const char* key;
    double CuttingSpec::*value;
    const char* words;  ///< for screens
    const char* unit;
};
inline constexpr CuttingKey cutting_keys[] = {
    {"penetrate_n", &CuttingSpec::penetrate, "Breaks through above, across the tissue", "N"},
    {"static_friction_n", &CuttingSpec::static_friction, "Breaks through above, along the tissue", "N"},
    {"dynamic_friction_n", &CuttingSpec::dynamic_friction, "Moves on above, along the tissue", "N"},
    {"energy_factor", &CuttingSpec::energy_factor, "Share of these under power", ""},
};

/// By tissue label, then by key of the scene's `cutting` (cutting_keys). Tissues and keys that are absent
/// keep what the scene file says.
using CuttingValues = std::map<std::string, std::map<std::string, double>>;

/// The values of every tissue that blades cut.
CuttingValues cutting_values(const Scene& scene);

/// What the scene schema allows.
struct CuttingRange {
    double minimum = 0, maximum = 0;
    bool above = false;  ///< the minimum itself is not allowed
    std::string words;   ///< "above 0, at most 20"
};
/// `key`: one of cutting_keys.
CuttingRange cutting_range(const std::string& key);

/// The scene's text with these values in it; the text as it is where there are none. Throws InputError naming
/// `file`, the tissue and the key: unknown, not a number, out of range, or values that do not go together.
std::string with_cutting_values(const std::string& scene_text, const std::string& file,
                                const CuttingValues& values);

/// The first difference in words ("areolar: penetrate_n 0.12, there 0.08"); empty where the two say the same.
std::string cutting_difference(const CuttingValues& here, const CuttingValues& there);

}  // namespace fulcrum
