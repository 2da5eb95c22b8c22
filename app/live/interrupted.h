// SPDX-License-Identifier: GPL-3.0-or-later
// Scores attempts that were interrupted by a crash, a power cut or a lost device, from their records, at the
// next sign-in.
#pragma once

#include <string>
#include <vector>

#include "ui/services/application_services.h"

namespace fulcrum::app {

/// Scores all interrupted attempts without a score that the session may score, oldest first. An attempt that
/// cannot be read is skipped (`db check` reports it). Opens the store at `store_path` itself. May run on any
/// thread except the haptic and world threads. Throws StoreError, AccessDenied.
std::vector<ui::InterruptedScore> score_interrupted(const std::string& store_path,
                                                    const database::Session& session,
                                                    const ui::Progress& progress = {});

}  // namespace fulcrum::app
