// SPDX-License-Identifier: Apache-2.0
// Blood that lies on a bed, as depths on a grid of cells: it runs to where the surface is lower along
// gravity, is covered or uncovered by that, and is sucked away. Volume is kept: what was poured is what lies
// there and what was removed. Model / state; no allocation in a step, no exception, always finite.
//
// Flow between neighbours follows the difference of their surfaces, spread over a time constant and never
// more than a quarter of what a cell holds a round, so that depths stay above 0 and nothing oscillates,
// whatever the time step.
#pragma once

#include <cstdint>
#include <vector>

namespace fulcrum {

struct PoolModel {
    int columns = 0, rows = 0;
    double cell = 0.008;         ///< m, edge of a cell
    std::vector<double> ground;  ///< m, height of each cell along gravity (up positive), row by row
    double spread_time = 0.25;   ///< s, in which two neighbours even out
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

struct PoolState {
    std::vector<double> depth;       ///< m of blood on each cell
    double poured = 0, removed = 0;  ///< m3 since the start
};

PoolState make_pool_state(const PoolModel& model);
/// m3 of blood onto a cell; outside the grid: onto the nearest. What is not above 0 is nothing.
void pour(const PoolModel& model, int column, int row, double volume, PoolState& state) noexcept;
/// Takes up to `volume` m3 from the cells whose centres lie within `reach` m of a place (m, from the grid's
/// first corner), deepest surfaces first in equal shares; returns what was taken.
double suck(const PoolModel& model, double x, double y, double reach, double volume,
            PoolState& state) noexcept;
/// Runs downhill for dt seconds.
void step_pool(const PoolModel& model, double dt, PoolState& state) noexcept;
/// m3 that lies there.
double pooled_volume(const PoolModel& model, const PoolState& state);

/// Smoke and steam in the gas above: one well-mixed volume. Extinction follows Beer and Lambert.
struct SmokeModel {
    double volume = 3e-3;         ///< m3 of gas
    double extinction = 900;      ///< m2/kg of aerosol, provisional
    double path = 0.12;           ///< m, lens to tissue
    double aerosol_share = 0.02;  ///< of the steam's mass; provisional
    double leak_time = 90;        ///< s, in which it clears by itself to 1/e
    double suction_flow = 5e-4;   ///< m3/s of gas that suction takes
};
struct SmokeState {
    double mass = 0;  ///< kg of aerosol
};
/// `steam` kg made during the step; suction on or off. Exact for constant rates.
void step_smoke(const SmokeModel& model, double steam, bool suction, double dt, SmokeState& state) noexcept;
/// Share of light that comes through, 0 .. 1.
double transmission(const SmokeModel& model, const SmokeState& state) noexcept;

}  // namespace fulcrum
