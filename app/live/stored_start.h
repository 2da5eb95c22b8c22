// SPDX-License-Identifier: GPL-3.0-or-later
// What a stored attempt began with.
#pragma once

#include "app/live/replay_player.h"
#include "database/records/attempts.h"

namespace fulcrum::app {

struct StoredStart {
    ReplayStart start;
    bool readable = true;  ///< false: it began with a state that another build wrote; only poses can be shown
};

/// Throws InputError where task or scene are not known here, AccessDenied, StoreError.
StoredStart stored_start(const database::Attempts& attempts, const database::Session& session,
                         const database::AttemptSummary& attempt);

}  // namespace fulcrum::app
