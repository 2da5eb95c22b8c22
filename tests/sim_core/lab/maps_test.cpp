// SPDX-License-Identifier: Apache-2.0
// Stability maps and trade-off studies of rod and surface: properties that hold on every machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/lab/membrane_tradeoff.h"
#include "sim_core/lab/stability_rooms.h"
#include "sim_core/lab/tradeoff_rooms.h"

namespace fulcrum::lab {
namespace {

void expect_sound(const std::vector<StabilityMap>& maps) {
    for (const StabilityMap& map : maps) {
        std::size_t cells = 1;
        for (const StabilityAxis& axis : map.axes) cells *= axis.values.size();
        EXPECT_EQ(map.cells.size(), cells) << map.title;
        EXPECT_TRUE(!map.theory.empty() || !map.theory_note.empty()) << map.title;
        for (const StabilityCell& cell : map.cells) {
            EXPECT_TRUE(cell.finite) << map.title;
            EXPECT_NE(cell.outcome, StabilityOutcome::fault)
                << map.title << " at " << cell.at[0] << ", " << cell.at[1];
        }
    }
}

TEST(Stability, RodStaysBoundedOverTheExtremes) {
    expect_sound(rod_stability());
}

TEST(Stability, SliversDoNotDegradeTheSurface) {
    const std::vector<StabilityMap> maps = skin_stability();
    expect_sound(maps);
    for (const StabilityCell& cell : maps[0].cells) {
        if (cell.at[1] >= 3) {
            EXPECT_EQ(cell.outcome, StabilityOutcome::stable) << cell.at[0] << ", " << cell.at[1];
        }
    }
}

// Symplectic Euler refuses far beyond its limit, which is a reported fault; the implicit integrators take
// every step.
TEST(Stability, MembranesStayFiniteAndImplicitOnesAlwaysStep) {
    for (const StabilityMap& map : membrane_stability()) {
        const bool symplectic = map.title.find("symplectic") != std::string::npos;
        for (const StabilityCell& cell : map.cells) {
            EXPECT_TRUE(cell.finite) << map.title;
            if (!symplectic) {
                EXPECT_NE(cell.outcome, StabilityOutcome::fault)
                    << map.title << " at " << cell.at[0] << ", " << cell.at[1];
            }
        }
    }
}

TEST(Tradeoff, RodErrorsDecreaseWithResolutionAndTheFrontIsMarked) {
    const std::vector<TradeoffStudy> studies = rod_tradeoff();
    ASSERT_EQ(studies.size(), 3u);
    for (TradeoffStudy study : studies) {
        for (const TradeoffLevel& level : study.levels) {
            EXPECT_TRUE(std::isfinite(level.error) && level.error >= 0 && level.time_us > 0)
                << study.model << ": " << level.level;
        }
        mark_pareto(study);
        EXPECT_TRUE(std::any_of(study.levels.begin(), study.levels.end(),
                                [](const TradeoffLevel& level) { return level.pareto; }));
        // The converged level of each study: its last family.
        std::vector<double> errors;
        for (const TradeoffLevel& level : study.levels) {
            if (level.family == study.levels.back().family) errors.push_back(level.error);
        }
        for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_LT(errors[i], errors[i - 1]) << study.model;
    }
}

}  // namespace
}  // namespace fulcrum::lab
