// SPDX-License-Identifier: Apache-2.0
// Cutting values of a scene's tissues that a site may set in place of those of the scene file (Eqs. 6 and 7,
// docs/THEORY.md, section 5). A site's values are written into the scene's text, so that schema and reader
// check them like a file, and a record can contain the scene as it was used. Any thread except the haptic and
// world threads.
#pragma once

#include <map>
#include <string>

#include "sim_core/numerics/name_table.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// Keys of a scene's `cutting` that the reader reads and a site may set.
struct CuttingKey {
    const char* key;
    double CuttingSpec::*value;
    const char* words;  ///< for screens
    const char* unit;
};
inline constexpr CuttingKey cutting_keys[] = {
    {"penetrate_n", &CuttingSpec::penetrate,
     QT_TRANSLATE_NOOP("fulcrum::tissues", "Force across the tissue to break through"), "N"},
    {"static_friction_n", &CuttingSpec::static_friction,
     QT_TRANSLATE_NOOP("fulcrum::tissues", "Force along the tissue to break through"), "N"},
    {"dynamic_friction_n", &CuttingSpec::dynamic_friction,
     QT_TRANSLATE_NOOP("fulcrum::tissues", "Force along the tissue to continue a cut"), "N"},
    {"energy_factor", &CuttingSpec::energy_factor,
     QT_TRANSLATE_NOOP("fulcrum::tissues", "Fraction of these forces with energy on"), ""},
};

/// By tissue label, then by key of the scene's `cutting` (cutting_keys). Absent tissues and keys keep the
/// values of the scene file.
using CuttingValues = std::map<std::string, std::map<std::string, double>>;

/// The values of all tissues that can be cut.
CuttingValues cutting_values(const Scene& scene);

/// Range that the scene schema allows.
struct CuttingRange {
    double minimum = 0, maximum = 0;
    bool above = false;  ///< the minimum itself is excluded
    std::string words;   ///< "above 0, at most 20"
};
/// `key`: one of cutting_keys.
CuttingRange cutting_range(const std::string& key);

/// The scene's text with these values in it; unchanged if there are none. Throws InputError with `file`, the
/// tissue and the key: unknown, not a number, out of range, or inconsistent values.
std::string with_cutting_values(const std::string& scene_text, const std::string& file,
                                const CuttingValues& values);

/// The first difference in words ("areolar: penetrate_n 0.12, there 0.08"); empty if both are equal.
std::string cutting_difference(const CuttingValues& here, const CuttingValues& there);

}  // namespace fulcrum
