// SPDX-License-Identifier: GPL-3.0-or-later
// Which backups there are to restore. The store may be unreadable then, so where backups were written is in a
// file next to it: FILE.backups, a folder a line, the newest first.
#pragma once

#include <string>
#include <vector>

#include "database/store/store.h"

namespace fulcrum::database {

struct FoundBackup {
    std::string path;
    std::int64_t bytes = 0;
    UtcMilliseconds written = 0;  ///< of the file
    UtcMilliseconds newest = 0;   ///< of its audit log: what is later than that is not in it
    std::string programme, station_id;
    int schema = 0;
    std::int64_t people = 0, attempts = 0;  ///< real people; all attempts
    std::vector<Sentence> problems;         ///< of a quick check; a restore reads everything before
};

/// Folders to look in: that of the store, and those that backups were written to.
std::vector<std::string> backup_folders(const std::string& store_path);
/// Called for each backup. A list that cannot be written is no reason to have no backup: it stays as it is.
void note_backup_folder(const std::string& store_path, const std::string& backup_path) noexcept;

/// The copies that a backup or a migration made, the newest first, at most 50 a folder; no links, no store in
/// use or that was replaced, no copy of a damaged store. A folder that is not there has none. `progress` may
/// stop it: the list is what was found until then.
std::vector<FoundBackup> find_backups(const std::string& store_path, const std::vector<std::string>& folders,
                                      const StoreProgress& progress = {});

/// What the name of a copy ends with that nobody has checked (copy_damaged()).
inline constexpr const char* unverified_ending = "-unverified.db";

}  // namespace fulcrum::database
