// SPDX-License-Identifier: GPL-3.0-or-later
// Distinguishes a recording in progress from one whose program died: an advisory lock on a small file next to
// the store, held as long as the recorder lives and let go by the kernel however it ends. The store names the
// file and its inode, so that whoever opens the store under another name (a link, another folder) asks the
// same lock. Internal to this floor.
#pragma once

#include <cstdint>
#include <string>

#include "database/store/store.h"

namespace fulcrum::database {

class RecordingLock {
  public:
    /// Takes the lock; throws StoreError read_only or disk_full if the file cannot be made.
    RecordingLock(const std::string& store_path, const std::string& attempt_id);
    ~RecordingLock();
    RecordingLock(const RecordingLock&) = delete;
    RecordingLock& operator=(const RecordingLock&) = delete;
    /// Enters it into the store; inside the transaction that begins the attempt.
    void enter(const Store& store, const std::string& attempt_id) const;
    /// Takes it out of the store; inside the transaction that ends the attempt.
    static void leave(const Store& store, const std::string& attempt_id);
    /// Lets go and removes the file; the attempt has ended.
    void release() noexcept;
    /// True while some recorder of the attempt lives, in this program or another; also where that cannot be
    /// found out (a file that may not be opened, or that is not the one that was locked). False after a
    /// restart of the machine.
    static bool is_held(const Store& store, const std::string& attempt_id);
    /// Removes what a dead recorder left.
    static void clean(const Store& store, const std::string& attempt_id) noexcept;

  private:
    std::string file_;
    std::int64_t inode_ = 0;
    int descriptor_ = -1;
};

}  // namespace fulcrum::database
