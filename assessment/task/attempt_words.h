// SPDX-License-Identifier: Apache-2.0
// What an attempt and its gates can be, as records and files name it and screens show it.
#pragma once

#include <cstdint>

#include "sim_core/instrument/device_class.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum {

enum class AttemptMode : std::uint8_t { practice, assessed };
inline constexpr NameRow<AttemptMode> attempt_modes[] = {
    {AttemptMode::practice, "practice", QT_TRANSLATE_NOOP("fulcrum::attempts", "practice")},
    {AttemptMode::assessed, "assessed", QT_TRANSLATE_NOOP("fulcrum::attempts", "assessed")}};
static_assert(in_order(attempt_modes));

/// How an attempt ended. The last two are the store's: under way, and declared void by a person.
enum class AttemptState : std::uint8_t {
    completed,
    timed_out,
    abandoned,
    interrupted,
    failed_simulation,
    voided,
    running
};
inline constexpr NameRow<AttemptState> attempt_states[] = {
    {AttemptState::completed, "completed", QT_TRANSLATE_NOOP("fulcrum::attempts", "completed")},
    {AttemptState::timed_out, "timed_out", QT_TRANSLATE_NOOP("fulcrum::attempts", "timed out")},
    {AttemptState::abandoned, "abandoned", QT_TRANSLATE_NOOP("fulcrum::attempts", "abandoned")},
    {AttemptState::interrupted, "interrupted", QT_TRANSLATE_NOOP("fulcrum::attempts", "interrupted")},
    {AttemptState::failed_simulation, "failed_simulation",
     QT_TRANSLATE_NOOP("fulcrum::attempts", "simulator fault")},
    {AttemptState::voided, "voided", QT_TRANSLATE_NOOP("fulcrum::attempts", "voided")},
    {AttemptState::running, "running", QT_TRANSLATE_NOOP("fulcrum::attempts", "running")}};
static_assert(in_order(attempt_states));

/// The class whose limits an attempt is held against. A synthetic operator without a model of a device, and a
/// trace whose device nobody named, move a handle freely and with force, as with a haptic device.
constexpr DeviceClass limits_class(DeviceClass used) {
    return used == DeviceClass::synthetic || used == DeviceClass::external ? DeviceClass::haptic : used;
}

enum class GateKind : std::uint8_t { benchmark, absolute };
inline constexpr NameRow<GateKind> gate_kinds[] = {
    {GateKind::benchmark, "benchmark", QT_TRANSLATE_NOOP("fulcrum::gates", "benchmark")},
    {GateKind::absolute, "absolute", QT_TRANSLATE_NOOP("fulcrum::gates", "absolute limit")}};
static_assert(in_order(gate_kinds));

}  // namespace fulcrum
