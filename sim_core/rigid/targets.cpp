// SPDX-License-Identifier: Apache-2.0
#include "sim_core/rigid/targets.h"

#include <algorithm>

namespace fulcrum {

SphereDepthResult sphere_depth(const Vector3& tip, double tip_radius, const Vector3& centre, double radius) {
    SphereDepthResult result;
    const Vector3 out = tip - centre;
    const double distance = out.norm();
    if (distance > 1e-12) result.normal = out / distance;
    result.depth = tip_radius + radius - distance;
    return result;
}

std::vector<TargetSphere> place_targets(const TargetFieldSpec& field, std::uint64_t seed) {
    constexpr int attempts = 200;  // draws before the minimum distance is relaxed
    const int per_hand = std::max(0, field.per_hand);
    std::vector<Vector3> centres[hand_count];
    for (int hand = 0; hand < hand_count; ++hand) {
        Random random(seed, 0x7A12U + static_cast<std::uint64_t>(hand));
        // Every hand uses all depths once, in random order.
        std::vector<int> layer(static_cast<std::size_t>(per_hand));
        for (int i = 0; i < per_hand; ++i) layer[static_cast<std::size_t>(i)] = i;
        for (int i = per_hand - 1; i > 0; --i) {
            const auto other = random.below(static_cast<std::uint32_t>(i + 1));
            std::swap(layer[static_cast<std::size_t>(i)], layer[other]);
        }
        for (int i = 0; i < per_hand; ++i) {
            double distance = field.minimum_distance;
            Vector3 centre = field.centre;
            for (int attempt = 1;; ++attempt) {
                const double depth = (layer[static_cast<std::size_t>(i)] + random.uniform()) / per_hand;
                const Vector3 unit(random.uniform(-1, 1), random.uniform(-1, 1), 2.0 * depth - 1.0);
                centre = field.centre + field.half_extent.cwiseProduct(unit);
                bool clear = true;
                for (const auto& of_hand : centres) {
                    for (const Vector3& placed : of_hand)
                        clear = clear && (placed - centre).norm() >= distance;
                }
                if (clear) break;
                if (attempt % attempts == 0) distance = distance > 1e-6 ? 0.8 * distance : 0.0;
            }
            centres[hand].push_back(centre);
        }
    }
    std::vector<TargetSphere> targets;
    targets.reserve(static_cast<std::size_t>(hand_count) * static_cast<std::size_t>(per_hand));
    for (int i = 0; i < per_hand; ++i) {
        for (int hand = 0; hand < hand_count; ++hand) {
            TargetSphere target;
            target.centre = centres[hand][static_cast<std::size_t>(i)];
            target.radius = field.radius;
            target.hand = static_cast<Hand>(hand);
            targets.push_back(target);
        }
    }
    return targets;
}

}  // namespace fulcrum
