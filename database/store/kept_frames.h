// SPDX-License-Identifier: GPL-3.0-or-later
// Where the key frames of replays are kept, next to the store (docs/FORMATS.md, Key frames of replays). What
// is in the files is the business of who writes them; here they are found and removed with their attempts.
#pragma once

#include <string>

#include "database/store/store.h"

namespace fulcrum::database {

/// STORE.frames next to the store's own file, however it was named. Empty where none are kept: a programme
/// server, a store that is only read.
std::string kept_frames_folder(const Store& store);
/// Of the folder of a store at this path.
std::string kept_frames_folder(const std::string& store_path);
/// ATTEMPT.frames; empty where the id is not one that may name a file.
std::string kept_frames_name(const std::string& attempt_id);

/// Nothing here throws: frames can be made again. A folder that is a link, or another user's, is left alone.
void remove_kept_frames(const Store& store, const std::string& attempt_id) noexcept;
/// The folder with everything in it that is ours.
void remove_all_kept_frames(const std::string& store_path) noexcept;
/// Those of attempts that are no longer in the store. Returns how many files.
int remove_frames_without_attempt(const Store& store) noexcept;

}  // namespace fulcrum::database
