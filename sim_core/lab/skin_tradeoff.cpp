// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/skin_tradeoff.h"

#include <cmath>

#include "sim_core/bowel/wide_skin.h"
#include "sim_core/geometry/mesh.h"
#include "sim_core/lab/reference_skin.h"
#include "sim_core/lab/reference_tube.h"

namespace fulcrum::lab {

TradeoffStudy skinning_tradeoff() {
    constexpr double length = 0.4, radius = 0.016;
    TradeoffStudy study;
    study.model = "skinning";
    study.reference = "global mean value coordinates; volume at rest";
    std::vector<TradeoffLevel> by_volume;
    for (const double spacing : {0.024, 0.016, 0.012}) {
        const BowelSkin skin = make_skin(length, radius, spacing, 100, 30, haustral_radius(radius));
        const std::vector<RingFrame> frames = quarter_bend_frames(skin.cage(), 3 * radius);
        const auto count = static_cast<std::size_t>(skin.vertices());
        std::vector<Vector3> reference(count), positions(count);
        const WideSkin global(skin, SkinScope::global), wider(skin, SkinScope::local2);
        const auto carry = [&](const WideSkin& wide, std::vector<Vector3>& out) {
            for (std::size_t v = 0; v < count; ++v)
                out[v] = wide.vertex(static_cast<std::int32_t>(v), frames);
        };
        carry(global, reference);
        const double rest_volume = enclosed_volume(skin.rest().vertices, skin.rest().triangles);
        const auto measure = [&](const char* family, auto&& step) {
            TradeoffLevel level;
            level.family = family;
            level.level =
                std::string(family) + ", spheres every " + std::to_string(std::lround(spacing * 1e3)) + " mm";
            level.time_us = median_time_us(3, 31, step, [] {});
            double sum = 0;
            for (std::size_t v = 0; v < count; ++v) sum += (positions[v] - reference[v]).norm();
            level.error = sum / static_cast<double>(count);
            level.error_unit = "m, mean over vertices";
            study.levels.push_back(level);
            level.level += ", volume";
            level.error = std::abs(enclosed_volume(positions, skin.rest().triangles) / rest_volume - 1);
            level.error_unit = "relative change of volume";
            by_volume.push_back(level);
        };
        measure("local", [&] { skin_all(skin, frames.data(), positions.data()); });
        measure("local2", [&] { carry(wider, positions); });
        measure("global", [&] { carry(global, positions); });
    }
    study.levels.insert(study.levels.end(), by_volume.begin(), by_volume.end());
    mark_pareto(study);
    return study;
}

}  // namespace fulcrum::lab
