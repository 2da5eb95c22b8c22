// SPDX-License-Identifier: GPL-3.0-or-later
// Puts another file in a store's place: a backup, or the store itself brought up to this program's schema.
// The new file is made next to the store, checked from end to end, written through to the disk, and takes the
// name and the owner in one step; the old file is kept under another name. Refused while any program has the
// store open.
#pragma once

#include <functional>
#include <string>

#include "database/store/store.h"

namespace fulcrum::database {

struct Replaced {
    std::string kept;          ///< where the file that was there is now; empty: there was none
    int from_schema = 0;       ///< of the file that was read
    std::string head, before;  ///< audit heads, hex: of the file that was read; of the one that was replaced
    bool stopped = false;      ///< by `progress`, before anything was changed
};

/// Signs in to the copy before it becomes the store, and throws if that fails.
using SignInToCopy = std::function<Session(const Store& copy)>;

/// What may be at the store's place: a file that is no store may be somebody's letter under a wrong name, or
/// a store whose first page was overwritten, which the window knows from where it is.
enum class ReplacedFile { store, any };

/// The store `named` (of a link: the file that it names) becomes what the backup at `from` holds, brought
/// up to this schema; an audit row says so. Operation::backup, of the session that `sign_in` gives. Throws
/// StoreError: missing, not_a_store, newer_schema; corrupt where a check finds something (named first);
/// locked while a program has the store open; disk_full, read_only. Nothing was changed then. `progress` may
/// stop it until the file takes the store's place.
Replaced restore_store(const std::string& from, const std::string& named, const SignInToCopy& sign_in,
                       StoreOptions options = {}, const StoreProgress& progress = {},
                       ReplacedFile replaced = ReplacedFile::store);
/// Brings an older store up to this program's schema; without `kept` it had it already. Throws as above.
Replaced migrate_store(const std::string& named, StoreOptions options = {});
/// Gives the file and what is left of its log another name, FILE.damaged-TIME, and returns it; then there is
/// no store at `path`. Throws StoreError locked while a program has it open; missing, read_only.
std::string put_aside(const std::string& path, StoreOptions options = {});

}  // namespace fulcrum::database
