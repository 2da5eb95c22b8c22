// SPDX-License-Identifier: Apache-2.0
// Maps made at the hand: insertion and stiffness of the tissue, as the model is and as it is sent.
#include <algorithm>
#include <string>

#include "sim_core/haptics/stability.h"
#include "sim_core/lab/hand_lever.h"
#include "sim_core/lab/stability_rooms.h"

namespace fulcrum::lab {
namespace {

constexpr double tissue_damping = 0.4;  // N s/m

StabilityCell cell_of(HandAtLever& lever, LeverTissue tissue, double insertion, double stiffness,
                      bool as_sent) {
    StabilityCell cell;
    cell.at = {insertion, stiffness};
    for (const bool arm : {false, true}) {
        LeverCase at;
        at.tissue = tissue;
        at.insertion = insertion;
        at.stiffness = stiffness;
        at.damping = tissue_damping;
        LeverHand hand;
        hand.arm = arm;
        if (!as_sent) hand.device.damping = 1e7;  // Eq. 8 never acts
        const LeverRun run = lever.run(at, hand);
        cell.finite = cell.finite && run.finite;
        cell.measure = std::max(cell.measure, run.returned);
        if (run.sound()) continue;
        const bool held = run.finite && run.bounded && run.settles;
        cell.outcome = held && cell.outcome != StabilityOutcome::fault ? StabilityOutcome::degraded
                                                                       : StabilityOutcome::fault;
    }
    return cell;
}

StabilityMap map_of(HandAtLever& lever, LeverTissue tissue, bool as_sent) {
    const LeverHand hand;
    StabilityMap map;
    map.model = "haptics";
    map.title = std::string("at the hand, ") + name_of(tissue) + " across the shaft, " +
                (as_sent ? "as sent (Eq. 8 at the hand)" : "as the model is");
    StabilityAxis insertion, stiffness;
    insertion.name = "insertion";
    insertion.unit = "-";
    for (int percent = 5; percent <= 95; percent += 10) insertion.values.push_back(0.01 * percent);
    insertion.logarithmic = false;
    stiffness.name = "stiffness_n_m";
    stiffness.unit = "N/m";
    for (double k = 100; k < 6500; k *= 2) stiffness.values.push_back(k);
    map.axes = {insertion, stiffness};
    StabilityCurve stable, passive;
    stable.name = "stability: K l^2 T/2 = b + B l^2";
    stable.formula = "docs/THEORY.md, section 6, with the lever l = insertion / (1 - insertion)";
    passive.name = "passivity: K l^2 = 2 (b - |B| l^2) / T";
    passive.formula = "Eq. 8 at the hand";
    for (double share = 0.05; share < 0.951; share += 0.025) {
        const double lever2 = share * share / ((1 - share) * (1 - share)), b = hand.damping / lever2;
        stable.x.push_back(share);
        stable.y.push_back(stable_stiffness(tissue_damping, b, hand.period, 0));
        if (b <= tissue_damping) continue;
        passive.x.push_back(share);
        passive.y.push_back(passive_stiffness(tissue_damping, b, hand.period));
    }
    map.theory = {stable, passive};
    map.theory_note =
        "Hand and device of 0.1 kg and 0.5 N s/m at 1 kHz, with an arm and without; tissue of 0.4 N s/m; the "
        "hand "
        "presses the tip against it from the side. The bounds hold for small B l^2 T / m, up to about 80 %. "
        "Degraded: it settles, but got back more energy than it "
        "put in.";
    map.measure = "J that the hand got back beyond what it put in and the device lost";
    for (const double share : insertion.values) {
        for (const double k : stiffness.values)
            map.cells.push_back(cell_of(lever, tissue, share, k, as_sent));
    }
    return map;
}

}  // namespace

std::vector<StabilityMap> lever_stability() {
    HandAtLever lever;
    std::vector<StabilityMap> maps;
    maps.push_back(map_of(lever, LeverTissue::wall, false));
    for (const LeverTissue tissue : lever_tissues) maps.push_back(map_of(lever, tissue, true));
    return maps;
}

}  // namespace fulcrum::lab
