// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a practice attempt that no assessed attempt may use, the same on screens and on paper.
#pragma once

#include <QString>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/store/store.h"

namespace fulcrum::ui {

/// Of practice: its files that are neither part of this program nor accepted by the programme. None of an
/// assessed attempt, whose files were when it began, and of one that was recorded elsewhere. Throws
/// AccessDenied, StoreError.
std::vector<database::AssetFile> unaccepted_files(const database::Store& store,
                                                  const database::Session& session,
                                                  const database::AttemptSummary& attempt);
/// The sentence that names them; empty where there are none.
QString unaccepted_note(const std::vector<database::AssetFile>& files);

}  // namespace fulcrum::ui
