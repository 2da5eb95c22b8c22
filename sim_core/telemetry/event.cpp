// SPDX-License-Identifier: Apache-2.0
#include "sim_core/telemetry/event.h"

#include <algorithm>

#include "sim_core/telemetry/event_types.h"

namespace fulcrum {
namespace {

// As records have stored them from the first: bits of an activation; a nerve's number, and 256 more where a
// blade divided it.
constexpr std::int32_t in_view_bit = 1, on_target_bit = 2, clear_bit = 4;
constexpr std::int32_t divided_by_blade = 256;
constexpr double micrometre = 1e-6;

}  // namespace

const char* event_name(EventKind kind) {
    const auto number = static_cast<std::size_t>(kind);
    return number < std::size(event_kinds) ? event_kinds[number].name : "unknown";
}

std::int32_t detail_of(const Activation& activation) {
    return (activation.in_view ? in_view_bit : 0) | (activation.on_target ? on_target_bit : 0) |
           (activation.clear ? clear_bit : 0);
}

Activation activation_of(const Event& event) {
    return {(event.detail & in_view_bit) != 0, (event.detail & on_target_bit) != 0,
            (event.detail & clear_bit) != 0};
}

std::int32_t detail_of(const NerveInjury& injury) {
    return injury.nerve + (injury.cause == InjuryCause::blade ? divided_by_blade : 0);
}

NerveInjury nerve_injury_of(const Event& event) {
    if (event.detail >= divided_by_blade) return {event.detail - divided_by_blade, InjuryCause::blade};
    return {event.detail, InjuryCause::heat};
}

CutPlace cut_place_of(const Event& event) {
    return {static_cast<double>(event.value), event.detail * micrometre};
}

CutTraction cut_traction_of(const Event& event) {
    return {static_cast<double>(event.value), std::max(0, event.detail) * micrometre};
}

}  // namespace fulcrum
