// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bleeding/pool.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr int suction_rounds = 4;
constexpr double longest_round = 0.02;  // s, fraction of the spreading time that one round may cover
constexpr int most_rounds = 16;

}  // namespace

PoolState make_pool_state(const PoolModel& model) {
    PoolState state;
    state.depth.assign(model.ground.size(), 0.0);
    return state;
}

void pour(const PoolModel& model, int column, int row, double volume, PoolState& state) noexcept {
    if (!(volume > 0) || !std::isfinite(volume) || model.columns < 1 || model.rows < 1) return;
    column = std::clamp(column, 0, model.columns - 1);
    row = std::clamp(row, 0, model.rows - 1);
    state.depth[model.index(column, row)] += volume / (model.cell * model.cell);
    state.poured += volume;
}

double suck(const PoolModel& model, double x, double y, double reach, double volume,
            PoolState& state) noexcept {
    if (!(volume > 0) || !std::isfinite(volume) || !std::isfinite(x) || !std::isfinite(y)) return 0;
    const double area = model.cell * model.cell;
    const auto first = [&](double at) {
        return static_cast<int>(std::clamp(std::floor((at - reach) / model.cell), 0.0, 1e6));
    };
    const int last_column =
        static_cast<int>(std::clamp(std::floor((x + reach) / model.cell), -1.0, model.columns - 1.0));
    const int last_row =
        static_cast<int>(std::clamp(std::floor((y + reach) / model.cell), -1.0, model.rows - 1.0));
    const auto each = [&](auto&& visit) {
        for (int row = first(y); row <= last_row; ++row) {
            for (int column = first(x); column <= last_column; ++column) {
                const double dx = (column + 0.5) * model.cell - x, dy = (row + 0.5) * model.cell - y;
                if (dx * dx + dy * dy <= reach * reach) visit(state.depth[model.index(column, row)]);
            }
        }
    };
    double left = volume;
    for (int round = 0; round < suction_rounds && left > 0; ++round) {
        int wet = 0;
        each([&](double& depth) { wet += depth > 0 ? 1 : 0; });
        if (wet == 0) break;
        const double portion = left / wet;
        each([&](double& depth) {
            if (depth <= 0) return;
            const double taken = std::min(depth * area, portion);
            depth = taken < depth * area ? depth - taken / area : 0.0;
            left -= taken;
        });
    }
    const double taken = volume - std::max(0.0, left);
    state.removed += taken;
    return taken;
}

void step_pool(const PoolModel& model, double dt, PoolState& state) noexcept {
    if (!(dt > 0) || !std::isfinite(dt)) return;
    const int rounds =
        static_cast<int>(std::clamp(std::ceil(dt / longest_round), 1.0, static_cast<double>(most_rounds)));
    // Half of the difference levels two surfaces; a quarter of that for four neighbours at once.
    const double share = 0.25 * std::min(1.0, dt / rounds / model.spread_time);
    const auto flow = [&](std::size_t a, std::size_t b) {
        const double difference = model.ground[a] + state.depth[a] - model.ground[b] - state.depth[b];
        const double most = difference > 0 ? 0.25 * state.depth[a] : 0.25 * state.depth[b];
        const double moved = std::min(std::abs(share * difference), most);
        state.depth[a] -= difference > 0 ? moved : -moved;
        state.depth[b] += difference > 0 ? moved : -moved;
    };
    for (int round = 0; round < rounds; ++round) {
        for (int row = 0; row < model.rows; ++row) {
            for (int column = 0; column < model.columns; ++column) {
                if (column + 1 < model.columns) flow(model.index(column, row), model.index(column + 1, row));
                if (row + 1 < model.rows) flow(model.index(column, row), model.index(column, row + 1));
            }
        }
    }
}

double pooled_volume(const PoolModel& model, const PoolState& state) {
    double sum = 0;
    for (const double depth : state.depth) sum += depth;
    return sum * model.cell * model.cell;
}

void step_smoke(const SmokeModel& model, double steam, bool suction, double dt, SmokeState& state) noexcept {
    if (!(dt > 0) || !std::isfinite(dt)) return;
    const double rate = 1 / model.leak_time + (suction ? model.suction_flow / model.volume : 0.0);
    const double made = steam > 0 && std::isfinite(steam) ? model.aerosol_share * steam / dt : 0.0;  // kg/s
    const double kept = math::exp(-rate * dt);
    state.mass = state.mass * kept + made / rate * (1 - kept);
}

double transmission(const SmokeModel& model, const SmokeState& state) noexcept {
    return math::exp(-model.extinction * state.mass / model.volume * model.path);
}

}  // namespace fulcrum
