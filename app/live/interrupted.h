// SPDX-License-Identifier: GPL-3.0-or-later
// What a crash, a power cut or a lost device left behind is scored from its record at the next sign-in.
#pragma once

#include <string>
#include <vector>

#include "ui/services/application_services.h"

namespace fulcrum::app {

/// Scores the interrupted attempts that the session may score and nobody has yet, oldest first; one that
/// cannot be read is left for `db check` to name and does not keep the others from their score. Opens the
/// store at `store_path` for itself. Any thread but the haptic and world threads. Throws StoreError,
/// AccessDenied.
std::vector<ui::InterruptedScore> score_interrupted(const std::string& store_path,
                                                    const database::Session& session,
                                                    const ui::Progress& progress = {});

}  // namespace fulcrum::app
