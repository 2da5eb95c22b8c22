// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/stored_start.h"

#include "app/live/performance.h"

namespace fulcrum::app {

StoredStart stored_start(const database::Attempts& attempts, const database::Session& session,
                         const database::AttemptSummary& attempt) {
    StoredStart stored{{load_recorded(attempts, session, attempt), attempt.meta.seed}};
    if (attempt.meta.origin) {
        stored.readable = attempt.meta.origin->build == state_build();
        stored.start.state = attempts.start_state(session, attempt.meta.id);
    }
    return stored;
}

}  // namespace fulcrum::app
