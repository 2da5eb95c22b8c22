// SPDX-License-Identifier: GPL-3.0-or-later
// Backups of one station in a folder, each named by its time; the oldest are removed when there are more than
// so many. Nothing else in the folder is touched: other names, other stations' backups, links, folders.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/store/store.h"

namespace fulcrum::database {

struct RotatedBackup {
    std::string path;                  ///< FOLDER/fulcrum-STATION-20261126T201500Z.db
    std::vector<std::string> removed;  ///< oldest first
};
inline constexpr int most_kept_backups = 10000;

/// Store::backup() to a new file of `folder`, which has to exist; when it is complete and checked, the oldest
/// backups of this station beyond the newest `keep` (1 to most_kept_backups) are removed, never the new one.
/// Those with a name of a later time than the new one's were written while the clock was wrong, and count as
/// the oldest. Nothing when it was stopped. Throws as Store::backup(), and StoreError (bad_value) for `keep`
/// and where `folder` is none.
std::optional<RotatedBackup> backup_into(const Store& store, const Session& session,
                                         const std::string& folder, int keep,
                                         const StoreProgress& progress = {});

}  // namespace fulcrum::database
