// SPDX-License-Identifier: GPL-3.0-or-later
// A copy of a store that does not pass its check, as it is: its name says that nobody has verified it, and no
// rotation of backups counts it.
#pragma once

#include <string>

#include "database/store/store_restore.h"

namespace fulcrum::database {

struct DamagedCopy {
    std::string path;         ///< ends in unverified_ending, whatever name was asked for
    bool by_database = true;  ///< false: SQLite cannot read it, so file and log were copied as bytes
    std::int64_t unreadable_bytes = 0;  ///< that the disk did not give; zeros are in their place
    bool stopped = false;               ///< there is no copy then
};

/// Copies the store page by page through SQLite, with what its log holds; where SQLite cannot, the bytes of
/// the file and of its log. Checks nothing. `to`: a file that does not exist, or a folder. Where the store
/// can be opened, `sign_in` gives the session (Operation::backup), and the audit log says so; where it is too
/// damaged for that, whoever may read the file may copy it. Throws StoreError exists, missing, read_only,
/// disk_full.
DamagedCopy copy_damaged(const std::string& path, const std::string& to, const SignInToCopy& sign_in,
                         const StoreProgress& progress = {});

}  // namespace fulcrum::database
