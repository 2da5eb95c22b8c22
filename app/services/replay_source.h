// SPDX-License-Identifier: GPL-3.0-or-later
// What the world looked like at a moment of a stored attempt: recorded poses, re-simulated tissue.
#pragma once

#include <memory>

#include "app/live/performance.h"
#include "database/rows/trace_codec.h"
#include "ui/services/application_services.h"

namespace fulcrum::app {

/// Re-simulates on a thread of its own and keeps a picture of the tissue ten times a second; between two of
/// them tissue is blended, instruments and scope are drawn from the record itself. Owner's thread only.
std::unique_ptr<ui::ReplaySource> make_replay_source(LoadedTask loaded, std::uint64_t seed,
                                                     std::shared_ptr<const database::Trace> trace);

}  // namespace fulcrum::app
