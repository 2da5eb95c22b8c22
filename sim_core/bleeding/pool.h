// SPDX-License-Identifier: Apache-2.0
// Pooled blood on a bed, as depths on a grid of cells. It flows to cells with a lower surface along gravity
// and is removed by suction. Volume is conserved: poured = present + removed. Model / state; no allocation in
// a step, no exception, always finite.
//
// Flow between neighbours is proportional to the difference of their surfaces, with a time constant, and at
// most a quarter of a cell's content per round, so that depths stay non-negative and nothing oscillates at
// any time step.
#pragma once

#include <cstdint>
#include <vector>

namespace fulcrum {

struct PoolModel {
    int columns = 0, rows = 0;
    double cell = 0.008;         ///< m, edge of a cell
    std::vector<double> ground;  ///< m, height of each cell along gravity (up positive), row by row
    double spread_time = 0.25;   ///< s, time constant in which two neighbours level out
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
/// Adds m3 of blood to a cell; outside the grid: to the nearest cell. Volumes that are not positive are
/// ignored.
void pour(const PoolModel& model, int column, int row, double volume, PoolState& state) noexcept;
/// Removes up to `volume` m3 from the cells whose centres are within `reach` m of a position (m, from the
/// grid's first corner), highest surfaces first, in equal shares. Returns the removed volume.
double suck(const PoolModel& model, double x, double y, double reach, double volume,
            PoolState& state) noexcept;
/// Advances the flow by dt seconds.
void step_pool(const PoolModel& model, double dt, PoolState& state) noexcept;
/// Total volume of pooled blood, m3.
double pooled_volume(const PoolModel& model, const PoolState& state);

/// Smoke and steam in the gas above: one well-mixed volume. Extinction follows Beer and Lambert.
struct SmokeModel {
    double volume = 3e-3;         ///< m3 of gas
    double extinction = 900;      ///< m2/kg of aerosol, provisional
    double path = 0.12;           ///< m, lens to tissue
    double aerosol_share = 0.02;  ///< of the steam's mass; provisional
    double leak_time = 90;        ///< s, time in which it clears by itself to 1/e
    double suction_flow = 5e-4;   ///< m3/s of gas removed by suction
};
struct SmokeState {
    double mass = 0;  ///< kg of aerosol
};
/// `steam`: kg produced during the step; suction on or off. Exact for constant rates.
void step_smoke(const SmokeModel& model, double steam, bool suction, double dt, SmokeState& state) noexcept;
/// Fraction of light transmitted, 0 .. 1.
double transmission(const SmokeModel& model, const SmokeState& state) noexcept;

}  // namespace fulcrum
