// SPDX-License-Identifier: GPL-3.0-or-later
// Reads an attempt for its review, with the recording of another station where that is wanted.
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "database/access/access.h"
#include "ui/review/attempt_model.h"
#include "ui/services/application_services.h"

namespace fulcrum::ui {

/// On a worker: fetches it from the programme server where it is not in this store and the station was
/// enrolled; else does nothing. False where `progress` said to stop. Throws StoreError: unreachable, and what
/// database::fetch_trace() throws.
bool bring_trace(const std::string& store_path, const database::Session& session,
                 const std::string& attempt_id, const Progress& progress);

struct TraceElsewhere {
    QString why;             ///< empty: it is here
    bool on_server = false;  ///< another try may bring it
};

/// As load_attempt(), after bring_trace(). Where the trace cannot be had, what is known without it:
/// summary.meta.keep_trace is false then.
std::optional<AttemptModel> load_with_trace(const std::string& store_path, const database::Session& session,
                                            const std::string& attempt_id, const std::optional<Scene>& scene,
                                            const Progress& progress, TraceElsewhere& elsewhere);

}  // namespace fulcrum::ui
