// SPDX-License-Identifier: GPL-3.0-or-later
// The scene at any moment of a stored attempt: recorded poses, tissue simulated again.
#pragma once

#include <memory>

#include "app/live/performance.h"
#include "database/rows/trace_codec.h"
#include "ui/services/application_services.h"

namespace fulcrum::app {

/// Simulates on a thread of its own and keeps ten snapshots of the tissue per second; the tissue between two
/// snapshots is interpolated, instruments and scope come from the record. Owner's thread only.
std::unique_ptr<ui::ReplaySource> make_replay_source(LoadedTask loaded, std::uint64_t seed,
                                                     const ForceDevices& devices,
                                                     std::shared_ptr<const database::Trace> trace);

}  // namespace fulcrum::app
