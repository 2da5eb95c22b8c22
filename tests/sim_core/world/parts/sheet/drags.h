// SPDX-License-Identifier: Apache-2.0
// Hands that drag their instruments anywhere: over borders, through tissue and across each other, as a hand
// without force feedback can.
#pragma once

#include <functional>

#include "sim_core/numerics/random.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum::test {

/// `count` short drags of 20 to 100 mm/s, a third of them towards `somewhere` with the right hand, a third
/// with the left tip across the right shaft, the others out by the trocar or with the left hand. Returns the
/// largest change of a hand's force in a tick, N.
inline double drag_about(SheetRig& rig, int count, Random& random,
                         const std::function<Vector3(Random&)>& somewhere) {
    const double longest = 0.014;  // m
    rig.worst_change = 0;
    for (int drag = 0; drag < count; ++drag) {
        const int kind = static_cast<int>(random.uniform(0, 5.999));
        const int hand = kind < 3 ? 1 : 0;
        const Vector3 from = rig.wish[hand].tip;
        Vector3 to = somewhere(random);
        if (kind == 2) to = from + 0.04 * (rig.trocar[1].position - from).normalized();
        if (kind > 3) {
            const Vector3 back = (rig.trocar[1].position - rig.wish[1].tip).normalized();
            const Vector3 beside(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            to = rig.wish[1].tip + random.uniform(-0.01, 0.06) * back + 0.02 * beside;
        }
        rig.wish[1].button = random.uniform(0, 1) < 0.3;
        rig.wish[0].closed = random.uniform(0, 1) < 0.3;
        const Vector3 displacement = to - from;
        rig.go(hand, from + std::min(1.0, longest / displacement.norm()) * displacement,
               random.uniform(0.02, 0.1));
    }
    return rig.worst_change;
}

}  // namespace fulcrum::test
