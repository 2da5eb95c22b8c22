// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "assessment/operators/cheat_view.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum::cheating {

constexpr int grasper = 0, blade = 1;  // hands
constexpr std::int32_t wide_jaw = 800000, firm_grip = 4000;

void turn_scope(RigSample& sample, double angle) {
    const double y = sample.camera.handle[1], z = sample.camera.handle[2];
    const double c = math::cos(angle), s = math::sin(angle);
    sample.camera.handle[1] = static_cast<std::int32_t>(std::lround(c * y - s * z));
    sample.camera.handle[2] = static_cast<std::int32_t>(std::lround(s * y + c * z));
}

void wait_in_view(const CheatView& view, RigSample& sample) {
    constexpr double half_turn = 3.14159265358979323846, radius = 0.0004;
    const std::uint32_t tick = sample.tick;
    sample = view.first;
    sample.tick = tick;
    // No hand is exactly still; so slow, it starts no clock.
    for (DeviceSample& hand : sample.hand) aside(hand, radius * math::sin(half_turn * view.time), 0);
}

void look_away(CheatView& view, RigSample& sample) {
    constexpr double period = 10, away = 4.2, turn = 0.3;  // s
    const double phase = std::fmod(view.time, period);
    turn_scope(sample, turned_away * std::clamp(std::min(phase, away - phase) / turn, 0.0, 1.0));
}

void tear_and_trim(CheatView& view, RigSample& sample) {
    constexpr double turn = 4, farthest = 0.05, step = 40e-6;  // s; m; m a tick
    const bool tears = view.display.goal >= 1 && std::fmod(view.time, 2 * turn) < turn;
    const bool pulls = tears && view.grasps[grasper].held;
    view.pull = pulls ? std::min(farthest, view.pull + step) : std::max(0.0, view.pull - step);
    along_shaft(sample.hand[grasper], -view.pull);
    if (!tears) return;
    std::uint16_t& buttons = sample.hand[blade].buttons;
    buttons = static_cast<std::uint16_t>(buttons & ~(unsigned{button_primary} | unsigned{button_energy}));
}

void pedal_in_the_air(CheatView& view, RigSample& sample) {
    constexpr double kept_down = 2, period = 4, burns = 1;  // s
    DeviceSample& shears = sample.hand[blade];
    const bool divides = (shears.buttons & button_energy) != 0;
    if (view.energy_before && !divides) view.released_at = view.time;
    view.energy_before = divides;
    if (divides) return;
    const bool divided = view.released_at >= 0 && view.time - view.released_at < kept_down;
    if (divided) {
        shears.jaw = 0;
        shears.grip = firm_grip;
    }
    if (divided || std::fmod(view.time, period) < burns)
        shears.buttons = static_cast<std::uint16_t>(shears.buttons | button_energy);
}

void let_fall(CheatView& view, RigSample& sample) {
    constexpr int often = 3;
    constexpr double open_s = 0.6, held = 0.02;  // of the hold: the bowel is as high as the task asks
    if (view.falls < often && view.time > view.opens_until && view.display.goal >= 1 &&
        view.display.hold_progress > held) {
        ++view.falls;
        view.opens_until = view.time + open_s;
    }
    if (view.time > view.opens_until) return;
    for (DeviceSample& hand : sample.hand) {
        hand.jaw = wide_jaw;
        hand.grip = 0;
    }
}

}  // namespace fulcrum::cheating
