// SPDX-License-Identifier: GPL-3.0-or-later
// Where the key frames of a stored attempt are kept, and what record they have to belong to.
#pragma once

#include <string>

#include "app/live/frame_file.h"
#include "database/scoring/loaded_task.h"

namespace fulcrum::app {

/// `loaded` as load_recorded() gives it. Not wanted() where this store keeps none. Throws AccessDenied,
/// StoreError.
FrameKeeping frame_keeping(const database::Store& store, const database::Session& session,
                           const std::string& attempt_id, const LoadedTask& loaded);
/// Of an attempt that was finished just now; not wanted() where anything prevents it.
FrameKeeping frame_keeping(const std::string& store_path, const database::Session& session,
                           const std::string& attempt_id) noexcept;

}  // namespace fulcrum::app
