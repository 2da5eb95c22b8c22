// SPDX-License-Identifier: GPL-3.0-or-later
// Events as lines of a debrief's list.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "sim_core/telemetry/event.h"

namespace fulcrum::ui {

/// In words; "" for events that are no line of the list (shown targets, progress).
QString event_words(const Event& event, const std::vector<std::string>& tissues);
/// Errors, and faults of the device or the simulation.
bool is_penalty(EventKind kind);
bool is_critical(EventKind kind);

}  // namespace fulcrum::ui
