// SPDX-License-Identifier: GPL-3.0-or-later
// Who can change the store behind the program's back: whoever owns its file. Where that is the account of a
// person who practises, the audit log and the station's key are theirs too; where it is a service account of
// the system, they are out of their reach (MANUAL, Who can change the store).
#pragma once

#include <sys/types.h>

#include <string>

#include "database/store/store.h"

namespace fulcrum::database {

/// Of a file and its folder.
struct StoreOwner {
    uid_t file = 0, folder = 0;
    mode_t file_mode = 0, folder_mode = 0;
};
/// Pure: the file belongs to an account of the system (1 to 999) that is not the superuser, and nobody else
/// may write it or its folder.
bool is_service_account(const StoreOwner& owner);

/// A programme server's tables belong to a role with which nobody signs in.
bool owned_by_service_account(const Store& store);

/// The file belongs to another account than the one that runs this program. False where the file is missing.
bool belongs_to_another_account(const std::string& path);
/// Throws StoreError failed, with the account that the file belongs to and what to do.
[[noreturn]] void fail_as_of_another_account(const std::string& path);

}  // namespace fulcrum::database
